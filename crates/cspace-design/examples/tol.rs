//! trial
use cspace_design::*;
use cspace_io::{Host, model::Template};
fn main() {
    let file = std::env::args().nth(1).unwrap();
    let n: u64 = std::env::args().nth(2).map_or(0, |s| s.parse().unwrap());
    let t = Template::read(&file, &Host::default()).unwrap();
    let m = t.model(&Host::default()).unwrap();
    let b = std::time::Instant::now();
    let found = tolerances(
        &t,
        &[],
        &m,
        &ToleranceOptions {
            samples: n,
            seed: 1,
        },
        &cspace::Silent,
    )
    .unwrap();
    for f in found {
        println!(
            "{:?}\n linear {:#?}\n exact {:#?}\n structure {:#?}\n margin {:?}\n mc {:?}",
            f.nominal.measured, f.linear, f.exact, f.structure, f.margin, f.monte_carlo
        );
    }
    println!("{:?}", b.elapsed());
}

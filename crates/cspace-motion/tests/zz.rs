use cspace_motion::*;
use std::time::Instant;
#[test]
fn go() {
    let file = std::env::var("M").unwrap();
    let time: f64 = std::env::var("T").unwrap().parse().unwrap();
    let cspace_io::Document::Model(model) = cspace_io::read(std::path::Path::new(&file)).unwrap()
    else {
        panic!()
    };
    let t0 = Instant::now();
    let sim = Simulation::new(&model).unwrap();
    let t1 = Instant::now();
    let r = sim.dynamic(&Settings { time, every: None }).unwrap();
    println!("prepare {:?} run {:?}", t1 - t0, t1.elapsed());
    println!(
        "{:?} until {} {:?}\n{:?} open {:e}",
        r.status, r.until, r.reason, r.energy, r.open
    );
    println!("{} events, {} traced", r.events.len(), r.trace.len());
    let n: usize = std::env::var("N").ok().map_or(40, |n| n.parse().unwrap());
    for e in r.events.iter().take(n) {
        println!("  {:.9} {:?} {} {:?}", e.t, e.kind, e.what, e.at);
    }
    let l = r.samples.last().unwrap();
    println!("{:?}\n{:?}\n{:?}", l.coordinates, l.rates, l.forces);
}

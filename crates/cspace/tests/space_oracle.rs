//! Contact spaces against brute force.

use cspace::{ContactSpace, Options};
use cspace_oracle::{Oracle, near_contact_about, pairs};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

#[test]
fn spaces_agree_with_brute_force() {
    let mut checked = 0;
    let mut bad = Vec::new();
    for pair in pairs() {
        if pair.name == "gears 26 and 24" {
            continue;
        }
        let space = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap();
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let before = bad.len();
        let mut n = 0;
        for near in near_contact_about(&oracle, &pair.notable, &mut rng, 60) {
            let c = near.configuration;
            let slice = space.slice(c.theta);
            checked += 1;
            n += 1;
            if slice.is_free(c.position()) != near.free {
                bad.push(format!(
                    "{}: {c:?} free={} step={} margin={:?}",
                    pair.name, near.free, near.step, near.verdict
                ));
            }
        }
        let s = space.statistics();
        println!(
            "{:40} {:5} wrong of {n}; sheets {} pairs {} ev {} tri {} cl {} br {} cells {} tests {} conf {} | crit {} patches {} side {} vert {} regions {} | {:.1} ms: {:.1} {:.1} {:.1} {:.1} {:.1} {:.1} {:.1} {:.1}",
            pair.name,
            bad.len() - before,
            s.sheets,
            s.pairs,
            s.pair_events,
            s.triple_events,
            s.clusters,
            s.branches,
            s.cells,
            s.overlap_tests,
            s.conflicts,
            space.critical_orientations().len(),
            space.patches().len(),
            space.side_links().len(),
            space.vertical_links().len(),
            space.free_regions().len(),
            1e3 * s.seconds.total,
            1e3 * s.seconds.sheets,
            1e3 * s.seconds.candidates,
            1e3 * s.seconds.pair_events,
            1e3 * s.seconds.branches,
            1e3 * s.seconds.triple_events,
            1e3 * s.seconds.cells,
            1e3 * s.seconds.shells,
            1e3 * s.seconds.graph,
        );
    }
    for b in bad.iter().take(60) {
        println!("{b}");
    }
    assert!(bad.is_empty(), "{} of {checked} wrong", bad.len());
}

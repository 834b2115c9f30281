//! Events compared with crossings found by dense sampling.

use super::*;
use crate::general::events::coming::pair_events;
use crate::part::{Part, Vertex};

/// tan(90° / 4).
const QUARTER: f64 = 0.414_213_562_373_095_03;

fn rectangle(x: f64, y: f64) -> Vec<Vertex> {
    let corners = [(-x, -y), (x, -y), (x, y), (-x, y)];
    corners.map(|(x, y)| Vertex::line(x, y)).to_vec()
}

/// A rectangle whose corners are rounded.
fn rounded(x: f64, y: f64, r: f64) -> Vec<Vertex> {
    let (a, b) = (x - r, y - r);
    [
        (-a, -y, 0.0),
        (a, -y, QUARTER),
        (x, -b, 0.0),
        (x, b, QUARTER),
        (a, y, 0.0),
        (-a, y, QUARTER),
        (-x, b, 0.0),
        (-x, -b, QUARTER),
    ]
    .map(|(x, y, bulge)| Vertex { x, y, bulge })
    .to_vec()
}

/// Bulging discs and notches: arcs of either orientation, and corners.
fn lobes(size: f64) -> Vec<Vertex> {
    [
        (-1.0, -0.7, 0.3),
        (0.9, -0.8, -0.4),
        (1.3, 0.4, 0.6),
        (0.1, 1.1, 0.0),
        (-0.8, 0.6, -0.2),
    ]
    .map(|(x, y, bulge)| Vertex {
        x: size * x,
        y: size * y,
        bulge,
    })
    .to_vec()
}

/// Between two orientations without an event between them, the same curves cross.
#[test]
fn crossings_come_and_go_at_events() {
    let part = |name: &str, loops: &[Vec<Vertex>]| Part::new(name, loops.to_vec()).unwrap();
    let plate = rectangle(4.0, 3.0);
    let in_plate = |hole| vec![plate.clone(), hole];
    let pairs = [
        (in_plate(rounded(2.1, 1.1, 0.6)), rounded(2.0, 1.0, 0.5)),
        (in_plate(rounded(2.0, 1.0, 0.5)), lobes(1.0)),
        (in_plate(rounded(1.3, 1.1, 0.4)), lobes(1.0)),
        (in_plate(lobes(1.3)), rounded(1.2, 0.5, 0.3)),
        (in_plate(lobes(1.1)), lobes(1.0)),
        (vec![lobes(1.0)], rounded(0.7, 0.4, 0.1)),
        (vec![plate.clone()], rectangle(1.0, 0.5)),
    ];
    let (mut changed, mut alike) = (0, 0);
    for (fixed, moving) in pairs {
        let geometry = Geometry::new(
            &part("fixed", &fixed),
            &part("moving", &[moving]),
            None,
            usize::MAX,
        );
        let contacts = &geometry.contacts;
        let sheets = &contacts.sheets;
        let names = 0..sheets.len() as u32;
        let all = names
            .clone()
            .flat_map(|i| names.clone().map(move |j| (i, j)));
        for (first, second) in all.filter(|(i, j)| i < j) {
            let (f, g) = (&sheets[first as usize], &sheets[second as usize]);
            let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
            if hi - lo < 1e-6 || f.shared_ends(g, contacts.first_vertex_name).tangent {
                continue;
            }
            let run = PairRun {
                first,
                second,
                lo: Exact::from(lo),
                hi: Exact::from(hi),
            };
            let found = pair_events(&geometry, &[run]);
            let events = found.of(0);
            const STEPS: usize = 100;
            let mut looked: Vec<f64> = (0..STEPS)
                .map(|k| lo + (hi - lo) * (k as f64 + 0.5) / STEPS as f64)
                .collect();
            for e in events {
                let theta = e.theta.to_f64();
                looked.extend(
                    [1e-3, 1e-5, 1e-7, 1e-8]
                        .iter()
                        .flat_map(|d| [theta - d, theta + d]),
                );
            }
            looked.retain(|t| (lo + 1e-9..hi - 1e-9).contains(t));
            looked.sort_by(f64::total_cmp);
            let now: Vec<_> = looked
                .iter()
                .map(|&t| crossings_between(&geometry, &run, t))
                .collect();
            // Double-double and f64 agree away from events.
            let near = |t: f64| events.iter().any(|e| (e.theta.to_f64() - t).abs() < 1e-6);
            let clear = (looked.iter().zip(&now)).filter(|(t, _)| !near(**t));
            for (&t, c) in clear.step_by(4) {
                let exact = exact_crossings_between(&geometry, &run, Exact::from(t));
                assert_eq!(exact, *c, "{f:?} {g:?} {t}");
                alike += 1;
            }
            for (t, c) in looked.windows(2).zip(now.windows(2)) {
                if c[0] != c[1] {
                    changed += 1;
                    let [before, after] = [t[0], t[1]].map(Exact::from);
                    let between = |e: &Moment| before <= e.theta && e.theta <= after;
                    assert!(
                        events.iter().any(between),
                        "{f:?} {g:?} {t:?} {c:?} {events:?}"
                    );
                }
            }
        }
    }
    assert!(changed > 300 && alike > 5_000, "{changed} {alike}");
}

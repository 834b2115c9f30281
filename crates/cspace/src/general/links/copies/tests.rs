//! Copies of chains compared with their definition: every shift is tried and its interval cut with the window.

use super::*;
use crate::contact::Exact;
use crate::general::events::clusters::Moment;

const SLABS: u32 = 3;
const PERIOD: f64 = TAU / 3.0;
/// Orientations of the clusters of a period; the last is the first of the next.
const PHASES: [f64; 4] = [-3.1, -2.5, -1.7, -3.1 + PERIOD];
/// A full turn, a window wider than a period, a part of a turn, and a window narrower than the period.
const WINDOWS: [Window; 4] = [
    window(-PI, PI, true),
    window(-4.0, 5.5, false),
    window(-1.2, 3.3, false),
    window(-2.6, -2.3, false),
];

const fn window(lo: f64, hi: f64, full_turn: bool) -> Window {
    Window { lo, hi, full_turn }
}

fn clusters() -> Clusters {
    let event = |theta: f64| Moment {
        theta: Exact::from(theta),
        error: 0.0,
    };
    Clusters::new(PHASES.map(event))
}

fn steps() -> Steps {
    Steps::new(1, SLABS).unwrap()
}

const fn place(cluster: u32, slabs: i64) -> ClusterInPeriod {
    ClusterInPeriod {
        cluster,
        slabs: slabs as i32,
    }
}

fn at(p: ClusterInPeriod) -> f64 {
    PHASES[p.cluster as usize] + f64::from(p.slabs) * PERIOD
}

/// A chain from one place to another.
fn chain(from: ClusterInPeriod, to: ClusterInPeriod, closed: bool) -> Chain {
    Chain {
        first: 0,
        last: 0,
        from,
        to,
        lo: at(from),
        hi: at(to),
        closed,
    }
}

/// Chains within a period, to its end, beyond it, over more than one, and around the turn.
fn chains() -> Vec<Chain> {
    vec![
        chain(place(0, 0), place(1, 0), false),
        chain(place(1, 0), place(3, 0), false),
        chain(place(2, 0), place(1, 1), false),
        chain(place(1, 0), place(2, 2), false),
        chain(place(0, 0), place(3, 2), true),
    ]
}

/// Difference of two orientations modulo a turn.
fn apart(a: f64, b: f64) -> f64 {
    ((a - b) - TAU * ((a - b) / TAU).round()).abs()
}

/// The shifts with which an interval overlaps the window, tried one by one.
fn shifts_by_trial(lo: f64, hi: f64, window: Window) -> Vec<i64> {
    (-30..30)
        .filter(|&k| {
            let by = k as f64 * PERIOD;
            (hi + by).min(window.hi) - (lo + by).max(window.lo) > NARROWEST_BAND
        })
        .collect()
}

#[test]
fn copies_are_those_that_the_window_has_room_for() {
    let (clusters, chains) = (clusters(), chains());
    for window in WINDOWS {
        let lifts = Lifts::new(&chains, window, steps(), true, &clusters);
        let mut numbers = Vec::new();
        for (c, chain) in (0u32..).zip(&chains) {
            let copies: Vec<(i64, u32)> = lifts.patches(c).collect();
            let shifts: Vec<i64> = copies.iter().map(|c| c.0).collect();
            if window.full_turn || chain.closed {
                assert_eq!(shifts, [0, 1, 2]);
            } else {
                assert_eq!(shifts, shifts_by_trial(chain.lo, chain.hi, window));
                let all: Vec<i64> = lifts.shifts(chain.lo, chain.hi).collect();
                assert_eq!(all, shifts);
            }
            let around = window.full_turn || chain.closed;
            for k in -9..9 {
                let same = |s: i64| s == k || around && (s - k) % i64::from(SLABS) == 0;
                let expected = copies.iter().find(|c| same(c.0)).map(|c| c.1);
                assert_eq!(lifts.patch(c, k), expected, "{window:?} {chain:?} {k}");
            }
            for &(slabs, patch) in &copies {
                assert_eq!(lifts.chain_of(patch), (c, slabs));
            }
            numbers.extend(copies.iter().map(|c| c.1));
        }
        assert!(numbers.into_iter().eq(0..lifts.len() as u32));
    }
}

#[test]
fn orientations_are_phases_some_slabs_further() {
    let (clusters, chains) = (clusters(), chains());
    for window in WINDOWS {
        let lifts = Lifts::new(&chains, window, steps(), true, &clusters);
        for cluster in 0..4 {
            for (slabs, up) in (-3..5).flat_map(|s| (-3..4).map(move |k| (s, k))) {
                let theta = lifts.orientation(place(cluster, slabs), up);
                let expected = PHASES[cluster as usize] + (slabs + up) as f64 * PERIOD;
                if window.full_turn {
                    assert!((-PI..PI).contains(&theta) && apart(theta, expected) < 1e-14);
                } else {
                    assert!((theta - expected).abs() < 1e-14);
                }
                // The orientation is equal to the last bit, from whichever period it is counted.
                assert_eq!(lifts.orientation(place(cluster, slabs + 1), up - 1), theta);
            }
        }
        for up in -40..40 {
            let (end, start) = (place(3, 0), place(0, 0));
            assert_eq!(lifts.orientation(end, up), lifts.orientation(start, up + 1));
        }
    }
}

#[test]
fn intervals_are_cut_by_the_window() {
    let (clusters, chains) = (clusters(), chains());
    for window in WINDOWS {
        let lifts = Lifts::new(&chains, window, steps(), true, &clusters);
        for (c, chain) in (0u32..).zip(&chains) {
            for (slabs, _) in lifts.patches(c) {
                let by = slabs as f64 * PERIOD;
                let (lo, hi) = lifts.interval(chain, slabs);
                let (a, b) = (chain.lo + by, chain.hi + by);
                if window.full_turn {
                    assert!(apart(lo, a) < 1e-14 && ((hi - lo) - (b - a)).abs() < 1e-14);
                    assert!((-PI..PI).contains(&lo));
                } else {
                    let (a, b) = if chain.closed { (-9.0, 9.0) } else { (a, b) };
                    assert!((lo - a.max(window.lo)).abs() < 1e-14);
                    assert!((hi - b.min(window.hi)).abs() < 1e-14);
                }
                let whole = window.full_turn || !chain.closed && window.lo < a && b < window.hi;
                assert_eq!(lifts.is_whole(chain, slabs), whole);
            }
        }
        // An interval that ends nearly at the window's end ends there.
        let hair = 0.5 * NARROWEST_BAND;
        let (lo, hi) = lifts.clipped(window.lo + hair, window.hi - hair);
        let (beside_lo, beside_hi) = (
            window.lo + 2.0 * NARROWEST_BAND,
            window.hi - 2.0 * NARROWEST_BAND,
        );
        assert_eq!(lifts.clipped(beside_lo, beside_hi), (beside_lo, beside_hi));
        assert!(lifts.is_inside(beside_lo) && lifts.is_inside(beside_hi));
        if !window.full_turn {
            assert_eq!((lo, hi), (window.lo, window.hi));
            assert!(!lifts.is_inside(window.lo + hair) && !lifts.is_inside(window.hi - hair));
        }
    }
}

#[test]
fn critical_orientations_are_the_ends_of_copies_within() {
    let (clusters, chains) = (clusters(), chains());
    for window in WINDOWS {
        let lifts = Lifts::new(&chains, window, steps(), true, &clusters);
        // Chains begin and end at three phases of each slab.
        let mut expected: Vec<f64> = (-9..9)
            .flat_map(|k| (0..3).map(move |i| PHASES[i] + f64::from(k) * PERIOD))
            .filter(|t| window.lo < *t && *t < window.hi)
            .collect();
        expected.sort_by(f64::total_cmp);
        let found = lifts.critical_orientations(&chains);
        assert_eq!(found.len(), expected.len());
        assert!(
            found
                .iter()
                .zip(&expected)
                .all(|(a, b)| (a - b).abs() < 1e-14)
        );
        assert_eq!(lifts.computed_bands(&chains, 99), 3);
        assert_eq!(lifts.computed_bands(&chains[..1], 99), 2);
        assert_eq!(lifts.computed_bands(&chains[4..], 99), 1);
        let begins = [
            chain(place(0, 0), place(1, 0), false),
            chain(place(2, 0), place(1, 1), false),
        ];
        assert_eq!(lifts.computed_bands(&begins, 99), 3);
    }
}

/// A window computed without symmetry: one copy of each chain that overlaps it, and no shift.
#[test]
fn a_window_that_does_not_repeat_is_not_copied() {
    let (clusters, chains) = (clusters(), chains());
    let window = window(-2.4, 2.0, false);
    let lifts = Lifts::new(&chains, window, steps(), false, &clusters);
    for (c, chain) in (0u32..).zip(&chains).filter(|(_, c)| !c.closed) {
        let inside = chain.hi > window.lo;
        let copies: Vec<i64> = lifts.patches(c).map(|c| c.0).collect();
        assert_eq!(copies, vec![0; usize::from(inside)]);
        let hi = clusters.at(chain.to.cluster);
        let lo = clusters.at(chain.from.cluster);
        assert_eq!(lifts.orientation(chain.from, 5), lo);
        assert_eq!(
            lifts.interval(chain, 0),
            (lo.max(window.lo), hi.min(window.hi))
        );
    }
    assert_eq!(lifts.computed_bands(&chains, 99), 99);
    assert_eq!(lifts.near(1.0, 1.0 + TAU), 1.0);
    let turn = Lifts::new(&chains, WINDOWS[0], steps(), true, &clusters);
    assert!((turn.near(1.0, 0.8 + 2.0 * TAU) - 1.0 - 2.0 * TAU).abs() < 1e-14);
}

#[test]
fn half_a_turn_is_the_first_orientation() {
    for (theta, home) in [
        (0.5, 0.5),
        (0.5 + TAU, 0.5),
        (4.0, 4.0 - TAU),
        (-4.0 - TAU, TAU - 4.0),
        (PI - 1e-9, PI - 1e-9),
        (1e-16, 1e-16),
    ] {
        assert!((normalized(theta) - home).abs() < 1e-14, "{theta}");
    }
    let hair = 4.0 * f64::EPSILON;
    for theta in [PI, -PI, PI - hair, -PI - hair, -PI + hair, 3.0 * PI] {
        assert_eq!(normalized(theta), -PI, "{theta}");
    }
}

/// In a window narrower than two narrowest bands, a copy counts if more than half of the window is in it.
#[test]
fn a_copy_has_more_than_the_narrowest_band_in_the_window() {
    let (clusters, chains) = (clusters(), chains());
    let (lo, hi) = (chains[0].lo, chains[0].hi);
    let narrow = 0.05 * NARROWEST_BAND;
    for (window, copies) in [
        (window(hi - 0.5 * NARROWEST_BAND, -1.1, false), 0),
        (window(hi - 2.0 * NARROWEST_BAND, -1.1, false), 1),
        (window(-3.6, lo + 0.5 * NARROWEST_BAND, false), 0),
        (window(-3.6, lo + 2.0 * NARROWEST_BAND, false), 1),
        (window(hi - 0.8 * narrow, hi + 0.2 * narrow, false), 1),
        (window(hi - 0.2 * narrow, hi + 0.8 * narrow, false), 0),
    ] {
        let lifts = Lifts::new(&chains[..1], window, steps(), true, &clusters);
        assert_eq!(lifts.len(), copies, "{window:?}");
    }
}

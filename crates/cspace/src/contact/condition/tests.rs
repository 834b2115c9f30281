//! Conditions against the distances that they say vanish.

use super::super::sheet::tests::{round, straight};
use super::*;
use crate::geometry::{Rotation, Vector};

fn spiral(u: (f64, f64), w: (f64, f64)) -> Spiral {
    Spiral {
        u: Point::new(u.0, u.1),
        w: Vector::new(w.0, w.1),
    }
}

/// A fixed line, a turning one, and two circles, with ends that are in general position.
fn sheets() -> [Sheet; 4] {
    let ends = |sheet: Sheet, start, end| Sheet {
        start,
        end,
        ..sheet
    };
    let (a, b) = (
        spiral((0.1, 0.3), (0.4, -0.2)),
        spiral((-0.3, 0.2), (0.1, 0.5)),
    );
    let (c, d) = (
        spiral((0.2, -0.4), (-0.3, 0.1)),
        spiral((0.5, 0.0), (0.2, 0.2)),
    );
    [
        ends(straight(0, SheetKind::LineRound, 0.7, a), a, b),
        ends(straight(1, SheetKind::RoundLine, 2.1, b), b, c),
        ends(round(2, (0.2, 0.1), (-0.1, 0.2), 0.6), c, d),
        ends(round(3, (-0.2, 0.0), (0.1, 0.3), -0.4), d, a),
    ]
}

/// The distance of a point from a carrier.
fn off(p: Point, sheet: &Sheet, turn: Rotation) -> f64 {
    if sheet.is_circle() {
        p.distance(sheet.center().at(turn)) - sheet.radius.abs()
    } else {
        sheet.normal_at(turn).dot(p - sheet.start.at(turn))
    }
}

/// All that vanishes where crossings come or go: ends on carriers, unless they are shared, and carriers that are tangent.
fn vanishing(f: &Sheet, g: &Sheet, shared: [bool; 2], turn: Rotation) -> Vec<f64> {
    let mut all = Vec::new();
    let [end, start] = shared;
    if !start {
        all.extend([off(f.start.at(turn), g, turn), off(g.end.at(turn), f, turn)]);
    }
    if !end {
        all.extend([off(f.end.at(turn), g, turn), off(g.start.at(turn), f, turn)]);
    }
    for (f, g) in [(f, g), (g, f)] {
        if !f.is_circle() && g.is_circle() {
            let height = off(g.center().at(turn), f, turn);
            all.extend([height - g.radius, height + g.radius]);
        }
    }
    if f.is_circle() && g.is_circle() {
        let apart = f.center().at(turn).distance(g.center().at(turn));
        let (r, s) = (f.radius.abs(), g.radius.abs());
        all.extend([apart - (r + s), apart - (r - s).abs()]);
    }
    all
}

#[test]
fn conditions_vanish_where_distances_do() {
    let sheets = sheets();
    let mut seen = 0;
    for (f, g) in sheets
        .iter()
        .flat_map(|f| sheets.iter().map(move |g| (f, g)))
    {
        if f.fixed == g.fixed {
            continue;
        }
        for corners in [[false, false], [true, false], [false, true], [true, true]] {
            let shared = SharedEnds {
                tangent: false,
                corners: corners.map(|c| c.then_some(f.start)),
            };
            let mut found = Vec::new();
            conditions(f, g, &shared, |t| found.push(t));
            let zero = vanishing(f, g, corners, Rotation::IDENTITY);
            assert_eq!(found.len(), zero.len());
            // Where one changes its sign, so does the other: each condition has the roots of a distance of its own.
            const STEPS: usize = 4000;
            let turns: Vec<(f64, Rotation)> = (0..=STEPS)
                .map(|k| core::f64::consts::TAU * k as f64 / STEPS as f64)
                .map(|t| (t, Rotation::by(t)))
                .collect();
            let changes = |values: Vec<f64>| -> Vec<usize> {
                (1..values.len())
                    .filter(|&k| values[k] * values[k - 1] <= 0.0)
                    .collect()
            };
            let mut by_distance: Vec<Vec<usize>> = (0..zero.len())
                .map(|i| {
                    changes(
                        turns
                            .iter()
                            .map(|&(_, r)| vanishing(f, g, corners, r)[i])
                            .collect(),
                    )
                })
                .collect();
            let mut by_condition: Vec<Vec<usize>> = found
                .iter()
                .map(|t| {
                    changes(
                        turns
                            .iter()
                            .map(|&(_, r)| t.alpha * r.cos + t.beta * r.sin + t.gamma)
                            .collect(),
                    )
                })
                .collect();
            by_distance.sort();
            by_condition.sort();
            assert_eq!(by_condition, by_distance);
            seen += by_distance.iter().map(Vec::len).sum::<usize>();
        }
    }
    assert!(seen > 100, "{seen}");
}

/// The largest and the least value are A + γ and γ − A, known to a small multiple of rounding, and the scale bounds
/// the coefficients.
#[test]
fn extremes_are_known_from_lengths() {
    let sheets = sheets();
    for (f, g) in sheets
        .iter()
        .flat_map(|f| sheets.iter().map(move |g| (f, g)))
    {
        if f.fixed == g.fixed {
            continue;
        }
        let shared = SharedEnds {
            tangent: false,
            corners: [None; 2],
        };
        conditions(f, g, &shared, |t| {
            let amplitude = t.alpha.hypot(t.beta);
            for (known, value) in [
                (t.most, amplitude + t.gamma),
                (t.least, amplitude - t.gamma),
            ] {
                assert!((known.value - value).abs() < 1e-14, "{t:?}");
                assert!((1e-16..3e-14).contains(&known.error), "{t:?}");
            }
            assert!(t.scale >= t.alpha.abs().max(t.beta.abs()).max(t.gamma.abs()));
            assert!(t.scale < 40.0);
        });
    }
}

//! Conditions against the distances that they say vanish.

use super::super::sheet::tests::{round, straight};
use super::*;
use crate::geometry::{Rotation, Vector};

fn spiral(u: (f64, f64), w: (f64, f64)) -> Spiral {
    Spiral::new(Point::new(u.0, u.1), Vector::new(w.0, w.1))
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
            const STEPS: usize = 2000;
            let turns: Vec<Rotation> = (0..=STEPS)
                .map(|k| Rotation::by(core::f64::consts::TAU * k as f64 / STEPS as f64))
                .collect();
            let distances: Vec<Vec<f64>> =
                (turns.iter().map(|&r| vanishing(f, g, corners, r))).collect();
            let changes = |value: &dyn Fn(usize) -> f64| -> Vec<usize> {
                (1..=STEPS)
                    .filter(|&k| value(k) * value(k - 1) <= 0.0)
                    .collect()
            };
            let mut by_distance: Vec<Vec<usize>> = (0..zero.len())
                .map(|i| changes(&|k| distances[k][i]))
                .collect();
            let mut by_condition: Vec<Vec<usize>> = (found.iter())
                .map(|t| changes(&|k| t.alpha * turns[k].cos + t.beta * turns[k].sin + t.gamma))
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

/// Twice the lengths have twice the error, and their squares four times; rounding of every length is in it.
#[test]
fn errors_grow_with_lengths() {
    let scaled = |s: Spiral, by: f64| Spiral::new(Point::ORIGIN + s.u.to_vector() * by, s.w * by);
    let (p, q) = (
        spiral((0.7, 0.3), (0.4, -0.2)),
        spiral((-0.3, 0.2), (0.1, 0.5)),
    );
    let errors = |by: f64| {
        let (p, q) = (scaled(p, by), scaled(q, by));
        let high = height(&p, &straight(0, SheetKind::LineRound, 0.7, q), 0.3 * by);
        let far = apart(&p, &q, 0.3 * by);
        for known in [high.most, high.least, far.most, far.least] {
            let lengths = size(&p) + size(&q) + 0.3 * by;
            // One rounding for every length, of a square beside the other length.
            let least = f64::EPSILON
                * if known == high.most || known == high.least {
                    lengths
                } else {
                    lengths * known.value.abs().sqrt()
                };
            assert!(known.error > least, "{known:?} {least}");
        }
        let errors = [high.most, high.least, far.most, far.least].map(|k| k.error);
        (errors, [high.scale, far.scale])
    };
    let (one, two) = (errors(1.0), errors(2.0));
    for (i, times) in [2.0, 2.0, 4.0, 4.0].into_iter().enumerate() {
        assert!((two.0[i] / one.0[i] - times).abs() < 1e-9, "{i}");
    }
    assert_eq!(two.1, one.1.map(|scale| 2.0 * scale));
}

/// Absolute values that are added up in a coefficient, at their largest and where lengths are alike.
#[test]
fn scales_bound_what_is_added_up() {
    for (a, b, d) in [
        (3.9, 3.9, 0.3),
        (3.9, 0.1, 1.9),
        (0.1, 3.9, 1.9),
        (0.5, 0.5, 0.1),
    ] {
        let (p, q) = (spiral((a, 0.0), (0.0, b)), spiral((0.0, 0.0), (0.0, 0.0)));
        let scale = apart(&p, &q, d).scale;
        assert!(
            scale >= (a * a + b * b + d * d).max(2.0 * a * b),
            "{a} {b} {d}"
        );
        let line = straight(0, SheetKind::LineRound, 0.7, q);
        let scale = height(&p, &line, d).scale;
        assert!(scale >= a + b + d);
    }
}

//! Conditions compared with the distances that they represent.

use super::super::carrier::SheetKind;
use super::super::locus::tests::{exact, geometry, pairs};
use super::super::sheet::Sheet;
use super::super::sheet::tests::{round, straight};
use super::super::tangent::tests::plain;
use super::*;
use crate::geometry::{Point, Rotation};
use crate::number::Dd;
use core::f64::consts::{FRAC_PI_2, PI};

fn spiral(u: (f64, f64), w: (f64, f64)) -> Spiral {
    Spiral::new(Point::new(u.0, u.1), Vector::new(w.0, w.1))
}

/// A fixed line, a turning one, and two circles, with ends that are in general position.
fn sheets() -> [Sheet; 4] {
    let ends = |mut sheet: Sheet, start, end| {
        (sheet.locus.start, sheet.locus.end) = (start, end);
        sheet
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
        p.distance(sheet.locus.carrier.through.at(turn)) - sheet.locus.carrier.radius.abs()
    } else {
        sheet
            .locus
            .carrier
            .normal_at(turn)
            .dot(p - sheet.locus.start.at(turn))
    }
}

/// All distances that vanish where crossings appear or disappear: of ends from carriers, unless they are shared, and of carriers from
/// tangency.
fn vanishing(f: &Sheet, g: &Sheet, shared: [bool; 2], turn: Rotation) -> Vec<f64> {
    let mut all = Vec::new();
    let [end, start] = shared;
    if !start {
        all.extend([
            off(f.locus.start.at(turn), g, turn),
            off(g.locus.end.at(turn), f, turn),
        ]);
    }
    if !end {
        all.extend([
            off(f.locus.end.at(turn), g, turn),
            off(g.locus.start.at(turn), f, turn),
        ]);
    }
    for (f, g) in [(f, g), (g, f)] {
        if !f.is_circle() && g.is_circle() {
            let height = off(g.locus.carrier.through.at(turn), f, turn);
            all.extend([
                height - g.locus.carrier.radius,
                height + g.locus.carrier.radius,
            ]);
        }
    }
    if f.is_circle() && g.is_circle() {
        let apart = f
            .locus
            .carrier
            .through
            .at(turn)
            .distance(g.locus.carrier.through.at(turn));
        let (r, s) = (f.locus.carrier.radius.abs(), g.locus.carrier.radius.abs());
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
            let mut found = Vec::new();
            conditions(&f.locus, &g.locus, corners, |_| true, |_, t| found.push(t));
            let zero = vanishing(f, g, corners, Rotation::IDENTITY);
            assert_eq!(found.len(), zero.len());
            // Where one changes its sign, so does the other: each condition has the roots of its distance.
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

/// The largest and the smallest value are A + γ and γ − A, known to a small multiple of rounding, and the scale bounds the coefficients.
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
        conditions(
            &f.locus,
            &g.locus,
            [false; 2],
            |_| true,
            |_, t| {
                let amplitude = t.alpha.hypot(t.beta);
                for (known, value) in [
                    (t.extremes()[0], amplitude + t.gamma),
                    (t.extremes()[1], amplitude - t.gamma),
                ] {
                    assert!((known.0 - value).abs() < 1e-14, "{t:?}");
                    assert!((1e-16..3e-14).contains(&known.1), "{t:?}");
                }
                assert!(t.scale >= t.alpha.abs().max(t.beta.abs()).max(t.gamma.abs()));
                assert!(t.scale < 40.0);
            },
        );
    }
}

/// Lengths twice as large have twice the error, and their squares four times; the rounding of every length is included.
#[test]
fn errors_grow_with_lengths() {
    let scaled = |s: Spiral, by: f64| Spiral::new(Point::ORIGIN + s.u.to_vector() * by, s.w * by);
    let (p, q) = (
        spiral((0.7, 0.3), (0.4, -0.2)),
        spiral((-0.3, 0.2), (0.1, 0.5)),
    );
    let errors = |by: f64| {
        let (p, q) = (scaled(p, by), scaled(q, by));
        let high = height(
            &p,
            &straight(0, SheetKind::LineRound, 0.7, q).locus.carrier,
            0.3 * by,
        );
        let far = apart(&p, &q, 0.3 * by);
        let ([a, b], [c, d]) = (high.extremes(), far.extremes());
        let lengths = size_of(&p) + size_of(&q) + 0.3 * by;
        for (known, of) in [
            (a, lengths),
            (b, lengths),
            // One rounding for every length, from a square beside the other length.
            (c, lengths * c.0.abs().sqrt()),
            (d, lengths * d.0.abs().sqrt()),
        ] {
            assert!(known.1 > f64::EPSILON * of, "{known:?}");
        }
        let errors = [a, b, c, d].map(|k| k.1);
        (errors, [high.scale, far.scale])
    };
    let (one, two) = (errors(1.0), errors(2.0));
    for (i, times) in [2.0, 2.0, 4.0, 4.0].into_iter().enumerate() {
        assert!((two.0[i] / one.0[i] - times).abs() < 1e-9, "{i}");
    }
    // A height is a length; a condition of distance is a square.
    assert_eq!(two.1, [2.0 * one.1[0], 4.0 * one.1[1]]);
}

/// Sums of absolute values in a coefficient, at their largest and where lengths are similar.
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
        let scale = height(&p, &line.locus.carrier, d).scale;
        assert!(scale >= a + b + d);
    }
}

/// Conditions in double-double have the roots of those in f64, also by their numbers; and these roots are found by refinement.
#[test]
fn exact_conditions_are_those_of_doubles() {
    let geometry = geometry();
    let (mut compared, mut flat) = (0, 0);
    for (f, g, (lo, hi), corners) in pairs(&geometry) {
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let mut theirs = Vec::new();
        let (p, q) = (plain(f).locus, plain(g).locus);
        conditions(
            &p,
            &q,
            corners,
            |_| true,
            |_, t| {
                let mut roots = Vec::new();
                t.roots(mid, mid.cos(), mid.sin(), half, |e| roots.push(e));
                theirs.push(roots);
            },
        );
        let (x, y) = (exact(&geometry, f), exact(&geometry, g));
        conditions(
            &x,
            &y,
            corners,
            |n| n != 1,
            |number, t| {
                let mut ours = Vec::new();
                t.exact_roots(|theta, error| {
                    let turns = ((theta.to_f64() - mid) / core::f64::consts::TAU).round();
                    ours.push((theta - Dd::TAU * turns, error));
                });
                // Roots that are known well, and not at the very end, are found by both.
                let known = theirs[number]
                    .iter()
                    .filter(|e| e.error < 1e-10 && (e.theta - mid).abs() < half - 1e-8);
                for e in known {
                    compared += 1;
                    flat += usize::from(f.is_flat() || g.is_flat());
                    let near = |o: &&(Dd, f64)| (o.0.to_f64() - e.theta).abs() < 1e-9;
                    let (theta, error) = *ours.iter().find(near).unwrap();
                    assert!(error < 1e-24, "{error} {f:?} {g:?}");
                    if t.is_simple(theta.to_f64() + 1e-13, 1e-11) {
                        let (again, e) = t.root_near(theta.to_f64() + 1e-13);
                        assert!((again - theta).to_f64().abs() <= e + error && e < 1e-24);
                    }
                }
                let clear =
                    |o: &&(Dd, f64)| o.1 < 1e-26 && (o.0.to_f64() - mid).abs() < half - 1e-8;
                for (theta, _) in ours.iter().filter(clear) {
                    let near = (theirs[number].iter())
                        .any(|e| (theta.to_f64() - e.theta).abs() < 1e-9 + 2.0 * e.error);
                    assert!(near, "{theta:?} {f:?} {g:?}");
                }
            },
        );
        let mut taken = Vec::new();
        conditions(&x, &y, corners, |n| n != 1, |number, _| taken.push(number));
        let asked: Vec<usize> = (0..theirs.len()).filter(|&n| n != 1).collect();
        assert_eq!(taken, asked);
    }
    // For large circles about their centres f64 has few digits.
    assert!(compared > 400 && flat > 200, "{compared} {flat}");
}

fn exactly(x: f64, y: f64) -> Vector<Dd> {
    Vector::new(x, y).map(Dd::from)
}

fn exact_spiral(u: Vector<Dd>, w: Vector<Dd>) -> Spiral<Dd> {
    Spiral::new(Point::new(u.x, u.y), w)
}

/// The height of a point over a line through another whose normal is upwards.
fn over(point: &Spiral<Dd>, through: Spiral<Dd>) -> Trig<Dd> {
    let line = Carrier {
        kind: SheetKind::LineRound,
        through,
        normal: exactly(0.0, 1.0),
        radius: Dd::ZERO,
    };
    height(point, &line, Dd::ZERO)
}

/// The height of a point that goes around a circle over a line: size sin θ − h.
fn high(size: f64, h: Dd) -> Trig<Dd> {
    let none = exactly(0.0, 0.0);
    let point = exact_spiral(none, exactly(size, 0.0));
    over(&point, exact_spiral(Vector::new(Dd::ZERO, h), none))
}

/// The roots of a condition in rising order.
fn roots_of(c: &Trig<Dd>) -> Vec<(Dd, f64)> {
    let mut found = Vec::new();
    c.exact_roots(|theta, error| found.push((theta, error)));
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

fn value(c: &Trig<Dd>, theta: Dd) -> Dd {
    let (sin, cos) = theta.sin_cos();
    c.alpha * cos + c.beta * sin + c.gamma
}

/// A condition passes zero within the reported error, which beside a double root is the square root of the rounding.
#[test]
fn roots_are_where_they_are_told_to_be() {
    // 1 − h, and the smallest and the largest expected error, in units of rounding.
    for (less, least, largest) in [
        (0.7, 1.0, 1e3),
        (1.9, 1.0, 1e3),
        (1e-4, 1e3, 1e5),
        (1e-10, 1e5, 1e8),
        (1e-20, 1e11, 1e13),
        (1e-27, 1e14, 1e16),
    ] {
        let c = high(1.0, Dd::ONE - less);
        let roots = roots_of(&c);
        assert_eq!(roots.len(), 2, "{less}");
        for &(theta, error) in &roots {
            let [before, after] = [theta - error, theta + error].map(|t| value(&c, t));
            assert_ne!(before.is_negative(), after.is_negative(), "{less}");
            let units = error / Dd::EPSILON;
            assert!((least..largest).contains(&units), "{less} {units}");
        }
        // The roots are at equal distances from a quarter turn.
        let sum = (roots[0].0 + roots[1].0 - Dd::PI).to_f64();
        let turns = (sum / (2.0 * PI)).round();
        assert!((sum - 2.0 * PI * turns).abs() < 1e-15, "{less} {sum}");
    }
    // A point that stays clear of the line, or only touches it, has no root, and neither has one that does not move.
    for h in [1.0, -1.0, 1.0 + 1e-12, -1.0 - 1e-9, 1.5] {
        assert!(roots_of(&high(1.0, Dd::from(h))).is_empty(), "{h}");
    }
    for h in [Dd::ZERO, Dd::from(1e-33), Dd::from(0.3)] {
        assert!(roots_of(&high(0.0, h)).is_empty());
    }
}

/// A point at a distance of one that moves on a circle is at a distance from another according to the triangle of the three; and for
/// circles of nearly one radius the differences of lengths are accurate.
#[test]
fn distances_are_known_as_lengths_are() {
    let spiral = |u: (f64, f64), w: (f64, f64)| exact_spiral(exactly(u.0, u.1), exactly(w.0, w.1));
    for (from, distance) in [(1.0, 0.5), (2.0, 1.5), (1e-3, 1.0)] {
        let (p, q) = (
            spiral((0.0, 0.0), (1.0, 0.0)),
            spiral((from, 0.0), (0.0, 0.0)),
        );
        let distance = Dd::from(distance);
        let roots = roots_of(&apart(&p, &q, distance));
        assert_eq!(roots.len(), 2, "{from}");
        for (theta, error) in roots {
            let turn = Rotation::by(theta);
            let off = (p.at(turn) - q.at(turn)).length() - distance;
            assert!(off.to_f64().abs() < 8.0 * error + 1e-30, "{off:?} {error}");
            assert!(error < 1e-24, "{error}");
        }
    }
    // The centres are at most 2 d apart, with the distance d, wherever the centres are.
    let d = 1e-12;
    let (p, q) = (
        spiral((0.7, 0.3), (d, 0.0)),
        spiral((0.7 + d, 0.3), (0.0, 0.0)),
    );
    let roots = roots_of(&apart(&p, &q, (Dd::from(0.7 + d) - 0.7).abs()));
    assert_eq!(roots.len(), 2);
    for (theta, error) in roots {
        // A sixth of a turn, to the accuracy of d.
        assert!((theta.to_f64().cos() - 0.5).abs() < 1e-3, "{theta:?}");
        assert!(error < 1e-15, "{error}");
    }
}

/// A root found in f64 is refined to the exact one; near a double root, or off the root, it is rejected.
#[test]
fn a_root_is_refined_where_it_is_simple() {
    /// Largest error of a root in f64 (radians).
    const NEAR: f64 = 1e-11;
    for less in [0.3, 1.0, 1.7] {
        let c = high(1.0, Dd::ONE - less);
        for (theta, error) in roots_of(&c) {
            for off in [0.0, 1e-12, -1e-11] {
                let near = theta.to_f64() + off;
                assert!(c.is_simple(near, NEAR), "{less}");
                let (root, e) = c.root_near(near);
                assert!((root - theta).to_f64().abs() <= error + e, "{less} {off}");
                assert!(e < 1e-26, "{e}");
            }
            assert!(!c.is_simple(theta.to_f64() + 1e-9, NEAR));
        }
    }
    let c = high(1.0, Dd::ONE - 1e-8);
    assert!(
        roots_of(&c)
            .iter()
            .all(|r| !c.is_simple(r.0.to_f64(), NEAR))
    );
    assert!(!high(1.0, Dd::ONE).is_simple(FRAC_PI_2, NEAR));
    // A small moving term beside a large constant one has a larger error.
    let c = high(1e-6, Dd::ZERO);
    assert!(c.is_simple(0.0, NEAR));
    let far = exact_spiral(exactly(3.0, 1.0), exactly(0.0, 0.0));
    let point = Spiral {
        w: exactly(1e-6, 0.0),
        ..far
    };
    assert!(!over(&point, far).is_simple(0.0, NEAR));
}

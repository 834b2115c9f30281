//! Sheets in double-double against the same in doubles, and roots of conditions against what vanishes there.

use core::f64::consts::{FRAC_PI_2, PI};

use super::super::condition::conditions;
use super::super::crossing::crossing;
use super::super::pair::Geometry;
use super::super::shared::SharedEnds;
use super::super::sheet::Sheet;
use super::super::spiral::Spiral;
use super::super::tangent::tests::plain;
use super::condition::*;
use super::turn::*;
use super::*;
use crate::geometry::{Point, Rotation, Vector};
use crate::number::Dd;
use crate::part::{Part, Vertex};

/// Two parts with arcs of both kinds, small and large.
fn geometry() -> Geometry {
    let part = |name: &str, size: f64, bulges: [f64; 5]| {
        let corners = [
            (-1.0, -1.0),
            (1.0, -0.9),
            (1.1, 1.0),
            (0.3, 1.3),
            (-0.4, 1.2),
        ];
        let outline = (corners.into_iter().zip(bulges))
            .map(|((x, y), bulge)| Vertex::new(x * size, y * size, bulge))
            .collect();
        Part::new(name, vec![outline]).unwrap()
    };
    let fixed = part("fixed", 1.0, [5e-4, 0.3, 0.0, -2e-4, -0.4]);
    let moving = part("moving", 0.6, [3e-4, -0.2, 0.0, -2e-4, 0.25]);
    Geometry::new(&fixed, &moving, None, usize::MAX)
}

fn exact<'a>(geometry: &'a Geometry, sheet: &'a Sheet) -> ExactSheet<'a> {
    ExactSheet::new(&geometry.fixed, &geometry.moving, sheet)
}

fn point(p: Point<Dd>) -> Point {
    p.map(Dd::to_f64)
}

fn exactly(x: f64, y: f64) -> Vector<Dd> {
    Vector::new(x, y).map(Dd::from)
}

fn spiral(u: Vector<Dd>, w: Vector<Dd>) -> Spiral<Dd> {
    Spiral::new(Point::new(u.x, u.y), w)
}

/// Pairs of sheets that both exist for a while, and may cross, with the orientations at which they do.
fn pairs(geometry: &Geometry) -> Vec<(&Sheet, &Sheet, (f64, f64), SharedEnds)> {
    let contacts = &geometry.contacts;
    let mut pairs = Vec::new();
    for (i, f) in contacts.sheets.iter().enumerate() {
        for g in &contacts.sheets[..i] {
            let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
            let shared = f.shared_ends(g, contacts.first_vertex_name);
            if hi - lo > 1e-3 && !shared.tangent {
                pairs.push((f, g, (lo, hi), shared));
            }
        }
    }
    assert!(pairs.len() > 500, "{}", pairs.len());
    pairs
}

/// Curves are where doubles tell, and their ends on them to the rounding of double-double.
#[test]
fn curves_are_those_of_doubles() {
    /// Distances, as far as doubles tell them of the largest circles, and rounding of double-double.
    const NEAR: f64 = 1e-11;
    const NONE: f64 = 1e-26;
    /// Places on a large circle are told from a point near the parts, that is known in doubles.
    const NONE_OF_LARGE: f64 = 1e-15;
    let geometry = geometry();
    for s in &geometry.contacts.sheets {
        for share in [0.1, 0.5, 0.8] {
            let theta = s.lo + share * (s.hi - s.lo);
            let turn = ExactTurn::by(Dd::from(theta));
            let (rough, curve) = (
                s.curve(theta, Rotation::by(theta)),
                exact(&geometry, s).curve(&turn),
            );
            let [start, end] = curve.end_points();
            assert!(point(start).distance(rough.start) < NEAR, "{s:?}");
            assert!(point(end).distance(rough.end) < NEAR, "{s:?}");
            let (from, to) = curve.ends();
            let length = (to - from).to_f64();
            let expected = 2.0 * rough.half;
            assert!(
                (length - expected).abs() < NEAR,
                "{length} {expected} {s:?}"
            );
            for (place, p) in [(from, start), (to, end)] {
                let off = length_of(curve.point(place) - p);
                let none = if s.is_flat() { NONE_OF_LARGE } else { NONE };
                assert!(off < none, "{off} {s:?}");
                let normal = curve.cycle().normal_at(p);
                let height = curve.height(p, normal).to_f64().abs();
                assert!(height < NONE, "{height} {s:?}");
            }
            for along in [0.2, 0.5, 0.7] {
                let place = from + (to - from) * along;
                let p = curve.point(place);
                let (q, normal) = (point(p), curve.cycle().normal_at(p));
                assert!(s.function().value(q, theta).abs() < NEAR, "{s:?}");
                let bend = rough.normal(q) - normal.map(Dd::to_f64);
                assert!(bend.length() < 1e-9, "{s:?}");
                // A little towards the free side and away from it.
                for by in [1e-3, -1e-3] {
                    let beside = p + normal * Dd::from(by);
                    assert_eq!(curve.is_free(beside), Some(by > 0.0), "{s:?}");
                }
            }
            // Nothing is beside it beyond its ends.
            let beyond = (to - from) * 0.1;
            for place in [from - beyond, to + beyond] {
                assert_eq!(curve.is_free(curve.point(place)), None, "{s:?}");
            }
            assert!(curve.cycle().is_one_with(&curve.cycle, 1e-14));
        }
    }
}

fn length_of(v: Vector<Dd>) -> f64 {
    v.length().to_f64()
}

/// What is told of a crossing by its name: where it is, and which curve enters; and what orders crossings along a curve.
#[test]
fn crossings_are_those_of_doubles() {
    let geometry = geometry();
    let (mut clear, mut flat) = (0, 0);
    for (f, g, (lo, hi), _) in pairs(&geometry) {
        for share in [0.2, 0.6] {
            let theta = lo + share * (hi - lo);
            let turn = ExactTurn::by(Dd::from(theta));
            let [a, b] = [f, g].map(|s| s.curve(theta, Rotation::by(theta)));
            let [c, d] = [f, g].map(|s| exact(&geometry, s).curve(&turn));
            for root in 0..2 {
                let (Some(x), Some(y)) = (crossing(&a, &b, root), c.crossing(&d, root)) else {
                    continue;
                };
                // Where curves cross sharply, and near the parts.
                let p = x.point;
                let sharp = a.normal(p).cross(b.normal(p)).abs() > 0.01;
                if !sharp || (p - Point::ORIGIN).length() > 4.0 {
                    continue;
                }
                clear += 1;
                flat += usize::from(f.is_flat() || g.is_flat());
                assert!(point(y.point).distance(p) < 1e-9, "{f:?} {g:?}");
                assert_eq!(x.enters, y.enters, "{f:?} {g:?}");
                // It is on both carriers, and at both places.
                let places = (c.length_of(y.on), d.length_of(d.cycle.place(y.point)));
                for (curve, place) in [(&c, places.0), (&d, places.1)] {
                    let off = length_of(curve.point(place) - y.point);
                    let none = if f.is_flat() || g.is_flat() {
                        1e-15
                    } else {
                        1e-24
                    };
                    assert!(off < none, "{off} {f:?} {g:?}");
                }
                let place = |c: &ExactCurve, d: &ExactCurve, swapped| {
                    c.length_of(c.cycle().root(d.cycle(), root, swapped))
                };
                let off = (place(&c, &d, false) - places.0).to_f64().abs();
                assert!(off < 1e-24, "{off} {f:?} {g:?}");
                let off = (place(&d, &c, true) - places.1).to_f64().abs();
                assert!(off < 1e-24, "{off} {f:?} {g:?}");
            }
        }
    }
    assert!(clear > 1000 && flat > 200, "{clear} {flat}");
}

/// Places on a curve, all around a circle, are in the order of their ranks.
#[test]
fn ranks_rise_with_places() {
    let geometry = geometry();
    for s in &geometry.contacts.sheets {
        let turn = ExactTurn::by(s.from);
        let curve = exact(&geometry, s).curve(&turn);
        let half = if s.is_circle() {
            0.95 * PI * s.radius.abs()
        } else {
            1.0
        };
        let ranks: Vec<Dd> = (-50..=50)
            .map(|k| {
                let p = curve.point(Dd::from(half * f64::from(k) / 50.0));
                curve.rank(curve.cycle.place(p))
            })
            .collect();
        assert!(ranks.windows(2).all(|w| w[0] < w[1]), "{s:?}");
    }
}

/// The events are those of doubles, by their numbers too; and they are the same whether doubles have told them or not.
#[test]
fn events_are_those_of_doubles() {
    let geometry = geometry();
    let (mut compared, mut flat) = (0, 0);
    for (f, g, (lo, hi), shared) in pairs(&geometry) {
        let [x, y] = [f, g].map(|s| exact(&geometry, s));
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let mut theirs = Vec::new();
        conditions(&plain(f), &plain(g), &shared, |t| {
            let mut roots = Vec::new();
            t.roots(mid, mid.cos(), mid.sin(), half, |e| roots.push(e));
            theirs.push(roots);
        });
        let range = (Dd::from(lo), Dd::from(hi));
        for (number, theirs) in theirs.iter().enumerate() {
            let events = |told: Rough| {
                let mut found = Vec::new();
                let rough = |n: usize| if n == number { told } else { Rough::None };
                x.events(&y, &shared, range, rough, |theta, e| found.push((theta, e)));
                found
            };
            let ours = events(Rough::Unknown);
            // What is known well, and not at the very end, is found by both.
            let known = theirs
                .iter()
                .filter(|e| e.error < 1e-10 && (e.theta - mid).abs() < half - 1e-8);
            for e in known {
                compared += 1;
                flat += usize::from(f.is_flat() || g.is_flat());
                let near = |o: &&(Dd, f64)| (o.0.to_f64() - e.theta).abs() < 1e-9;
                let (theta, error) = *ours.iter().find(near).unwrap();
                assert!(error < 1e-24, "{error} {f:?} {g:?}");
                let told = events(Rough::At([Some(theta.to_f64() + 1e-13), None]));
                assert!(
                    told.iter()
                        .any(|(t, e)| { (*t - theta).to_f64().abs() <= e + error && *e < 1e-24 })
                );
            }
            let clear = |o: &&(Dd, f64)| o.1 < 1e-26 && (o.0.to_f64() - mid).abs() < half - 1e-8;
            for (theta, _) in ours.iter().filter(clear) {
                let near = (theirs.iter())
                    .any(|e| (theta.to_f64() - e.theta).abs() < 1e-9 + 2.0 * e.error);
                assert!(near, "{theta:?} {f:?} {g:?}");
            }
            assert!(events(Rough::None).is_empty());
        }
    }
    assert!(compared > 500 && flat > 200, "{compared} {flat}");
}

/// The height of a point that goes around a circle over a line: size sin θ − h.
fn high(size: f64, h: Dd) -> Condition {
    let (none, up) = (exactly(0.0, 0.0), exactly(0.0, 1.0));
    let point = spiral(none, exactly(size, 0.0));
    height(
        up,
        false,
        &spiral(Vector::new(Dd::ZERO, h), none),
        &point,
        Dd::ZERO,
    )
}

/// The roots of a condition in rising order.
fn roots_of(c: &Condition) -> Vec<(Dd, f64)> {
    let mut found = Vec::new();
    c.roots(|theta, error| found.push((theta, error)));
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

fn value(c: &Condition, theta: Dd) -> Dd {
    let [alpha, beta, gamma] = c.coefficients;
    let (sin, cos) = theta.sin_cos();
    alpha * cos + beta * sin + gamma
}

/// A condition passes zero within the error that is told, which beside a double root is the square root of the rounding.
#[test]
fn roots_are_where_they_are_told_to_be() {
    // 1 − h, and the least and the largest error to be expected, in units of rounding.
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
        // As far from a quarter turn on one side as on the other.
        let sum = (roots[0].0 + roots[1].0 - Dd::PI).to_f64();
        let turns = (sum / (2.0 * PI)).round();
        assert!((sum - 2.0 * PI * turns).abs() < 1e-15, "{less} {sum}");
    }
    // What stays clear of the line, or only touches it, has none, nor what does not move.
    for h in [1.0, -1.0, 1.0 + 1e-12, -1.0 - 1e-9, 1.5] {
        assert!(roots_of(&high(1.0, Dd::from(h))).is_empty(), "{h}");
    }
    for h in [Dd::ZERO, Dd::from(1e-33), Dd::from(0.3)] {
        assert!(roots_of(&high(0.0, h)).is_empty());
    }
}

/// A point at a distance of one that goes around is at a distance from another as the sides of a triangle tell; and of circles of
/// nearly one radius the differences of lengths are known.
#[test]
fn distances_are_known_as_lengths_are() {
    let spiral = |u: (f64, f64), w: (f64, f64)| spiral(exactly(u.0, u.1), exactly(w.0, w.1));
    for (from, distance) in [(1.0, 0.5), (2.0, 1.5), (1e-3, 1.0)] {
        let (p, q) = (
            spiral((0.0, 0.0), (1.0, 0.0)),
            spiral((from, 0.0), (0.0, 0.0)),
        );
        let distance = Dd::from(distance);
        let roots = roots_of(&apart(&p, &q, distance));
        assert_eq!(roots.len(), 2, "{from}");
        for (theta, error) in roots {
            let turn = ExactTurn::by(theta);
            let off = (p.at(turn.turn) - q.at(turn.turn)).length() - distance;
            assert!(off.to_f64().abs() < 8.0 * error + 1e-30, "{off:?} {error}");
            assert!(error < 1e-24, "{error}");
        }
    }
    // The centres 2 d apart at most, and the distance d, wherever the centres are.
    let d = 1e-12;
    let (p, q) = (
        spiral((0.7, 0.3), (d, 0.0)),
        spiral((0.7 + d, 0.3), (0.0, 0.0)),
    );
    let roots = roots_of(&apart(&p, &q, (Dd::from(0.7 + d) - 0.7).abs()));
    assert_eq!(roots.len(), 2);
    for (theta, error) in roots {
        // A sixth of a turn, as far as d is known.
        assert!((theta.to_f64().cos() - 0.5).abs() < 1e-3, "{theta:?}");
        assert!(error < 1e-15, "{error}");
    }
}

/// From where doubles tell a root the same root is found; what is near a double root, or off, is not told by them.
#[test]
fn a_root_is_refined_where_it_is_simple() {
    for less in [0.3, 1.0, 1.7] {
        let c = high(1.0, Dd::ONE - less);
        for (theta, error) in roots_of(&c) {
            for off in [0.0, 1e-12, -1e-11] {
                let near = theta.to_f64() + off;
                assert!(c.is_simple(near), "{less}");
                let (root, e) = c.root_near(near);
                assert!((root - theta).to_f64().abs() <= error + e, "{less} {off}");
                assert!(e < 1e-26, "{e}");
            }
            assert!(!c.is_simple(theta.to_f64() + 1e-9));
        }
    }
    let c = high(1.0, Dd::ONE - 1e-8);
    assert!(roots_of(&c).iter().all(|r| !c.is_simple(r.0.to_f64())));
    assert!(!high(1.0, Dd::ONE).is_simple(FRAC_PI_2));
    // Little that moves beside much that does not is known to less.
    let c = high(1e-6, Dd::ZERO);
    assert!(c.is_simple(0.0));
    let far = spiral(exactly(3.0, 1.0), exactly(0.0, 0.0));
    let up = exactly(0.0, 1.0);
    let point = Spiral {
        w: exactly(1e-6, 0.0),
        ..far
    };
    assert!(!height(up, false, &far, &point, Dd::ZERO).is_simple(0.0));
}

/// A turn from another nearby is that by its angle.
#[test]
fn turns_to_what_is_near() {
    let base = ExactTurn::by(Dd::from(0.7) + 1e-19);
    for by in [
        0.0, 1e-30, -3e-20, 2e-14, -7e-11, 9.9e-9, -1e-8, 1.1e-8, 0.3,
    ] {
        let theta = base.theta + by;
        let (turn, expected) = (base.turned_to(theta), ExactTurn::by(theta));
        for off in [
            turn.turn.cos - expected.turn.cos,
            turn.turn.sin - expected.turn.sin,
        ] {
            assert!(off.to_f64().abs() < 4e-32, "{by}: {off:?}");
        }
    }
}

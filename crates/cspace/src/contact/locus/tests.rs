//! Loci, curves and crossings in double-double compared with those in f64.

use core::f64::consts::PI;

use super::super::crossing::crossing;
use super::super::curve::Curve;
use super::super::orientation::Orientation;
use super::super::pair::Geometry;
use super::super::sheet::Sheet;
use super::*;
use crate::geometry::Vector;
use crate::number::Dd;
use crate::part::{Part, Vertex};

/// Two parts with arcs of both kinds, small and large.
pub(in crate::contact) fn geometry() -> Geometry {
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

pub(in crate::contact) fn exact(geometry: &Geometry, sheet: &Sheet) -> Locus<Dd> {
    sheet.exact(&geometry.fixed, &geometry.moving)
}

fn exact_curve(geometry: &Geometry, sheet: &Sheet, theta: Dd) -> Curve<Dd> {
    sheet.curve_on(&exact(geometry, sheet), &Orientation::by(theta))
}

fn point(p: Point<Dd>) -> Point {
    p.map(Dd::to_f64)
}

/// Two sheets, between which orientations both exist, and whether they share corners.
type Together<'a> = (&'a Sheet, &'a Sheet, (f64, f64), [bool; 2]);

/// Pairs of sheets that both exist for a while, and may cross, with the orientations at which they do.
pub(in crate::contact) fn pairs(geometry: &Geometry) -> Vec<Together<'_>> {
    let contacts = &geometry.contacts;
    let mut pairs = Vec::new();
    for (i, f) in contacts.sheets.iter().enumerate() {
        for g in &contacts.sheets[..i] {
            let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
            let shared = f.shared_ends(g, contacts.first_vertex_name);
            if hi - lo > 1e-3 && !shared.tangent {
                pairs.push((f, g, (lo, hi), shared.corners));
            }
        }
    }
    assert!(pairs.len() > 500, "{}", pairs.len());
    pairs
}

/// Curves agree with those in f64, and their ends lie on them to the rounding of double-double.
#[test]
fn curves_are_those_of_doubles() {
    /// Tolerance of distances, given the accuracy of f64 for the largest circles; and rounding of double-double.
    const NEAR: f64 = 1e-11;
    const NONE: f64 = 1e-26;
    let geometry = geometry();
    for s in &geometry.contacts.sheets {
        for share in [0.1, 0.5, 0.8] {
            let theta = s.lo + share * (s.hi - s.lo);
            let rough = s.curve(theta, Rotation::by(theta));
            let curve = exact_curve(&geometry, s, Dd::from(theta));
            let (start, end) = (curve.start, curve.end);
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
                assert!(off < NONE, "{off} {s:?}");
                let normal = curve.normal(p);
                let height = curve.height(p, normal).to_f64().abs();
                assert!(height < NONE, "{height} {s:?}");
            }
            for along in [0.2, 0.5, 0.7] {
                let place = from + (to - from) * along;
                let p = curve.point(place);
                let (q, normal) = (point(p), curve.normal(p));
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
            assert!(curve.cycle.is_one_with(&curve.cycle, 1e-14));
        }
    }
}

fn length_of(v: Vector<Dd>) -> f64 {
    v.length().to_f64()
}

/// A crossing's place and which curve enters, in double-double and in f64; also its place along both curves.
#[test]
fn crossings_are_those_of_doubles() {
    let geometry = geometry();
    let (mut clear, mut flat) = (0, 0);
    for (f, g, (lo, hi), _) in pairs(&geometry) {
        for share in [0.2, 0.6] {
            let theta = lo + share * (hi - lo);
            let [a, b] = [f, g].map(|s| s.curve(theta, Rotation::by(theta)));
            let [c, d] = [f, g].map(|s| exact_curve(&geometry, s, Dd::from(theta)));
            for root in 0..2 {
                let (Some(x), Some(y)) = (crossing(&a, &b, root), crossing(&c, &d, root)) else {
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
                let places = (c.position(y.point), d.position(y.point));
                for (curve, place) in [(&c, places.0), (&d, places.1)] {
                    let off = length_of(curve.point(place) - y.point);
                    assert!(off < 1e-24, "{off} {f:?} {g:?}");
                }
                let place = |c: &Curve<Dd>, d: &Curve<Dd>, swapped| {
                    c.length_to(c.cycle.root(&d.cycle, root, swapped))
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
        let curve = exact_curve(&geometry, s, s.from);
        let half = if s.is_circle() {
            0.95 * PI * s.locus.carrier.radius.abs()
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

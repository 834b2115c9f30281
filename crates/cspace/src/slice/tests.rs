//! Pieces of boundary, compared with points stepped along them.

use core::f64::consts::{FRAC_PI_2, PI};

use super::boundary::*;
use super::curve_geometry::*;
use crate::contact::{Curve, Cycle};
use crate::feature::tolerance::TORN;
use crate::feature::{FeatureKind, FeatureName, PairFrame};
use crate::geometry::{Point, Vector};
use core::f64::consts::TAU;

fn segment(a: (f64, f64), b: (f64, f64)) -> CurveGeometry {
    CurveGeometry::Segment {
        start: Point::new(a.0, a.1),
        end: Point::new(b.0, b.1),
    }
}

fn arc(radius: f64, start_angle: f64, sweep: f64) -> CurveGeometry {
    CurveGeometry::Arc {
        center: Point::new(0.3, -0.2),
        radius,
        start_angle,
        sweep,
    }
}

fn flat_arc(a: (f64, f64), b: (f64, f64), bulge: f64) -> CurveGeometry {
    CurveGeometry::FlatArc {
        start: Point::new(a.0, a.1),
        end: Point::new(b.0, b.1),
        bulge,
    }
}

fn pieces() -> Vec<CurveGeometry> {
    let mut all = vec![
        segment((-1.0, 0.3), (0.8, 0.4)),
        segment((0.2, 1.0), (0.5, -0.9)),
        segment((0.9, 0.9), (-0.4, -0.7)),
    ];
    for bulge in [0.3, -0.2, 1e-3, -1e-3, 1e-9] {
        all.push(flat_arc((-1.0, 0.3), (0.8, 0.4), bulge));
        all.push(flat_arc((0.4, 0.9), (-0.1, -0.8), bulge));
    }
    for k in 0..7 {
        for sweep in [0.4, 1.9, 3.3, 6.0] {
            all.push(arc(0.7, f64::from(k) - 3.1, sweep));
            all.push(arc(0.7, f64::from(k) - 3.1, -sweep));
        }
    }
    all
}

const STEPS: usize = 2000;

fn points(g: &CurveGeometry) -> Vec<Point> {
    (0..=STEPS)
        .map(|k| g.point(k as f64 / STEPS as f64))
        .collect()
}

#[test]
fn points_and_lengths_are_those_of_the_drawing() {
    let s = segment((1.0, 1.0), (4.0, 5.0));
    assert_eq!(s.length(), 5.0);
    assert_eq!(s.point(0.5), Point::new(2.5, 3.0));
    // A quarter of a circle from the right to the top, and back.
    let there = arc(2.0, 0.0, FRAC_PI_2);
    let back = arc(2.0, FRAC_PI_2, -FRAC_PI_2);
    for (g, from, to) in [
        (there, Point::new(2.3, -0.2), Point::new(0.3, 1.8)),
        (back, Point::new(0.3, 1.8), Point::new(2.3, -0.2)),
    ] {
        assert!(g.point(0.0).distance(from) < 1e-15 && g.point(1.0).distance(to) < 1e-15);
        assert!((g.length() - PI).abs() < 1e-15);
    }
    for g in pieces() {
        let walked: f64 = points(&g).windows(2).map(|p| p[0].distance(p[1])).sum();
        assert!((g.length() - walked).abs() < 1e-5, "{g:?} {walked}");
    }
}

/// Half a circle about (1, 2) from its right to its left, by its bulge of 1, and in the other direction.
#[test]
fn the_bulge_of_an_arc_is_positive_counter_clockwise() {
    for (from, to, bulge) in [(1.5, 0.5, 1.0), (0.5, 1.5, -1.0)] {
        let g = flat_arc((from, 2.0), (to, 2.0), bulge);
        assert!(g.point(0.5).distance(Point::new(1.0, 2.5)) < 1e-15);
        assert!((g.length() - FRAC_PI_2).abs() < 1e-15);
        let outward = Vector::new(0.0, bulge);
        assert!((g.free_normal(0.5) - outward).length() < 1e-15);
    }
}

/// A ray along which both crossings with the circle of a flat arc lie, and one that is parallel to its chord.
#[test]
fn rays_meet_a_flat_arc_where_its_circle_is() {
    // Half an angle φ about the centre (0, −R cos φ) with the chord from (1, 0) to (−1, 0): R = 1/sin φ, bulge tan(φ/2).
    for half in [1e-4_f64, 0.1, 0.6] {
        let (radius, below) = (half.sin().recip(), half.tan().recip());
        let there = flat_arc((1.0, 0.0), (-1.0, 0.0), (0.5 * half).tan());
        let back = flat_arc((-1.0, 0.0), (1.0, 0.0), -(0.5 * half).tan());
        for x in [-0.99, -0.4, 0.0, 0.3, 0.99] {
            let y = (1.0 - x * x) / ((radius * radius - x * x).sqrt() + below);
            for (g, side) in [(there, 1.0), (back, -1.0)] {
                // From below and from above, straight.
                for (from, way) in [(-0.7, 1.0), (1.3, -1.0)] {
                    let met = g.hit(Point::new(x, from), Vector::new(0.0, way));
                    let (t, towards) = met.unwrap();
                    assert!((t - (y - from) * way).abs() < 1e-12, "{g:?} {x} {t}");
                    assert_eq!(towards > 0.0, way * side > 0.0);
                }
                assert!(g.hit(Point::new(x, -0.7), Vector::new(0.0, -1.0)).is_none());
                assert!(g.hit(Point::new(x, 1.3), Vector::new(0.0, 1.0)).is_none());
            }
        }
        // Through both crossings of the circle with a line parallel to the chord.
        let y = 0.5 * (0.5 * half).tan();
        let x = (1.0 - y * y - 2.0 * y * below).sqrt();
        for (from, way) in [(-3.0, 1.0), (0.0, 1.0), (0.0, -1.0), (3.0, -1.0)] {
            let (t, towards) = there
                .hit(Point::new(from, y), Vector::new(way, 0.0))
                .unwrap();
            let expected = if from == 0.0 { x } else { 3.0 - x };
            assert!((t - expected).abs() < 1e-9, "{half} {from}: {t}");
            assert_eq!(towards > 0.0, from == 0.0);
        }
        assert!(
            there
                .hit(Point::new(2.0, y), Vector::new(1.0, 0.0))
                .is_none()
        );
    }
}

/// Flat arcs, and only these, are also edges of parts.
#[test]
fn a_flat_arc_is_an_edge() {
    for g in pieces() {
        let flat = matches!(g, CurveGeometry::FlatArc { .. });
        assert_eq!(g.edge().is_some(), flat);
        if let Some(e) = g.edge() {
            let area: f64 = (points(&g).windows(2))
                .map(|p| 0.5 * (p[0] - e.start).cross(p[1] - e.start))
                .sum();
            assert!((e.segment_area() - area).abs() < 1e-6, "{g:?} {area}");
        }
    }
}

#[test]
fn free_space_is_on_the_right_of_travel() {
    for g in pieces() {
        for s in [0.1, 0.5, 0.8] {
            let travel = (g.point(s + 1e-6) - g.point(s - 1e-6)).unit();
            assert!((g.free_normal(s) - travel.right()).length() < 1e-8);
        }
    }
}

#[test]
fn the_nearest_point_is_nearer_than_any_other() {
    for g in pieces() {
        let all = points(&g);
        for k in 0..40 {
            let p = Point::new(0.3, -0.2)
                + Vector::from_angle(1.3 * f64::from(k)) * (0.05 * f64::from(k));
            let found = g.nearest(p);
            let least = (all.iter().map(|q| p.distance(*q))).fold(f64::INFINITY, f64::min);
            // Between two steps the curve may be nearer by half a step at most.
            let off = p.distance(found) - least;
            let step = g.length() / STEPS as f64;
            assert!(off < 1e-14 && off > -step, "{g:?} {p:?} {found:?} {off}");
            assert!(all.iter().any(|q| q.distance(found) <= step));
        }
    }
    let nothing = segment((1.0, 2.0), (1.0, 2.0));
    assert_eq!(nothing.nearest(Point::ORIGIN), Point::new(1.0, 2.0));
}

#[test]
fn rays_meet_what_is_first_and_tell_from_which_side() {
    let (mut met, mut missed) = (0, 0);
    for g in pieces() {
        let all = points(&g);
        for k in 0..40 {
            let p = Point::new(0.3, -0.2)
                + Vector::from_angle(1.7 * f64::from(k)) * (0.05 * f64::from(k));
            let d = Vector::from_angle(0.1 + 2.4 * f64::from(k));
            let first = (0..STEPS)
                .filter_map(|i| {
                    let (a, b) = (all[i] - p, all[i + 1] - p);
                    let (x, y) = (d.cross(a), d.cross(b));
                    let t = d.dot(a + (b - a) * (x / (x - y)));
                    (x * y < 0.0 && t > 0.0).then_some((t, i))
                })
                .min_by(|a, b| a.0.total_cmp(&b.0));
            match (g.hit(p, d), first) {
                (Some((t, side)), Some((s, i))) => {
                    assert!((t - s).abs() < 1e-4, "{g:?} {p:?} {d:?}: {t} {s}");
                    let normal = g.free_normal((i as f64 + 0.5) / STEPS as f64);
                    assert_eq!(side < 0.0, d.dot(normal) < 0.0);
                    met += 1;
                }
                (None, None) => missed += 1,
                other => panic!("{g:?} {p:?} {d:?}: {other:?}"),
            }
        }
    }
    assert!(met > 300 && missed > 300, "{met} {missed}");
}

#[test]
fn directions_are_on_an_arc_when_it_comes_past_them() {
    for (start, sweep, angle, on) in [
        (0.0, 1.0, 0.5, true),
        (0.0, 1.0, 1.5, false),
        (0.0, 1.0, -0.5, false),
        (0.0, -1.0, -0.5, true),
        (0.0, -1.0, 0.5, false),
        (0.0, -1.0, -1.5, false),
        (3.0, 1.0, -3.0, true),
        (-3.0, -1.0, 3.0, true),
        (3.0 + TAU, 1.0, -3.0, true),
        (3.0, 1.0, -2.0, false),
        (0.0, 1.0, 0.0, true),
    ] {
        assert_eq!(
            is_on_arc(start, sweep, angle),
            on,
            "{start} {sweep} {angle}"
        );
    }
}

/// A curve of the pair's frame and its image in the frame as drawn, which is larger and elsewhere.
#[test]
fn curves_are_brought_to_the_frames_as_drawn() {
    let frame = PairFrame {
        fixed_center: Point::new(5.0, 6.0),
        moving_center: Point::new(-1.0, 2.0),
        scale: 0.25,
    };
    let theta = 0.4;
    let travel = Vector::from_angle(0.6);
    let start = Point::new(0.1, -0.1);
    let line = Cycle::line(start, travel.right());
    let mut curves = vec![Curve::new(line, [start, start + travel], [0.0; 2])];
    for radius in [0.5_f64, -0.5] {
        let center = Point::new(0.2, 0.1);
        let (mid_angle, half) = (2.9, 0.8);
        let end =
            |turn: f64| center + Vector::from_angle(mid_angle + turn * radius.signum()) * radius;
        curves.push(Curve::new(
            Cycle::round(center, radius),
            [end(-half), end(half)],
            [mid_angle - half, mid_angle + half],
        ));
    }
    for curve in curves {
        let half = curve.half;
        let (from, to) = (-0.5 * half, 0.7 * half);
        let outer = CurveGeometry::from_inner(&curve, from, to, &frame, theta);
        assert!((outer.length() - (to - from) / 0.25).abs() < 1e-13);
        for s in [0.0, 0.3, 1.0] {
            let inner = curve.point(from + s * (to - from));
            let p = frame.outer_from_inner(inner, theta).position();
            assert!(outer.point(s).distance(p) < 1e-13, "{outer:?}");
            assert!((outer.free_normal(s) - curve.normal(inner)).length() < 1e-13);
        }
        if let CurveGeometry::Arc { start_angle, .. } = outer {
            assert!(start_angle.abs() <= PI);
        }
    }
}

fn slice(pieces: &[(CurveGeometry, u32)]) -> Slice {
    let name = FeatureName {
        kind: FeatureKind::Line,
        loop_index: 0,
        index: 0,
    };
    let curves = (pieces.iter())
        .map(|&(geometry, next)| SliceCurve {
            fixed: name,
            moving: name,
            geometry,
            patch: None,
            next,
        })
        .collect();
    Slice::from_curves(0.0, curves, false, &frame())
}

/// Frame of the plane itself.
fn frame() -> PairFrame {
    PairFrame {
        fixed_center: Point::ORIGIN,
        moving_center: Point::ORIGIN,
        scale: 1.0,
    }
}

/// A square of blocked space, counter-clockwise, with a round hole of free space in it and a blocked disc in that.
#[test]
fn positions_are_free_outside_of_what_is_blocked() {
    let corners = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)];
    let mut all: Vec<(CurveGeometry, u32)> = (0..4)
        .map(|i| {
            (
                segment(corners[i], corners[(i + 1) % 4]),
                (i as u32 + 1) % 4,
            )
        })
        .collect();
    // The hole in two halves, clockwise.
    all.push((arc(1.0, 0.5, -PI), 5));
    all.push((arc(1.0, 0.5 - PI, -PI), 4));
    all.push((arc(0.4, 1.0, PI), 7));
    all.push((arc(0.4, 1.0 + PI, PI), 6));
    let slice = slice(&all);
    assert_eq!(slice.loops, [vec![0, 1, 2, 3], vec![4, 5], vec![6, 7]]);
    let middle = Point::new(0.3, -0.2);
    let (mut free, mut blocked) = (0, 0);
    for i in -30..=30 {
        for j in -30..=30 {
            let p = Point::new(f64::from(i) / 10.0 + 0.013, f64::from(j) / 10.0 + 0.007);
            let r = p.distance(middle);
            let expected = p.x.abs().max(p.y.abs()) > 2.0 || (0.4..1.0).contains(&r);
            assert_eq!(slice.is_free(p), expected, "{p:?}");
            *(if expected { &mut free } else { &mut blocked }) += 1;
        }
    }
    assert!(free > 1000 && blocked > 1000);
    assert!(Slice::from_curves(0.0, Vec::new(), false, &frame()).is_free(middle));
}

/// Direction of the first ray.
fn first_ray() -> Vector {
    Vector::from_angle(1.234_567_89)
}

/// Two curves on one carrier that face each other, in either order, with the disc around them blocked: rays that miss the two decide the
/// space inside.
#[test]
fn curves_that_face_each_other_on_one_carrier_are_not_asked() {
    let direction = first_ray();
    let p = Point::new(0.3, -0.2);
    let gate = |at: f64, turn: f64| {
        let across = direction.left() * (0.5 * at * turn);
        let (a, b) = (p + direction * at - across, p + direction * at + across);
        segment((a.x, a.y), (b.x, b.y))
    };
    // As shares of the radius: their places, and distances. For very near curves the radius counts.
    let gates = [(0.2, 1e-12), (0.2, 1e-8), (1e-3, 5e-10)];
    for (size, free) in [1e-3, 1.0, 1e3].map(|s| [(s, true), (s, false)]).concat() {
        // The outermost circle faces inwards if what is within is free.
        let around = arc(size, 0.0, if free { -TAU } else { TAU });
        for (at, apart) in gates.map(|(at, d)| [(at, d), (at, -d)]).concat() {
            let s = slice(&[
                (around, 0),
                (gate(size * at, 1.0), 1),
                (gate(size * (at + apart), -1.0), 2),
            ]);
            assert_eq!(s.is_free(p), free, "{size} {at} {apart}");
        }
    }
}

/// A segment from one point to another.
type Piece = [(f64, f64); 2];

/// A loop by corners given along the first ray and across it, in sizes; its ends need not meet.
fn around(size: f64, pieces: &[Piece]) -> Slice {
    let at = |(x, y): (f64, f64)| {
        let v = first_ray() * (x * size) + first_ray().left() * (y * size);
        (v.x, v.y)
    };
    let n = pieces.len() as u32;
    let pieces = (1..).zip(pieces);
    let all: Vec<_> = pieces
        .map(|(next, &[a, b])| (segment(at(a), at(b)), next % n))
        .collect();
    slice(&all)
}

/// The first ray leaves a blocked triangle through a corner at which the sides do not quite meet.
#[test]
fn rays_do_not_slip_through_torn_corners() {
    let gap = 0.25 * TORN;
    for size in [1e-3, 1.0, 1e3] {
        let torn = around(
            size,
            &[
                [(1.0, gap), (-1.0, 1.0)],
                [(-1.0, 1.0), (-1.0, -1.0)],
                [(-1.0, -1.0), (1.0, -gap)],
            ],
        );
        assert!(!torn.is_free(Point::ORIGIN), "{size}");
    }
}

/// A blocked square with a notch, a side of which extends slightly beyond the notch's corner: the first ray meets it from its free side.
#[test]
fn rays_do_not_meet_what_sticks_out_of_a_corner() {
    let little = 0.5 * TORN;
    // The ray goes the way of both axes, to the middle of what sticks out, from the origin.
    let turned = |(x, y): (f64, f64)| {
        let (x, y) = (x - 0.5 + 0.5 * little, y + 0.5);
        (0.5 * (x + y), 0.5 * (y - x))
    };
    for size in [1e-3, 1.0, 1e3] {
        let corners = [
            [(-1.0, -1.0), (1.0, -1.0)],
            [(1.0, -1.0), (1.0, 0.0)],
            [(1.0 - little, 0.0), (2.0, 0.0)],
            [(2.0, 0.0), (2.0, 2.0)],
            [(2.0, 2.0), (-1.0, 2.0)],
            [(-1.0, 2.0), (-1.0, -1.0)],
        ];
        let notched = around(size, &corners.map(|corner| corner.map(turned)));
        assert!(!notched.is_free(Point::ORIGIN), "{size}");
    }
}

#[test]
fn what_is_a_point_has_no_normal() {
    let p = Point::new(0.3, -0.2);
    for g in [
        CurveGeometry::Segment { start: p, end: p },
        CurveGeometry::FlatArc {
            start: p,
            end: p,
            bulge: 1e-3,
        },
    ] {
        assert_eq!(g.free_normal(0.4), Vector::ZERO);
        assert_eq!(g.point(0.4), p);
    }
}

/// Ends without successors are joined to the nearest beginnings, each used once, and none that is far away.
#[test]
fn open_ends_are_followed_by_the_nearest_beginnings() {
    let open = u32::MAX;
    let little = 1e-8;
    // From the right to two ends beside the origin, and back from two beginnings there; the second end is nearer to the
    // second beginning than to the first, and the first end nearer to that than the second is.
    let there = |y: f64| segment((1.0, 1.0), (0.0, y));
    let back = |y: f64| segment((0.0, y), (1.0, 1.0));
    for order in [[0, 1, 2, 3], [2, 3, 0, 1], [3, 1, 2, 0]] {
        let pieces = [there(0.0), there(3.0 * little), back(0.0), back(little)];
        let s = slice(&order.map(|i| (pieces[i], open)));
        let number = |i: usize| order.iter().position(|&o| o == i).unwrap() as u32;
        let next = |i: usize| s.curves[number(i) as usize].next;
        assert_eq!((next(0), next(1)), (number(2), number(3)), "{order:?}");
        assert_eq!(s.loops.len(), 2);
    }
    let far = slice(&[(there(0.0), open), (back(1e-3), open)]);
    assert!(far.curves[0].next as usize >= 2 && far.curves[1].next == 0);
    // A known successor is kept, and not used again.
    let kept = slice(&[
        (there(0.0), 2),
        (there(little), open),
        (back(little), open),
        (back(0.5), open),
    ]);
    assert_eq!(kept.curves[0].next, 2);
    assert!(kept.curves[1].next as usize >= 4);
}

/// A slice whose curves do not join is doubtful, whatever else is known: an end is beyond the distance at which curves are joined, or
/// followed by a curve elsewhere.
#[test]
fn slices_that_are_open_are_doubtful() {
    let p = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y));
    let side = |i: usize, j: usize, off: f64| CurveGeometry::Segment {
        start: p[i] + Vector::new(off, 0.0),
        end: p[j],
    };
    let doubtful = |off: f64, next: u32| {
        let sides = [
            (side(0, 1, 0.0), 1),
            (side(1, 2, off), 2),
            (side(2, 0, 0.0), next),
        ];
        slice(&sides).doubtful
    };
    assert!(!doubtful(0.0, 0) && !doubtful(1e-7, 0));
    assert!(!doubtful(0.0, u32::MAX));
    assert!(doubtful(1e-5, 0) && doubtful(-0.5, u32::MAX));
    assert!(doubtful(0.0, 1));
}

/// A ray through the joint of two curves must meet at least one of them, whatever the rounding.
#[test]
fn rays_meet_joints() {
    let mut slipped = 0;
    for k in 0..1000 {
        let angle = 0.137 * f64::from(k);
        let other = arc(0.7, angle, 0.8);
        let p = Point::new(0.2 * (0.3 * angle).sin(), 0.1);
        let joint = other.point(0.0);
        let away = (joint - p).right();
        let one = CurveGeometry::Segment {
            start: joint + away,
            end: joint,
        };
        let (d, t) = ((joint - p).unit(), joint.distance(p));
        let both = [one, other];
        let met = both.iter().filter_map(|c| c.met(p, d, 1e-11));
        let first = met.reduce(f64::min).unwrap();
        assert!((first - t).abs() < 1e-13, "{angle}: {first}, expected {t}");
        slipped += u32::from(both.iter().all(|c| c.hit(p, d).is_none()));
        // Curves behind the start, and curves passed at a distance, are not met.
        assert!(
            both.iter()
                .all(|c| c.met(joint + d * 2.0, d, 1e-11).is_none())
        );
        let aside = p + d.right() * 1e-9;
        for c in both {
            assert_eq!(c.met(aside, d, 1e-11), c.hit(aside, d).map(|h| h.0));
        }
    }
    assert!(slipped > 10, "{slipped}: no ray is aimed at a joint");
}

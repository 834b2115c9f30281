//! Places, normals, boxes and rays, compared with points computed from angles.

use core::f64::consts::PI;

use super::*;

/// A line through a point that travels in the direction of `angle`, from 2 before to 3 after the point.
pub(in crate::contact) fn line(through: Point, angle: f64) -> Curve {
    let travel = Vector::from_angle(angle);
    let start = through - travel * 2.0;
    let ends = [start, through + travel * 3.0];
    Curve::new(Cycle::line(start, travel.right()), ends, [0.0; 2])
}

/// An arc given by its normals; if the radius is negative it is traversed clockwise.
pub(in crate::contact) fn circle(center: Point, radius: f64, mid_angle: f64, half: f64) -> Curve {
    let end = |turn: f64| center + Vector::from_angle(mid_angle + turn * radius.signum()) * radius;
    let ends = [end(-half), end(half)];
    let angles = [mid_angle - half, mid_angle + half];
    Curve::new(Cycle::round(center, radius), ends, angles)
}

/// Signed distance of a point from a curve's line or circle, positive on the free side.
pub(in crate::contact) fn height(curve: &Curve, p: Point) -> f64 {
    let Cycle {
        through,
        normal,
        weight,
        size,
    } = curve.cycle;
    if curve.cycle.is_line() {
        normal.dot(p - through)
    } else {
        (p.distance(through) - size) * weight
    }
}

fn curves() -> Vec<Curve> {
    let p = Point::new;
    let mut all = vec![
        line(p(0.1, 0.2), 0.3),
        line(p(-0.3, 0.1), 2.5),
        line(p(0.0, 0.0), -2.0),
    ];
    // Arcs about every direction, short ones and some that pass several of the axes, of both signs.
    for k in 0..12 {
        let mid = -3.0 + 0.53 * f64::from(k);
        for half in [0.2, 0.8, 1.7, 2.9] {
            all.push(circle(p(0.3, -0.2), 0.7, mid, half));
            all.push(circle(p(0.3, -0.2), -0.7, mid, half));
        }
    }
    all
}

#[test]
fn places_are_lengths_of_travel_from_the_middle() {
    for c in curves() {
        let half = c.half;
        assert!(c.point(-half).distance(c.start) < 1e-14);
        assert!(c.point(half).distance(c.end) < 1e-14);
        let step = 1e-6;
        for k in -9..=9 {
            let s = half * f64::from(k) / 9.0;
            let p = c.point(s);
            assert!(height(&c, p).abs() < 1e-14);
            assert!((c.position(p) - s).abs() < 1e-13);
            let travel = c.point(s + step) - c.point(s - step);
            assert!((travel.length() - 2.0 * step).abs() < 1e-12);
            // Free space is on the right of travel.
            assert!((c.normal(p) - travel.unit().right()).length() < 1e-9);
            assert!((height(&c, p + c.normal(p) * 1e-3) - 1e-3).abs() < 1e-14);
        }
    }
}

/// The box contains the curve's points, and is no larger than theirs, up to the step between two points.
#[test]
fn boxes_are_tight() {
    const STEPS: i32 = 2000;
    for c in curves() {
        let (lo, hi) = (c.bounds().min, c.bounds().max);
        let points: Vec<Point> = (-STEPS..=STEPS)
            .map(|k| c.point(c.half * f64::from(k) / f64::from(STEPS)))
            .collect();
        let least = |by: fn(&Point) -> f64| points.iter().map(by).fold(f64::INFINITY, f64::min);
        let off = [
            least(|p| p.x) - lo.x,
            least(|p| p.y) - lo.y,
            hi.x + least(|p| -p.x),
            hi.y + least(|p| -p.y),
        ];
        assert!(
            off.iter().all(|o| (-1e-14..1e-6).contains(o)),
            "{c:?} {off:?}"
        );
    }
}

/// The first meeting of a ray with a curve, found by stepping along the curve and detecting changes of side.
fn first_by_walking(c: &Curve, p: Point, d: Vector) -> Option<f64> {
    const STEPS: i32 = 500;
    let at = |k: i32| c.point(c.half * f64::from(k) / f64::from(STEPS)) - p;
    (1 - STEPS..=STEPS)
        .filter_map(|k| {
            let (a, b) = (at(k - 1), at(k));
            let (x, y) = (d.cross(a), d.cross(b));
            let t = d.dot(a + (b - a) * (x / (x - y)));
            (x * y < 0.0 && t > 0.0).then_some(t)
        })
        .min_by(f64::total_cmp)
}

#[test]
fn rays_meet_what_is_first() {
    let (mut met, mut missed) = (0, 0);
    for c in curves() {
        for k in 0..20 {
            let p = Point::new(0.3, -0.2)
                + Vector::from_angle(1.7 * f64::from(k)) * (0.07 * f64::from(k));
            let d = Vector::from_angle(0.1 + 2.4 * f64::from(k));
            let (found, expected) = (c.hit(p, d, 10.0), first_by_walking(&c, p, d));
            match (found, expected) {
                (Some(t), Some(s)) => {
                    assert!((t - s).abs() < 1e-3, "{c:?} {p:?} {d:?}: {t} {s}");
                    assert!(height(&c, p + d * t).abs() < 1e-13);
                    assert_eq!(c.hit(p, d, t * 1.001), Some(t));
                    assert_ne!(c.hit(p, d, t * 0.999), Some(t));
                    met += 1;
                }
                (None, None) => missed += 1,
                _ => panic!("{c:?} {p:?} {d:?}: {found:?}, by walking {expected:?}"),
            }
        }
    }
    assert!(met > 400 && missed > 400, "{met} {missed}");
}

/// Distances of hits are positive and below the limit.
#[test]
fn a_ray_does_not_meet_what_it_starts_on_or_what_is_at_the_limit() {
    let (p, up) = (Point::new(0.5, 0.0), Vector::new(0.0, 1.0));
    for c in [
        line(Point::new(0.0, 2.0), 0.0),
        circle(Point::new(0.5, 3.0), 1.0, -0.5 * PI, 1.0),
    ] {
        assert_eq!(c.hit(p, up, 2.5), Some(2.0));
        assert_eq!(c.hit(p, up, 2.0), None);
        assert_eq!(c.hit(p + up * 2.0, up, 2.5), None);
    }
}

/// A ray through the joint of two curves must meet at least one of them, whatever the rounding.
#[test]
fn rays_do_not_slip_through_joints() {
    let mut slipped = 0;
    // From eight points to each of a thousand joints.
    for k in 0..8000 {
        let (joint, from) = (k / 8, f64::from(k % 8));
        let angle = 0.137 * f64::from(joint);
        let radius = if joint % 2 == 0 { 0.7 } else { -0.7 };
        let (center, half) = (Point::new(0.3, -0.2), 0.4);
        let one = circle(center, radius, angle, half);
        let other = circle(center, radius, angle + 2.0 * half * radius.signum(), half);
        let p = Point::new(0.2 * (0.3 * angle + from).sin(), 0.1);
        let (d, t) = ((one.end - p).unit(), one.end.distance(p));
        let met = [one, other].map(|c| c.hit(p, d, 10.0));
        assert!(
            met.iter().flatten().any(|m| (m - t).abs() < 1e-13),
            "{angle}: {met:?}, expected {t}"
        );
        let ends = |c: &Curve, m: f64| c.position(p + d * m).abs() <= c.half;
        slipped += u32::from(!ends(&one, t) && !ends(&other, t));
    }
    assert!(slipped > 10, "{slipped}: no ray is aimed at a joint");
}

//! Cuts of the turn, for squares whose normals oppose each other at known orientations.

use core::f64::consts::FRAC_PI_2;

use super::super::Geometry;
use super::*;
use crate::geometry::{Point, Vector};
use crate::part::{Part, Vertex};

/// A square whose normals have the given angle, and that plus quarter turns.
fn square(name: &str, angle: f64) -> Part {
    let corner = |k: u32| {
        let angle = angle + FRAC_PI_2 * (f64::from(k) + 0.5);
        let p = Point::ORIGIN + Vector::from_angle(angle);
        Vertex::line(p.x, p.y)
    };
    Part::new(name, vec![(0..4).map(corner).collect()]).unwrap()
}

#[test]
fn the_turn_is_cut_where_no_normals_oppose_each_other() {
    const FIRST: f64 = -PI + 0.01234;
    let span = |angle: f64| {
        let (a, b) = (square("a", 0.0), square("b", angle));
        Geometry::new(&a, &b, None, usize::MAX).contacts.span
    };
    // Turned by θ, the second square's normals oppose the first's where its angle and θ differ by a multiple of a quarter turn.
    for (angle, lo) in [
        (0.3, FIRST),
        (-FIRST, FIRST + 0.000_761_3),
        (-FIRST - 0.5e-7, FIRST + 0.000_761_3),
        (-FIRST + 0.5e-7, FIRST + 0.000_761_3),
        (-FIRST - 2e-7, FIRST),
        (-FIRST + 2e-7, FIRST),
        (-FIRST - 0.000_761_3, FIRST),
    ] {
        let span = span(angle);
        assert!((span.lo - lo).abs() < 1e-15, "{angle}: {span:?}");
        assert_eq!((span.hi, span.full), (span.lo + TAU, true));
    }
}

#[test]
fn a_slab_is_a_share_of_the_turn() {
    let (a, b) = (square("a", 0.0), square("b", 0.3));
    let geometry = Geometry::new(&a, &b, None, usize::MAX);
    let slab = Span::slab(&geometry.fixed, &geometry.moving, 4);
    assert!((slab.hi - slab.lo - FRAC_PI_2).abs() < 1e-15);
}

/// A triangle about the unit circle, given by its normals.
fn triangle(name: &str, angles: [f64; 3]) -> Part {
    let corner = |k: usize| {
        let (a, b) = (angles[k], angles[(k + 1) % 3]);
        let half = 0.5 * (b - a).rem_euclid(TAU);
        let p = Point::ORIGIN + Vector::from_angle(a + half) * (1.0 / half.cos());
        Vertex::line(p.x, p.y)
    };
    Part::new(name, vec![(0..3).map(corner).collect()]).unwrap()
}

/// Angles of normals are in (−π, π]: two normals may oppose each other at an orientation that is a turn from their difference.
#[test]
fn normals_oppose_each_other_whatever_turn_they_are_in() {
    const FIRST: f64 = -PI + 0.01234;
    let a = -3.135;
    let fixed = triangle("a", [a, -1.0, 1.0]);
    let lo = |b: f64| {
        let moving = triangle("b", [b, -1.05, 1.04]);
        Geometry::new(&fixed, &moving, None, usize::MAX)
            .contacts
            .span
            .lo
    };
    // θ = a − b − π is the first cut, less a turn.
    let opposing = a - PI - FIRST + TAU;
    assert!((lo(opposing) - FIRST - 0.000_761_3).abs() < 1e-15);
    assert!((lo(opposing - 1e-6) - FIRST).abs() < 1e-15);
}

#[test]
fn steps_of_both_parts_make_one_slab() {
    for (k, m) in [
        (1, 1),
        (1, 20),
        (20, 1),
        (3, 5),
        (6, 4),
        (12, 18),
        (26, 24),
        (7, 7),
    ] {
        let s = Steps::new(k, m).unwrap_or(Steps::NONE);
        let sum = f64::from(s.fixed) / f64::from(k) + f64::from(s.moving) / f64::from(m);
        let slab = 1.0 / f64::from(s.slabs);
        assert!((sum - slab - (sum - slab).round()).abs() < 1e-14, "{k} {m}");
        assert!(s.slabs.is_multiple_of(k) && s.slabs.is_multiple_of(m));
    }
    assert_eq!(Steps::new(2, 20).map(|s| (s.slabs, s.fixed)), Some((20, 0)));
}

#[test]
fn a_function_is_carried_with_its_configurations() {
    let s = Spiral::new(Point::new(0.3, -0.2), Vector::new(0.5, 0.1));
    let arm = Vector::new(2.0, -3.0);
    let swing = Swing { arm, rest: 0.2 };
    let normal = Vector::from_angle(0.7);
    let steps = Steps::new(6, 4).unwrap_or(Steps::NONE);
    for f in [
        ContactFunction::FixedLine { normal, through: s },
        ContactFunction::MovingLine { normal, through: s },
        ContactFunction::Circle {
            center: s,
            radius: -0.4,
        },
        ContactFunction::FlatCircle {
            through: Spiral { swing, ..s },
            normal,
            turns: true,
            radius: 20.0,
        },
    ] {
        for slabs in [0, 1, 5, -3] {
            let motion = steps.motion(slabs);
            let (p, theta) = (Point::new(1.1, 0.4), 0.3);
            let carried = motion
                .function(f)
                .value(motion.point(p), theta + steps.period(slabs));
            assert!((carried - f.value(p, theta)).abs() < 1e-14);
        }
    }
}

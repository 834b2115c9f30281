//! Where the turn is cut, for squares whose normals oppose each other at known orientations.

use core::f64::consts::FRAC_PI_2;

use super::super::Geometry;
use super::*;
use crate::geometry::{Point, Vector};
use crate::part::{Part, Vertex};

/// A square whose normals have that angle, and quarter turns more.
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
    // Turned by θ, the second square's normals oppose the first's where its angle and θ are a quarter turn, or none.
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

/// A triangle about the unit circle, by its normals.
fn triangle(name: &str, angles: [f64; 3]) -> Part {
    let corner = |k: usize| {
        let (a, b) = (angles[k], angles[(k + 1) % 3]);
        let half = 0.5 * (b - a).rem_euclid(TAU);
        let p = Point::ORIGIN + Vector::from_angle(a + half) * (1.0 / half.cos());
        Vertex::line(p.x, p.y)
    };
    Part::new(name, vec![(0..3).map(corner).collect()]).unwrap()
}

/// Angles of normals are in (−π, π]: two may oppose each other at an orientation that their difference is a turn from.
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

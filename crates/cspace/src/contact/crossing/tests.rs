//! Crossings lie on both cycles, and have the names and directions documented.

use super::super::curve::tests::{circle, height, line};
use super::super::cycle::Cycle;
use super::*;
use crate::geometry::Vector;

/// Lines and circles of both signs, in general position.
fn curves() -> Vec<Curve> {
    let p = Point::new;
    vec![
        line(p(0.1, 0.2), 0.3),
        line(p(-0.3, 0.1), 2.0),
        line(p(0.2, -0.4), -1.1),
        circle(p(0.3, 0.1), 0.7, 0.5, 1.0),
        circle(p(-0.2, 0.3), -0.6, 2.0, 1.2),
        circle(p(0.0, -0.3), 0.5, -2.0, 0.4),
        circle(p(0.05, 0.0), -0.2, 1.0, 0.3),
    ]
}

fn center_and_radius(curve: &Curve) -> Option<(Point, f64)> {
    let cycle = &curve.cycle;
    cycle.is_centred().then_some((cycle.through, cycle.size))
}

/// How many points two cycles share, by distances alone.
fn shared(f: &Curve, g: &Curve) -> usize {
    match (center_and_radius(f), center_and_radius(g)) {
        (None, None) => 1,
        (Some((c, r)), None) => 2 * usize::from(height(g, c).abs() < r),
        (None, Some(_)) => shared(g, f),
        (Some((c, r)), Some((d, s))) => {
            let apart = c.distance(d);
            2 * usize::from((r - s).abs() < apart && apart < r + s)
        }
    }
}

#[test]
fn crossings_are_on_both_cycles_and_go_the_way_they_say() {
    let mut seen = 0;
    for f in &curves() {
        for g in curves().iter().filter(|&g| g != f) {
            let all: Vec<Crossing> = (0..2).filter_map(|r| crossing(f, g, r)).collect();
            assert_eq!(all.len(), shared(f, g));
            for c in &all {
                assert!(height(f, c.point).abs() < 1e-14 && height(g, c.point).abs() < 1e-14);
                let on = f.point(f.position(c.point) + 1e-6);
                assert_eq!(c.enters, height(g, on) < 0.0, "{f:?} {g:?}");
                seen += 1;
            }
            if let [a, b] = all[..] {
                assert!(a.point.distance(b.point) > 1e-3);
                assert_ne!(a.enters, b.enters);
            }
        }
    }
    assert!(seen > 40, "{seen}");
}

#[test]
fn roots_are_named_by_the_line_or_by_the_line_of_centres() {
    let curves = curves();
    for (f, g) in curves
        .iter()
        .flat_map(|f| curves.iter().map(move |g| (f, g)))
    {
        let (Some(a), Some(b)) = (crossing(f, g, 0), crossing(f, g, 1)) else {
            continue;
        };
        let along = match (center_and_radius(f), center_and_radius(g)) {
            (None, Some(_)) => f.end - f.start,
            (Some(_), None) => g.end - g.start,
            // Root 1 is to the left.
            (Some((c, _)), Some((d, _))) => (d - c).left(),
            (None, None) => continue,
        };
        assert!(along.dot(b.point - a.point) > 0.0);
    }
}

/// Rounding must not move a crossing off the end of a curve on which it lies.
#[test]
fn a_crossing_at_an_end_of_the_first_line_is_that_end() {
    let f = line(Point::new(0.1, 0.2), 0.3);
    for (end, angle) in [(f.start, 0.31), (f.end, 0.31), (f.start, 1.9), (f.end, 1.9)] {
        let travel = Vector::from_angle(angle);
        let cycle = Cycle::line(end, travel.right());
        let g = Curve::new(cycle, [end, end + travel], [0.0; 2]);
        assert_eq!(crossing(&f, &g, 0).map(|c| c.point), Some(end));
    }
}

#[test]
fn what_is_parallel_concentric_or_apart_does_not_cross() {
    let p = Point::new;
    let f = line(p(0.0, 0.0), 0.3);
    assert_eq!(crossing(&f, &line(p(0.0, 0.5), 0.3), 0), None);
    assert_eq!(crossing(&f, &line(p(0.0, 0.5), 0.3 + 1e-15), 0), None);
    let g = circle(p(0.2, 0.1), 0.5, 0.0, 1.0);
    for other in [
        circle(p(0.2, 0.1), 0.5, 0.0, 1.0),
        circle(p(0.2, 0.1), 0.4, 0.0, 1.0),
        circle(p(2.0, 0.1), 0.5, 0.0, 1.0),
        line(p(0.2, 1.1), 0.0),
    ] {
        for root in 0..2 {
            assert_eq!(crossing(&g, &other, root), None);
            assert_eq!(crossing(&other, &g, root), None);
        }
    }
}

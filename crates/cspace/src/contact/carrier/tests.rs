//! Places of crossings in every arithmetic, and how far rounding moves them.

use super::super::curve::tests::{circle, line};
use super::super::{ContactFunction, Curve, CurveShape, Spiral, crossing, roots};
use super::*;
use crate::number::{Ball, Dual};

/// A place on the carrier of a curve as a point.
fn point(c: &Curve, place: (f64, f64)) -> Point {
    match c.shape {
        CurveShape::Line { normal } => c.start + normal.left() * place.0,
        CurveShape::Circle { center, .. } => center + Vector::new(place.0, place.1),
        CurveShape::FlatArc(_) => panic!("none of these is flat"),
    }
}

#[test]
fn places_are_those_of_the_crossings() {
    let p = Point::new;
    let curves = [
        line(p(0.1, 0.2), 0.3),
        line(p(-0.3, 0.1), 2.0),
        circle(p(0.3, 0.1), 0.7, 0.5, 1.0),
        circle(p(-0.2, 0.3), -0.6, 2.0, 1.2),
        circle(p(0.0, -0.3), 0.5, -2.0, 0.4),
    ];
    let mut seen = 0;
    for f in &curves {
        for g in curves.iter().filter(|&g| g != f) {
            for root in 0..roots(f, g) {
                for swapped in [false, true] {
                    let (a, b) = if swapped { (g, f) } else { (f, g) };
                    let Some(c) = crossing(a, b, root) else {
                        continue;
                    };
                    let place = place_on(&f.carrier(), &g.carrier(), root, swapped);
                    assert!(point(f, place).distance(c.point) < 1e-13);
                    seen += 1;
                }
            }
        }
    }
    assert!(seen >= 60, "{seen}");
}

/// One of each kind, all of which cross each other at orientation 0.3.
fn functions() -> [ContactFunction; 4] {
    let spiral = |x: f64, y: f64, a: f64, b: f64| Spiral::new(Point::new(x, y), Vector::new(a, b));
    [
        ContactFunction::FixedLine {
            normal: Vector::from_angle(0.7),
            through: spiral(0.1, -0.2, 0.2, 0.1),
        },
        ContactFunction::MovingLine {
            normal: Vector::from_angle(2.1),
            through: spiral(-0.1, 0.1, 0.1, 0.15),
        },
        ContactFunction::Circle {
            center: spiral(0.2, 0.1, -0.1, 0.2),
            radius: 0.8,
        },
        ContactFunction::Circle {
            center: spiral(-0.2, 0.0, 0.1, 0.3),
            radius: -0.7,
        },
    ]
}

/// All places at which two of the functions cross, in one arithmetic.
fn places<T: Real>(cos: T, sin: T) -> Vec<(T, T)> {
    let all = functions().map(|f| f.carrier(cos, sin));
    let mut places = Vec::new();
    for (i, f) in all.iter().enumerate() {
        for (_, g) in all.iter().enumerate().filter(|(j, _)| *j != i) {
            let lines = matches!((f, g), (Carrier::Line { .. }, Carrier::Line { .. }));
            for root in 0..if lines { 1 } else { 2 } {
                places.push(place_on(f, g, root, false));
            }
        }
    }
    places
}

#[test]
fn slopes_agree_with_differences_and_enclosures_hold_both() {
    const THETA: f64 = 0.3;
    const WIDTH: f64 = 1e-3;
    let at = |theta: f64| places(theta.cos(), theta.sin());
    let slopes = |theta: f64| {
        let (sin, cos) = Dual::<1>::variable(theta, 0).sin_cos();
        places(cos, sin)
    };
    let around = Ball::between(THETA - WIDTH, THETA + WIDTH);
    let (sin, cos) = around.sin_cos();
    let balls = places(cos, sin);
    let (sin, cos) = Dual::<1, _>::variable(around, 0).sin_cos();
    let jets = places(cos, sin);
    let h = 1e-5;
    for k in -4..=4 {
        let theta = THETA + WIDTH * f64::from(k) / 4.0;
        let (here, below, above) = (at(theta), at(theta - h), at(theta + h));
        for (i, d) in slopes(theta).into_iter().enumerate() {
            let ends = [
                (here[i].0, below[i].0, above[i].0),
                (here[i].1, below[i].1, above[i].1),
            ];
            let jet = [jets[i].0, jets[i].1];
            for (j, (d, ball)) in [(d.0, balls[i].0), (d.1, balls[i].1)]
                .into_iter()
                .enumerate()
            {
                let (value, lo, hi) = ends[j];
                assert!((d.value - value).abs() < 1e-13);
                assert!(
                    (d.slope[0] - (hi - lo) / (2.0 * h)).abs() < 1e-7,
                    "{i} {j} {d:?}"
                );
                assert!((ball.mid - value).abs() <= ball.radius);
                assert!((jet[j].value.mid - value).abs() <= jet[j].value.radius);
                assert!((jet[j].slope[0].mid - d.slope[0]).abs() <= jet[j].slope[0].radius);
                assert!(ball.radius < 0.1 && jet[j].slope[0].radius < 0.5, "{i} {j}");
            }
        }
    }
}

/// A carrier that is `PLACE_ERROR` off moves a crossing by that over the sine of the angle.
#[test]
fn errors_of_places_grow_as_crossings_get_flat() {
    let p = Point::new;
    let f = line(p(0.1, 0.2), 0.3);
    let c = circle(p(0.4, -0.3), 0.8, 0.5, 1.0);
    let d = circle(p(0.0, 0.3), -0.5, 0.5, 1.0);
    for sine in [1.0_f64, 0.5, 1e-3] {
        let g = line(p(0.5, 0.1), 0.3 + sine.asin());
        let place = place_on(&f.carrier(), &g.carrier(), 0, false);
        let error = place_error(&f.carrier(), &g.carrier(), place);
        assert!((error * sine / PLACE_ERROR - 1.0).abs() < 1e-6, "{sine}");
    }
    for (f, g) in [(&f, &c), (&c, &f), (&f, &d), (&d, &f), (&c, &d), (&d, &c)] {
        for root in 0..2 {
            let at = crossing(f, g, root).unwrap().point;
            let place = place_on(&f.carrier(), &g.carrier(), root, false);
            let sine = f.normal(at).cross(g.normal(at)).abs();
            let error = place_error(&f.carrier(), &g.carrier(), place);
            // The place is on the circle but for rounding.
            assert!((error * sine / PLACE_ERROR - 1.0).abs() < 0.1);
        }
    }
}

/// Where two carriers that bend apart by a curvature b are tangent, moving one by δ moves the crossing by √(2δ/b).
#[test]
fn errors_of_places_are_bounded_at_tangencies() {
    // A circle of radius r about the origin and another of radius s, tangent at (r, 0), or a line there.
    let r = 0.8;
    let about = |center: f64, radius: f64| Carrier::Circle {
        center: (center, 0.0),
        radius,
    };
    let upright = Carrier::Line {
        normal: (1.0, 0.0),
        through: (r, 0.0),
    };
    // Second carrier, and how much it bends away from the first.
    for (other, bend) in [
        (upright, 1.0 / r),
        (about(r + 0.5, 0.5), 1.0 / r + 2.0),
        (about(r + 0.5, -0.5), 1.0 / r + 2.0),
        (about(r - 0.5, 0.5), 2.0 - 1.0 / r),
        (about(r - 0.5, -0.5), 2.0 - 1.0 / r),
    ] {
        for sign in [1.0, -1.0] {
            let error = place_error(&about(0.0, sign * r), &other, (r, 0.0));
            let expected = (2.0 * PLACE_ERROR / bend).sqrt();
            assert!(
                (error / expected - 1.0).abs() < 1e-6,
                "{other:?}: {error} {expected}"
            );
        }
    }
    let error = place_error(&upright, &about(r + 0.5, 0.5), (0.0, 0.0));
    assert!((error / PLACE_ERROR.sqrt() - 1.0).abs() < 1e-6);
}

#[test]
fn errors_of_places_are_at_least_how_far_they_are_off() {
    let circle = Carrier::Circle {
        center: (0.1, 0.2),
        radius: -0.5,
    };
    let across = Carrier::Line {
        normal: (0.0, 1.0),
        through: (0.0, 0.2),
    };
    let error = place_error(&circle, &across, (0.4, 0.0));
    assert!((error - 0.1).abs() < 1e-12);
    // One line, twice: the crossing has no place.
    assert_eq!(place_error(&across, &across, (0.0, 0.0)), f64::INFINITY);
    assert_eq!(
        place_error(&circle, &across, (f64::NAN, 0.0)),
        f64::INFINITY
    );
}

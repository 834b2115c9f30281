//! Cycles compared with lines and circles by their centres, in every arithmetic; crossings, and their rounding errors.

use super::super::curve::tests::{circle, line};
use super::super::{ContactFunction, Spiral};
use super::*;
use crate::contact::crossing::crossing;
use crate::number::{Ball, Dd, Dual};

/// A circle about a centre, written by the point at an angle.
fn flat(center: Point, radius: f64, angle: f64) -> Cycle {
    let n = Vector::from_angle(angle);
    Cycle::flat(center + n * radius, n, 1.0 / radius)
}

/// The signed distance of a point from a circle about a centre.
fn off(center: Point, radius: f64, p: Point) -> f64 {
    (p.distance(center) - radius.abs()) * radius.signum()
}

/// Levels, gradients, distances and normals equal those of the circle written by its centre, also in double-double.
#[test]
fn a_circle_is_the_same_by_its_centre_and_by_a_place() {
    let center = Point::new(0.3, -3.0);
    for radius in [3.0, -3.0] {
        let base = if radius < 0.0 { 4.5 } else { 1.4 };
        let (by_place, by_center) = (flat(center, radius, base), Cycle::round(center, radius));
        for (angle, by) in [(-0.4, 0.2), (0.1, -0.3), (0.7, 1e-3)] {
            let n = Vector::from_angle(base + angle) * radius.signum();
            let on = center + n * radius.abs() * 1.0;
            let p = on + n * by;
            let expected = by * radius.signum();
            for cycle in [by_place, by_center] {
                assert!((cycle.distance(p) - expected).abs() < 1e-14);
                assert!((cycle.normal_at(on) - n * radius.signum()).length() < 1e-14);
                let square = cycle.size * cycle.size + 2.0 * cycle.weight * cycle.level(p);
                assert!((cycle.slope(p).length_squared() - square).abs() < 1e-13);
                assert!(cycle.at(cycle.place(on)).distance(on) < 1e-14);
                let exact = Cycle {
                    through: cycle.through.map(Dd::from),
                    normal: cycle.normal.map(Dd::from),
                    weight: Dd::from(cycle.weight),
                    size: Dd::from(cycle.size),
                };
                let far = exact.distance(p.map(Dd::from)).to_f64();
                assert!((far - expected).abs() < 1e-14);
            }
        }
    }
}

/// Travel is to the left of the normal, and u = 2/κ tan(φ/2).
#[test]
fn places_grow_with_travel() {
    let center = Point::new(0.3, -3.0);
    for radius in [3.0, -3.0] {
        let base = if radius < 0.0 { 4.5 } else { 1.4 };
        let cycle = flat(center, radius, base);
        for angle in [-0.4_f64, -0.1, 0.0, 0.25, 0.45] {
            let p = center + Vector::from_angle(base + angle) * radius;
            let u = 2.0 * radius * (0.5 * angle).tan();
            assert!((cycle.place(p).x - u).abs() < 1e-14);
            for other in [-0.3_f64, 0.2] {
                let q = center + Vector::from_angle(base + other) * radius;
                let turned = if (angle - other) * radius > 0.0 {
                    angle - other
                } else {
                    0.0
                };
                let bulge = cycle.bulge(cycle.place(q), cycle.place(p));
                assert!((bulge - (0.25 * turned).tan()).abs() < 1e-14);
            }
        }
    }
}

/// Crossings of lines, large circles and circles by their centres, in general position, lie on both cycles, and have the stated directions.
#[test]
fn crossings_are_on_both() {
    let p = Point::new;
    let of = |center: Point, radius: f64, at: f64| {
        let circle = move |q| off(center, radius, q);
        [flat(center, radius, at), Cycle::round(center, radius)]
            .map(|c| (c, Box::new(circle) as Box<dyn Fn(Point) -> f64>))
    };
    let straight = |through: Point, angle: f64| {
        let n = Vector::from_angle(angle);
        let level = move |q: Point| n.dot(q - through);
        (
            Cycle::line(through, n),
            Box::new(level) as Box<dyn Fn(Point) -> f64>,
        )
    };
    let mut all = vec![straight(p(0.1, 0.05), 0.9), straight(p(-0.2, 0.1), 2.2)];
    all.extend(of(p(0.3, -3.0), 3.0, 1.5));
    all.extend(of(p(0.25, -2.9), -3.1, 4.6));
    all.extend(of(p(-0.4, 4.6), -5.0, 4.9));
    all.extend(of(p(0.2, -0.1), -0.6, 1.0));
    all.extend(of(p(0.1, 0.1), 0.2, 1.0));
    let mut seen = 0;
    for (f, on_f) in &all {
        for (g, on_g) in &all {
            let roots = [true, false].map(|enters| f.at(f.crossed_by(g, enters)));
            for (enters, q) in [true, false].into_iter().zip(roots) {
                if core::ptr::eq(f, g) || !f.meets(g, 1e-12) || q.x.is_nan() || !q.is_finite() {
                    continue;
                }
                if f.is_line() && g.is_line() && (g.normal.dot(f.normal.left()) > 0.0) == enters {
                    continue;
                }
                // One circle, written twice.
                if f.is_one_with(g, 1e-12) {
                    continue;
                }
                assert!(
                    on_f(q).abs() < 1e-12 && on_g(q).abs() < 1e-12,
                    "{f:?} {g:?}"
                );
                let ahead = q + f.normal_at(q).left() * 1e-6;
                assert_eq!(on_g(ahead) < 0.0, enters, "{f:?} {g:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 60, "{seen}");
}

/// A slanted line crosses a very large circle where it crosses the tangent, up to second order; and rays meet it.
#[test]
fn crossings_are_exact_however_large_the_radius() {
    for radius in [1e3, 1e6, 1e9, -1e9] {
        let arc = Cycle::flat(Point::new(0.2, 0.1), Vector::new(0.0, 1.0), 1.0 / radius);
        let fall = |d: f64| d * d / (radius + (radius * radius - d * d).sqrt() * radius.signum());
        for (angle, enters) in [(0.4_f64, true), (-0.4, false)] {
            // A line through a point 0.7 to the left of the one by which the circle is written.
            let (sin, cos) = angle.sin_cos();
            let through = Point::new(0.2 - 0.7, 0.1);
            let line = Cycle::line(through, Vector::new(sin, cos));
            let p = arc.at(arc.crossed_by(&line, enters));
            let (mut x, mut y) = (through.x, through.y);
            for _ in 0..20 {
                y = 0.1 - fall(x - 0.2);
                x = through.x - (y - through.y) * cos / sin;
            }
            assert!(
                p.distance(Point::new(x, y)) < 1e-15,
                "{radius} {p:?} {x} {y}"
            );
        }
        let x = 0.7;
        let place = Point::new(0.2 + x, 0.1 - fall(x));
        for angle in [0.4, 1.5, 2.6, 4.0, 5.5] {
            let d = Vector::from_angle(angle);
            let met = arc.met(place - d * 0.9, d);
            assert!(met.iter().any(|t| (t - 0.9).abs() < 1e-14), "{met:?}");
        }
    }
}

/// Circles cross if the distance of their centres is between the difference and the sum of their radii.
#[test]
fn circles_that_just_touch_are_told_from_those_that_do_not() {
    const GAP: f64 = 1e-9;
    let center = Point::new(0.3, -3.0);
    for at in [1.2, 1.7, 1.5] {
        let arc = flat(center, 3.0, at);
        for radius in [0.5, -0.5] {
            for (distance, inside) in [(3.5, -1.0), (2.5, 1.0)] {
                for sign in [-1.0, 1.0] {
                    let other = center + Vector::from_angle(1.5) * (distance + sign * GAP);
                    let small = Cycle::round(other, radius);
                    assert_eq!(arc.meets(&small, 0.0), sign == inside);
                    assert_eq!(small.meets(&arc, 0.0), sign == inside);
                }
            }
        }
    }
}

/// Lines and circles are one if f64 could hardly separate them, and otherwise not.
#[test]
fn cycles_are_one_within_little() {
    const SAME: f64 = 1e-14;
    let is_one = |a: Cycle, b: Cycle| a.is_one_with(&b, SAME);
    let line = |angle: f64, x: f64, y: f64| {
        Cycle::line(Point::new(x, y), Vector::new(-angle.sin(), angle.cos()))
    };
    let circle = |x: f64, radius: f64| Cycle::round(Point::new(x, 0.0), radius);
    let first = line(0.0, 0.0, 0.0);
    assert!(is_one(first, line(1e-15, 0.7, 1e-15)));
    assert!(is_one(first, line(core::f64::consts::PI, -0.7, 0.0)));
    assert!(!is_one(first, line(1e-13, 0.0, 0.0)));
    assert!(!is_one(first, line(0.0, 0.0, 1e-13)));
    let first = circle(0.3, 0.5);
    assert!(is_one(first, circle(0.3, -0.5)));
    assert!(is_one(first, flat(Point::new(0.3, 0.0), -0.5, 0.7)));
    assert!(!is_one(first, circle(0.3 + 1e-13, 0.5)));
    assert!(!is_one(first, circle(0.3, 0.5 + 1e-13)));
    assert!(!is_one(first, line(0.0, 0.0, 0.0)));
}

/// One function of each kind; all of them cross each other at orientation 0.3.
fn functions() -> [ContactFunction; 6] {
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
        ContactFunction::FlatCircle {
            through: spiral(0.05, 0.1, 0.1, -0.1),
            normal: Vector::from_angle(-1.2),
            turns: false,
            radius: 9.0,
        },
        ContactFunction::FlatCircle {
            through: spiral(-0.1, 0.05, 0.15, 0.1),
            normal: Vector::from_angle(0.1),
            turns: true,
            radius: -20.0,
        },
    ]
}

/// Results of all formulas for cycles and pairs of them in one arithmetic, beginning with places at which they cross.
fn formulas<T: Real>(turn: Rotation<T>) -> Vec<Vector<T>> {
    let all = functions().map(|f| f.cycle(turn));
    let p = (turn * Vector::new(0.4, -0.3).map(T::constant)).map(|x| x + T::constant(0.2));
    let p = Point::new(p.x, p.y);
    let mut found = Vec::new();
    for (i, f) in all.iter().enumerate() {
        let place = f.place(p);
        let middle = Vector::new(1.0, 0.0).map(T::constant);
        found.extend([
            Vector::new(f.level(p), f.distance(p)),
            f.slope(p),
            f.arm(p),
            place,
            f.at(place) - f.through,
            Vector::new(f.rank(place, middle), f.curvature()),
        ]);
        for (j, g) in all.iter().enumerate().filter(|(j, _)| *j != i) {
            for root in 0..if f.is_line() && g.is_line() { 1 } else { 2 } {
                found.push(f.root(g, root, false));
            }
            if i < j {
                found.extend([
                    Vector::new(f.apart(g), f.total(g)),
                    Vector::new(f.still_about(g, p), f.total(g)),
                    f.between(g),
                ]);
                // Two lines have a common normal only where they are parallel.
                if !(f.is_line() && g.is_line()) {
                    let unit = f.common_normal(g);
                    let supports = Vector::new(f.beside(g, unit), f.support(p, unit));
                    found.extend([unit, supports, Vector::new(f.gap(g), f.gap(g))]);
                }
            }
        }
    }
    found
}

#[test]
fn slopes_agree_with_differences_and_enclosures_hold_both() {
    const THETA: f64 = 0.3;
    const WIDTH: f64 = 1e-3;
    let at = |theta: f64| formulas(Rotation::by(theta));
    let slopes = |theta: f64| formulas(Rotation::by(Dual::<1>::variable(theta, 0)));
    let around = Ball::between(THETA - WIDTH, THETA + WIDTH);
    let balls = formulas(Rotation::by(around));
    let jets = formulas(Rotation::by(Dual::<1, _>::variable(around, 0)));
    let exact = formulas(Rotation::by(Dd::from(THETA)));
    for (i, (ball, exact)) in balls.iter().zip(&exact).enumerate() {
        for (ball, exact) in [(ball.x, exact.x), (ball.y, exact.y)] {
            let off = (exact - ball.mid).to_f64().abs();
            assert!(off <= ball.radius, "{i} {ball:?} {exact:?}");
        }
    }
    let h = 1e-5;
    for k in -4..=4 {
        let theta = THETA + WIDTH * f64::from(k) / 4.0;
        let (here, below, above) = (at(theta), at(theta - h), at(theta + h));
        for (i, d) in slopes(theta).into_iter().enumerate() {
            let ends = [
                (here[i].x, below[i].x, above[i].x),
                (here[i].y, below[i].y, above[i].y),
            ];
            let jet = [jets[i].x, jets[i].y];
            for (j, (d, ball)) in [(d.x, balls[i].x), (d.y, balls[i].y)]
                .into_iter()
                .enumerate()
            {
                let (value, lo, hi) = ends[j];
                assert!((d.value - value).abs() < 1e-12 * (1.0 + value.abs()));
                assert!(
                    (d.slope[0] - (hi - lo) / (2.0 * h)).abs() < 1e-7,
                    "{i} {j} {d:?}"
                );
                assert!((ball.mid - value).abs() <= ball.radius);
                assert!((jet[j].value.mid - value).abs() <= jet[j].value.radius);
                assert!((jet[j].slope[0].mid - d.slope[0]).abs() <= jet[j].slope[0].radius);
                let wide = (ball.radius, jet[j].slope[0].radius);
                let size = 1.0 + value.abs() + d.slope[0].abs();
                assert!(
                    wide.0 < 0.1 * size && wide.1 < 0.5 * size,
                    "{i} {j} {wide:?}"
                );
            }
        }
    }
}

/// A cycle that is `PLACE_ERROR` off moves a crossing by that over the sine of the angle.
#[test]
fn errors_of_places_grow_as_crossings_get_flat() {
    let p = Point::new;
    let f = line(p(0.1, 0.2), 0.3);
    let c = circle(p(0.4, -0.3), 0.8, 0.5, 1.0);
    let d = circle(p(0.0, 0.3), -0.5, 0.5, 1.0);
    for sine in [1.0_f64, 0.5, 1e-3] {
        let g = line(p(0.5, 0.1), 0.3 + sine.asin());
        let place = f.cycle.root(&g.cycle, 0, false);
        let error = f.cycle.place_error(&g.cycle, place);
        assert!((error * sine / PLACE_ERROR - 1.0).abs() < 1e-6, "{sine}");
    }
    for (f, g) in [(&f, &c), (&c, &f), (&f, &d), (&d, &f), (&c, &d), (&d, &c)] {
        for root in 0..2 {
            let at = crossing(f, g, root).unwrap().point;
            let place = f.cycle.root(&g.cycle, root, false);
            let sine = f.normal(at).cross(g.normal(at)).abs();
            let error = f.cycle.place_error(&g.cycle, place);
            // The place is on the circle up to rounding.
            assert!((error * sine / PLACE_ERROR - 1.0).abs() < 0.1);
        }
    }
}

/// Where two cycles that bend apart by a curvature b are tangent, moving one by δ moves the crossing by √(2δ/b).
#[test]
fn errors_of_places_are_bounded_at_tangencies() {
    // A circle of radius r about the origin and another of radius s, tangent at (r, 0), or a line there.
    let r = 0.8;
    let about = |center: f64, radius: f64| Cycle::round(Point::new(center, 0.0), radius);
    let upright = Cycle::line(Point::new(r, 0.0), Vector::new(1.0, 0.0));
    // Second cycle, and how much it bends away from the first.
    for (other, bend) in [
        (upright, 1.0 / r),
        (about(r + 0.5, 0.5), 1.0 / r + 2.0),
        (about(r + 0.5, -0.5), 1.0 / r + 2.0),
        (about(r - 0.5, 0.5), 2.0 - 1.0 / r),
        (about(r - 0.5, -0.5), 2.0 - 1.0 / r),
    ] {
        for sign in [1.0, -1.0] {
            let error = about(0.0, sign * r).place_error(&other, Vector::new(r, 0.0));
            let expected = (2.0 * PLACE_ERROR / bend).sqrt();
            assert!(
                (error / expected - 1.0).abs() < 1e-6,
                "{other:?}: {error} {expected}"
            );
        }
    }
    let error = upright.place_error(&about(r + 0.5, 0.5), Vector::ZERO);
    assert!((error / PLACE_ERROR.sqrt() - 1.0).abs() < 1e-6);
}

#[test]
fn errors_of_places_are_at_least_how_far_they_are_off() {
    let circle = Cycle::round(Point::new(0.1, 0.2), -0.5);
    let across = Cycle::line(Point::new(0.0, 0.2), Vector::new(0.0, 1.0));
    let error = circle.place_error(&across, Vector::new(0.4, 0.0));
    assert!((error - 0.1).abs() < 1e-12);
    // One line, twice: the crossing has no place.
    assert_eq!(across.place_error(&across, Vector::ZERO), f64::INFINITY);
    let unknown = Vector::new(f64::NAN, 0.0);
    assert_eq!(circle.place_error(&across, unknown), f64::INFINITY);
}

//! The plane as complex numbers: the operations on points are compared with products and quotients of these.

use core::f64::consts::{PI, TAU};

use super::*;

/// (a + bi)(c + di)
fn product((a, b): (f64, f64), (c, d): (f64, f64)) -> (f64, f64) {
    (a * c - b * d, a * d + b * c)
}

fn conjugate((a, b): (f64, f64)) -> (f64, f64) {
    (a, -b)
}

fn is_near(a: (f64, f64), b: (f64, f64)) -> bool {
    (a.0 - b.0).abs() < 1e-14 && (a.1 - b.1).abs() < 1e-14
}

#[test]
fn sums_and_differences_are_taken_by_coordinate() {
    let (p, q) = (Point::new(7.0, -2.0), Point::new(4.0, 5.0));
    let (v, w) = (Vector::new(3.0, -7.0), Vector::new(0.5, 11.0));
    assert_eq!(p - q, v);
    assert_eq!(q + v, p);
    assert_eq!(p - v, q);
    let mut moved = q;
    moved += v;
    assert_eq!(moved, p);
    assert_eq!(v + w, Vector::new(3.5, 4.0));
    assert_eq!(v - w, Vector::new(2.5, -18.0));
    assert_eq!(-v, Vector::new(-3.0, 7.0));
    assert_eq!(v * 2.0, Vector::new(6.0, -14.0));
    assert_eq!(p.to_vector(), p - Point::ORIGIN);
    assert_eq!(p.midpoint(q), Point::new(5.5, 1.5));
    assert_eq!(p.lerp(q, 0.25), Point::new(6.25, -0.25));
}

#[test]
fn lengths_are_those_of_pythagorean_triples() {
    assert_eq!(Vector::new(-5.0, 12.0).length(), 13.0);
    assert_eq!(Vector::new(-5.0, 12.0).length_squared(), 169.0);
    assert_eq!(Point::new(1.0, 2.0).distance(Point::new(9.0, -13.0)), 17.0);
    let unit = Vector::new(8.0, -15.0).unit();
    assert!(is_near((unit.x, unit.y), (8.0 / 17.0, -15.0 / 17.0)));
}

/// The conjugate of one number times another has the inner product as its real part, the signed area as its imaginary.
#[test]
fn products_are_those_of_complex_numbers() {
    let (v, w) = (Vector::new(3.0, -7.0), Vector::new(2.0, 11.0));
    let both = product(conjugate((v.x, v.y)), (w.x, w.y));
    assert_eq!((v.dot(w), v.cross(w)), both);
    let left = product((0.0, 1.0), (v.x, v.y));
    assert_eq!((v.left().x, v.left().y), left);
    let right = product((0.0, -1.0), (v.x, v.y));
    assert_eq!((v.right().x, v.right().y), right);
}

#[test]
fn angles_are_those_of_known_triangles() {
    use core::f64::consts::{FRAC_PI_3, FRAC_PI_6, PI};
    let half_root = 0.75_f64.sqrt();
    let v = Vector::from_angle(FRAC_PI_3);
    assert!(is_near((v.x, v.y), (0.5, half_root)));
    assert!((Vector::new(-half_root, -0.5).angle() + 5.0 * FRAC_PI_6).abs() < 1e-15);
    assert_eq!(Vector::new(-2.0, 0.0).angle(), PI);
}

#[test]
fn a_point_is_finite_if_both_coordinates_are() {
    assert!(Point::new(1.0, -2.0).is_finite());
    assert!(!Point::new(f64::NAN, 0.0).is_finite());
    assert!(!Point::new(0.0, f64::INFINITY).is_finite());
}

/// A rotation multiplies by (3 + 4i) / 5, a configuration adds its position as well.
#[test]
fn rotations_and_configurations_are_complex_maps() {
    let angle = 4.0_f64.atan2(3.0);
    let turn = Rotation::by(angle);
    let (p, z) = (Point::new(2.0, -7.0), (0.6, 0.8));
    let turned = product(z, (p.x, p.y));
    assert!(is_near(((turn * p).x, (turn * p).y), turned));
    let v = turn * p.to_vector();
    assert!(is_near((v.x, v.y), turned));
    let back = turn.inverse() * p;
    assert!(is_near((back.x, back.y), product(conjugate(z), (p.x, p.y))));
    assert_eq!(Rotation::IDENTITY * p, p);

    let c = Configuration::new(10.0, -20.0, angle);
    assert_eq!(c.position(), Point::new(10.0, -20.0));
    let placed = c.fixed_from_moving(p);
    assert!(is_near(
        (placed.x, placed.y),
        (turned.0 + 10.0, turned.1 - 20.0)
    ));
    let home = c.inverse().fixed_from_moving(placed);
    assert!(is_near((home.x, home.y), (p.x, p.y)));
    assert_eq!(c.inverse().theta, -angle);
}

#[test]
fn composed_configurations_take_points_one_after_the_other() {
    let c_from_b = Configuration::new(10.0, -20.0, 2.5);
    let b_from_a = Configuration::new(-3.0, 0.25, 5.0);
    let (p, c_from_a) = (Point::new(2.0, -7.0), c_from_b.compose(b_from_a));
    let by_steps = c_from_b.fixed_from_moving(b_from_a.fixed_from_moving(p));
    let at_once = c_from_a.fixed_from_moving(p);
    assert!(is_near((at_once.x, at_once.y), (by_steps.x, by_steps.y)));
    // More than a turn stays more than a turn.
    assert_eq!(c_from_a.theta, 7.5);

    let back = c_from_a.inverse().compose(c_from_a);
    assert!(is_near((back.x, back.y), (0.0, 0.0)) && back.theta == 0.0);
    assert_eq!(Configuration::IDENTITY.compose(c_from_b), c_from_b);
    assert_eq!(c_from_b.compose(Configuration::IDENTITY), c_from_b);
}

#[test]
fn numbers_come_in_and_go_out_in_order() {
    let c = Configuration::new(1.0, -2.5, 0.125);
    assert_eq!(Configuration::from((1.0, -2.5, 0.125)), c);
    assert_eq!(Configuration::from([1.0, -2.5, 0.125]), c);
    assert_eq!(<[f64; 3]>::from(c), [1.0, -2.5, 0.125]);
    assert_eq!(<(f64, f64, f64)>::from(c), (1.0, -2.5, 0.125));
    let (p, v) = (Point::new(1.0, 2.0), Vector::new(3.0, 4.0));
    assert_eq!((Point::from((1.0, 2.0)), Point::from([1.0, 2.0])), (p, p));
    assert_eq!((Vector::from((3.0, 4.0)), Vector::from([3.0, 4.0])), (v, v));
    assert_eq!(
        (<[f64; 2]>::from(p), <(f64, f64)>::from(p)),
        ([1.0, 2.0], (1.0, 2.0))
    );
    assert_eq!(
        (<[f64; 2]>::from(v), <(f64, f64)>::from(v)),
        ([3.0, 4.0], (3.0, 4.0))
    );
}

#[test]
fn text_has_the_precision_asked_for() {
    assert_eq!(Point::new(1.0, -2.5).to_string(), "(1, -2.5)");
    assert_eq!(format!("{:.2}", Vector::new(1.0, -2.5)), "(1.00, -2.50)");
    let c = Configuration::new(1.0, -2.5, 0.125);
    assert_eq!(c.to_string(), "(1, -2.5, 0.125 rad)");
    assert_eq!(format!("{c:.1}"), "(1.0, -2.5, 0.1 rad)");
}

#[test]
fn angles_are_brought_home() {
    for (angle, home) in [
        (0.5, 0.5),
        (0.5 + TAU, 0.5),
        (-0.5 - 2.0 * TAU, -0.5),
        (4.0, 4.0 - TAU),
    ] {
        assert!((wrap(angle) - home).abs() < 1e-14, "{angle}");
    }
    assert_eq!((wrap(PI), wrap(-PI), wrap(3.0 * PI)), (PI, PI, PI));
}

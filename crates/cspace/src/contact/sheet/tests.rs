//! Relations between sheets that are known without computing, compared with distances at many orientations.

use super::super::spiral::Spiral;
use super::*;
use crate::feature::tolerance::{LEAST_WISH, MOVING_PERTURBATION};
use crate::geometry::{Point, Vector};

fn spiral(u: (f64, f64), w: (f64, f64)) -> Spiral {
    Spiral::new(Point::new(u.0, u.1), Vector::new(w.0, w.1))
}

fn end(name: u32) -> SheetEnd {
    let at = EndAt::Fixed(0);
    SheetEnd {
        at,
        name,
        angle: 0.0,
    }
}

/// A sheet with its own end names, starting at four times `number`.
fn sheet(locus: Locus, number: u32) -> Sheet {
    Sheet {
        locus,
        fixed: number,
        moving: number,
        lo: -3.0,
        hi: 3.0,
        from: Dd::from(-3.0),
        to: Dd::from(3.0),
        start: end(4 * number),
        end: end(4 * number + 1),
        bottom: Seam::Window,
        top: Seam::Window,
    }
}

/// A circle about a spiral.
pub(in crate::contact) fn round(number: u32, u: (f64, f64), w: (f64, f64), radius: f64) -> Sheet {
    let through = spiral(u, w);
    let locus = Locus {
        carrier: Carrier {
            kind: SheetKind::RoundRound,
            through,
            normal: Vector::ZERO,
            radius,
        },
        start: through,
        end: through,
    };
    sheet(locus, number)
}

/// A line through a spiral, whose normal has a given angle in the fixed or in the moving part's frame.
pub(in crate::contact) fn straight(
    number: u32,
    kind: SheetKind,
    angle: f64,
    through: Spiral,
) -> Sheet {
    let locus = Locus {
        carrier: Carrier {
            kind,
            through,
            normal: Vector::from_angle(angle),
            radius: 0.0,
        },
        start: through,
        end: through,
    };
    sheet(locus, number)
}

/// Largest deviation of the carriers of two sheets from being tangent, or one, over many orientations.
fn furthest_from_tangent(f: &Sheet, g: &Sheet) -> f64 {
    let off = |turn: Rotation| match (f.is_circle(), g.is_circle()) {
        (true, true) => {
            let apart = f
                .locus
                .carrier
                .through
                .at(turn)
                .distance(g.locus.carrier.through.at(turn));
            let (r, s) = (f.locus.carrier.radius.abs(), g.locus.carrier.radius.abs());
            (apart - (r + s)).abs().min((apart - (r - s).abs()).abs())
        }
        (false, true) => {
            let n = f.locus.carrier.normal_at(turn);
            (n.dot(g.locus.carrier.through.at(turn) - f.locus.start.at(turn))
                .abs()
                - g.locus.carrier.radius.abs())
            .abs()
        }
        _ => panic!("a line comes first"),
    };
    (0..50)
        .map(|k| off(Rotation::by(0.125 * f64::from(k))))
        .fold(0.0, f64::max)
}

#[test]
fn what_is_always_tangent_is_told() {
    let (line, turning) = (SheetKind::LineRound, SheetKind::RoundLine);
    let across = Vector::from_angle(0.7);
    let beside = |by: f64| (0.1 + by * across.x, 0.2 + by * across.y);
    let here = (0.1, 0.2);
    let still = spiral(here, (0.3, -0.1));
    let seen_turning = spiral((0.3, -0.1), here);
    let mut told = [0, 0];
    for (f, g) in [
        // Two circles whose centres differ by a constant vector, by a turning one, or by both.
        (
            round(0, here, (0.3, 0.0), 0.5),
            round(1, beside(0.8), (0.3, 0.0), 0.3),
        ),
        (
            round(0, here, (0.3, 0.0), 0.5),
            round(1, beside(0.2), (0.3, 0.0), -0.3),
        ),
        (
            round(0, here, (0.3, 0.0), -0.3),
            round(1, beside(0.2), (0.3, 0.0), 0.5),
        ),
        (round(0, here, here, 0.5), round(1, here, beside(0.8), 0.3)),
        (round(0, here, here, 0.5), round(1, here, beside(-0.2), 0.3)),
        (
            round(0, here, here, 0.5),
            round(1, beside(0.8), beside(0.1), 0.3),
        ),
        (
            round(0, here, here, 0.5),
            round(1, beside(0.4), beside(0.4), 0.3),
        ),
        (
            round(0, here, (0.3, 0.0), 0.5),
            round(1, beside(0.7), (0.3, 0.0), 0.3),
        ),
        (
            round(0, here, (0.3, 0.0), 0.5),
            round(1, beside(0.8 + 1e-9), (0.3, 0.0), 0.3),
        ),
        // A line of either kind, and a circle at its distance that moves with it, or not.
        (
            straight(0, line, 0.7, still),
            round(1, beside(0.5), (0.3, -0.1), 0.5),
        ),
        (
            straight(0, line, 0.7, still),
            round(1, beside(-0.5), (0.3, -0.1), -0.5),
        ),
        (
            straight(0, line, 0.7, still),
            round(1, beside(0.4), (0.3, -0.1), 0.5),
        ),
        (
            straight(0, line, 0.7, still),
            round(1, beside(0.5), (0.3, -0.2), 0.5),
        ),
        (
            straight(0, turning, 0.7, seen_turning),
            round(1, (0.3, -0.1), beside(0.5), 0.5),
        ),
        (
            straight(0, turning, 0.7, seen_turning),
            round(1, (0.3, -0.1), beside(-0.5), 0.5),
        ),
        (
            straight(0, turning, 0.7, seen_turning),
            round(1, (0.3, -0.1), beside(0.6), 0.5),
        ),
        (
            straight(0, turning, 0.7, seen_turning),
            round(1, (0.3, -0.2), beside(0.5), 0.5),
        ),
    ] {
        let tangent = furthest_from_tangent(&f, &g) < 1e-14;
        assert_eq!(f.always_tangent(&g), tangent, "{f:?} {g:?}");
        assert_eq!(g.always_tangent(&f), tangent, "{f:?} {g:?}");
        assert_eq!(f.shared_ends(&g, u32::MAX).tangent, tangent);
        told[usize::from(tangent)] += 1;
    }
    assert!(told[0] >= 7 && told[1] >= 7, "{told:?}");
    let (a, b) = (straight(0, line, 0.7, still), straight(1, line, 0.7, still));
    assert!(!a.always_tangent(&b));
}

#[test]
fn one_circle_is_told_whatever_its_sign() {
    let f = round(0, (0.1, 0.2), (0.3, -0.1), 0.5);
    // The least that a vertex is moved, and rounding.
    let moved = LEAST_WISH * MOVING_PERTURBATION;
    let rounded = 2.0 * f64::EPSILON;
    for (g, same) in [
        (round(1, (0.1, 0.2), (0.3, -0.1), 0.5 + moved), false),
        (round(1, (0.1 - moved, 0.2), (0.3, -0.1), 0.5), false),
        (round(1, (0.1, 0.2), (0.3, -0.1 + moved), 0.5), false),
        (
            round(
                1,
                (0.1 + rounded, 0.2 - rounded),
                (0.3, -0.1),
                0.5 + rounded,
            ),
            true,
        ),
        (round(1, (0.1, 0.2), (0.3, -0.1), 0.5), true),
        (round(1, (0.1, 0.2), (0.3, -0.1), -0.5), true),
        (round(1, (0.1, 0.2), (0.3, -0.1), 0.5 + 1e-9), false),
        (round(1, (0.1, 0.2), (0.3, -0.1), 0.5 - 1e-9), false),
        (round(1, (0.1, 0.2 + 1e-9), (0.3, -0.1), 0.5), false),
        (round(1, (0.1, 0.2), (0.3 + 1e-9, -0.1), 0.5), false),
    ] {
        assert_eq!(f.always_tangent(&g), same, "{g:?}");
        assert_eq!(f.shared_ends(&g, u32::MAX).tangent, same);
    }
    let line = straight(
        1,
        SheetKind::LineRound,
        0.0,
        spiral((0.1, 0.2), (0.3, -0.1)),
    );
    assert!(!f.always_tangent(&line) && !line.always_tangent(&f));
}

#[test]
fn lines_are_parallel_if_their_normals_are_and_turn_alike() {
    let at = spiral((0.1, 0.2), (0.3, -0.1));
    let (line, turning) = (SheetKind::LineRound, SheetKind::RoundLine);
    let f = straight(0, line, 0.7, at);
    assert!(f.is_parallel(&straight(1, line, 0.7, at)));
    assert!(f.is_parallel(&straight(1, line, 0.7 - core::f64::consts::PI, at)));
    assert!(!f.is_parallel(&straight(1, line, 0.7 + 1e-9, at)));
    assert!(!f.is_parallel(&straight(1, turning, 0.7, at)));
    let circle = round(0, (0.1, 0.2), (0.3, -0.1), 0.5);
    assert!(!circle.is_parallel(&circle));
}

#[test]
fn shared_ends_are_those_with_one_name() {
    let (a, b) = (
        spiral((0.0, 0.0), (0.1, 0.0)),
        spiral((1.0, 0.0), (0.2, 0.0)),
    );
    let mut f = straight(0, SheetKind::LineRound, 0.7, a);
    f.locus.end = b;
    let g = straight(1, SheetKind::LineRound, 0.2, b);
    let with = |start_name, end_name| Sheet {
        start: end(start_name),
        end: end(end_name),
        ..g
    };
    let shared = |g: &Sheet, first_vertex| f.shared_ends(g, first_vertex);
    assert_eq!(shared(&g, 0).corners, [false; 2]);
    assert!(!shared(&g, 0).tangent);
    // First the end of f is the start of g; then the start of f the end of g; then both.
    for (g, corners) in [
        (with(1, 9), [true, false]),
        (with(9, 0), [false, true]),
        (with(1, 0), [true, true]),
    ] {
        let crossing = shared(&g, 0);
        assert_eq!((crossing.tangent, crossing.corners), (false, corners));
        let smooth = shared(&g, 2);
        assert_eq!((smooth.tangent, smooth.corners), (true, [false; 2]));
    }
    // Names from the first vertex name on belong to vertices.
    assert!(shared(&with(1, 9), 2).tangent && !shared(&with(1, 9), 1).tangent);
    let same_features = Sheet {
        fixed: f.fixed,
        moving: f.moving,
        ..g
    };
    assert!(shared(&same_features, 0).tangent);
    assert!(
        !shared(&Sheet { fixed: 0, ..g }, 0).tangent
            && !shared(&Sheet { moving: 0, ..g }, 0).tangent
    );
}

/// The curve lies where the contact function vanishes, with its free side where the function is positive.
#[test]
fn curves_are_zeros_of_the_contact_function() {
    let through = spiral((0.1, 0.2), (0.3, -0.1));
    let theta = 0.4;
    let turn = Rotation::by(theta);
    for kind in [SheetKind::LineRound, SheetKind::RoundLine] {
        let mut s = straight(0, kind, 0.7, through);
        let turned = if kind == SheetKind::RoundLine {
            theta
        } else {
            0.0
        };
        let curve = s.curve(theta, turn);
        let normal = curve.normal(curve.start);
        assert!((normal - Vector::from_angle(0.7 + turned)).length() < 1e-15);
        s.locus.end = spiral((0.0, 0.0), (0.0, 0.0));
        let p = through.at(turn) + normal.left() * 0.8 + normal * 0.01;
        assert!((s.function().value(p, theta) - 0.01).abs() < 1e-15);
        assert_eq!(s.curve(theta, turn).end, Point::ORIGIN);
    }
    for radius in [0.5, -0.5] {
        let mut s = round(0, (0.1, 0.2), (0.3, -0.1), radius);
        // Travel is clockwise about a concave arc.
        let (low, high) = (
            SheetEnd {
                angle: 0.2,
                ..s.start
            },
            SheetEnd {
                at: EndAt::Moving(0),
                angle: 1.0,
                ..s.end
            },
        );
        (s.start, s.end) = if radius > 0.0 {
            (low, high)
        } else {
            (high, low)
        };
        let curve = s.curve(theta, turn);
        assert!((curve.half - 0.5 * 0.5 * (1.0 + theta - 0.2)).abs() < 1e-15);
        let middle = curve.point(0.0);
        let center = through.at(turn);
        assert!(
            ((middle - center) * (1.0 / radius) - Vector::from_angle(0.5 * (1.2 + theta))).length()
                < 1e-14
        );
        for at in [-0.2, 0.0, 0.2].map(|s| curve.point(s)) {
            let p = at + curve.normal(at) * 0.01;
            assert!((s.function().value(p, theta) - 0.01).abs() < 1e-15);
        }
    }
}

/// For almost concentric circles, the vector from one centre to the other is known to its own last bits.
#[test]
fn close_circles_are_seen_from_one_of_them() {
    let f = round(1, (0.7, 0.3), (3e-9, 0.0), -0.25);
    let g = round(2, (0.7, 0.3), (0.0, 2e-9), -0.25);
    let (origin, apart) = f.close_to(&g).unwrap();
    assert!((apart / 13f64.sqrt() - 1e-9).abs() < 1e-23);
    let turn = Rotation::by(0.3);
    let center = |s: &Sheet| s.locus.about(&origin).carrier.through.at(turn).to_vector();
    let seen = center(&g);
    let expected = turn * Vector::new(-3e-9, 2e-9);
    assert!((seen - expected).length() < 1e-24);
    assert!(center(&f).length() < 1e-24);
    let ends = g.locus.about(&origin).start.at(turn)
        - (g.locus.start.at(turn) - origin.at(turn).to_vector());
    assert!(ends.length() < 1e-15);
    // Equal centres, distant centres, or a line.
    assert_eq!(f.close_to(&f), None);
    assert_eq!(f.close_to(&round(2, (0.7, 0.3), (0.1, 0.0), -0.25)), None);
    let line = straight(3, SheetKind::LineRound, 0.1, spiral((0.0, 0.0), (0.0, 0.0)));
    assert_eq!(f.close_to(&line), None);
}

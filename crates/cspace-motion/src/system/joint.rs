//! Joints as equations between the coordinates of two parts.

use cspace::pair::Joint;
use cspace::{Point, Real};

use super::layout::{Derived, PartCoordinates, row_of};
use super::row::Row;

/// The equations of a joint between two parts: 0 where it holds, in the model's unit of length. `size` is the length that
/// an angle of one radian counts.
pub(crate) fn equations(
    joint: &Joint,
    parts: [&PartCoordinates; 2],
    q: &[f64],
    size: f64,
) -> Vec<Row> {
    let real = |p: Point| [Derived::constant(p.x), Derived::constant(p.y)];
    let together = |p: Point, k: usize| {
        row_of(parts, q, move |a, b| {
            a.point(real(p))[k] - b.point(real(p))[k]
        })
    };
    let parallel = || {
        row_of(parts, q, |a, b| {
            Derived::constant(size) * (a.sin * b.cos - a.cos * b.sin)
        })
    };
    match *joint {
        Joint::Revolute { at } => vec![together(at, 0), together(at, 1)],
        Joint::Rigid => vec![
            together(Point::ORIGIN, 0),
            together(Point::ORIGIN, 1),
            parallel(),
        ],
        Joint::Prismatic { direction, at } => {
            let normal = direction.unit().left();
            let beside = row_of(parts, q, |a, b| {
                let n = a.vector([Derived::constant(normal.x), Derived::constant(normal.y)]);
                let (p, r) = (a.point(real(at)), b.point(real(at)));
                n[0] * (r[0] - p[0]) + n[1] * (r[1] - p[1])
            });
            vec![parallel(), beside]
        }
    }
}

//! Joints as equations between the coordinates of two parts.

use cspace::pair::Joint;
use cspace::{Placement, Point, Real, Vector};

use super::layout::{PartCoordinates, Placed, rows_of};
use super::row::Row;

fn real<T: Real>(p: Point) -> [T; 2] {
    [T::constant(p.x), T::constant(p.y)]
}

/// Position of a point of the first part minus that of a point of the second, along x and along y.
pub(super) struct Apart(pub(super) [Point; 2]);

impl Placed<2> for Apart {
    fn values<T: Real>(&self, a: &Placement<T>, b: &Placement<T>) -> [T; 2] {
        let (p, r) = (a.point(real(self.0[0])), b.point(real(self.0[1])));
        [p[0] - r[0], p[1] - r[1]]
    }
}

/// Orientation of the second part minus that of the first, as the displacement at the end of a length.
struct Parallel(f64);

impl Placed<1> for Parallel {
    fn values<T: Real>(&self, a: &Placement<T>, b: &Placement<T>) -> [T; 1] {
        [T::constant(self.0) * (a.cos * b.sin - a.sin * b.cos)]
    }
}

/// Distance of a line of the first part from a point of the second.
struct Beside {
    at: Point,
    normal: Vector,
}

impl Placed<1> for Beside {
    fn values<T: Real>(&self, a: &Placement<T>, b: &Placement<T>) -> [T; 1] {
        let n = a.vector([T::constant(self.normal.x), T::constant(self.normal.y)]);
        let (p, r) = (a.point(real(self.at)), b.point(real(self.at)));
        [n[0] * (p[0] - r[0]) + n[1] * (p[1] - r[1])]
    }
}

/// The equations of a joint between two parts, 0 where it holds, in the model's unit of length: the distances of a point of
/// the first part from that of the second, across the directions in which they are free, and last the difference of the
/// parts' orientations. `size` is the length that an angle of one radian counts.
pub(crate) fn equations<T: Real>(
    joint: &Joint,
    parts: [&PartCoordinates; 2],
    q: &[T],
    size: f64,
) -> Vec<Row<T>> {
    match *joint {
        Joint::Revolute { at } => rows_of(parts, q, &Apart([at, at])).to_vec(),
        Joint::Prismatic { direction, at } => {
            let normal = direction.unit().left();
            let [beside] = rows_of(parts, q, &Beside { at, normal });
            let [parallel] = rows_of(parts, q, &Parallel(size));
            vec![beside, parallel]
        }
    }
}

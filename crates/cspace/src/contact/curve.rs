//! A contact curve of one slice: a directed segment or arc with blocked space on its left.

use crate::feature::tolerance::{JOINT, WIDEST_ARC};
use crate::geometry::{Point, Rotation, Vector};
use crate::number::{Dd, Ordered};
use crate::part::Bounds;

use super::cycle::Cycle;

/// A directed segment or arc; free space, if any, is on the right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Curve<T = f64> {
    pub(crate) start: Point<T>,
    pub(crate) end: Point<T>,
    pub(crate) cycle: Cycle<T>,
    /// The place of its middle: for a circle given by its centre, the approximate direction to the middle, of length about one.
    pub(crate) middle: Vector<T>,
    /// Half its length.
    pub(crate) half: f64,
}

impl<T: Ordered> Curve<T> {
    /// A curve from its ends, and the angles of the contact normal there, which are needed only for a circle given by its centre (radians).
    pub(crate) fn new(cycle: Cycle<T>, [start, end]: [Point<T>; 2], [from, to]: [f64; 2]) -> Self {
        let (middle, half) = if cycle.is_centred() {
            let direction = Vector::from_angle(0.5 * (from + to)) * cycle.weight.value();
            let half = 0.5 * (to - from).abs() * cycle.size.value();
            (direction.map(T::constant), half)
        } else {
            let [from, to] = [start, end].map(|p| cycle.place(p).x);
            let middle = T::constant(0.5) * (from + to);
            let half = 0.5 * (to - from).value().max(0.0);
            (Vector::new(middle, T::constant(0.0)), half)
        };
        Self {
            start,
            end,
            cycle,
            middle,
            half,
        }
    }

    /// Length of travel from about the middle of the curve to a place of its cycle.
    #[inline]
    pub(crate) fn length_to(&self, place: Vector<T>) -> T {
        if self.cycle.is_centred() {
            let (x, y) = (self.middle.dot(place), self.middle.cross(place));
            return y.atan2(x) * self.cycle.radius();
        }
        place.x - self.middle.x
    }

    /// Length of travel from about the middle of the curve to a point of it.
    #[inline]
    pub(crate) fn position(&self, p: Point<T>) -> T {
        self.length_to(self.cycle.place(p))
    }

    /// The point at a length of travel from about the middle.
    #[inline]
    pub(crate) fn point(&self, length: T) -> Point<T> {
        if self.cycle.is_centred() {
            let arm = Rotation::by(length / self.cycle.radius()) * self.middle;
            return self.cycle.through + arm * (self.cycle.size / arm.length());
        }
        let place = Vector::new(length + self.middle.x, T::constant(0.0));
        self.cycle.at(place)
    }

    /// A number that increases with the length of travel to a place: see [`Cycle::rank`].
    #[inline]
    pub(crate) fn rank(&self, place: Vector<T>) -> T {
        self.cycle.rank(place, self.middle)
    }

    /// Lengths of travel from about the middle to both ends.
    pub(crate) fn ends(&self) -> (T, T) {
        self.ends_by(|place| self.length_to(place))
    }

    /// Values of `number` at the ends; it must increase with the length of travel, and be odd about the middle.
    fn ends_by(&self, number: impl Fn(Vector<T>) -> T) -> (T, T) {
        let [start, end] = [self.start, self.end].map(|p| number(self.cycle.place(p)));
        // A whole circle ends where it starts, half a turn from the middle.
        if !self.cycle.is_centred() || start <= end {
            (start, end)
        } else if start.abs() > end.abs() {
            (-start.abs(), end)
        } else {
            (start, end.abs())
        }
    }

    /// Whether a place of its cycle lies between its ends.
    pub(crate) fn holds(&self, place: Vector<T>) -> bool {
        let (rank, (lo, hi)) = (self.rank(place), self.ends_by(|v| self.rank(v)));
        lo < rank && rank < hi
    }

    /// Whether a point beside the curve is on its free side; `None` for a point beyond its ends.
    pub(crate) fn is_free(&self, p: Point<T>) -> Option<bool> {
        self.holds(self.cycle.place(p))
            .then(|| self.cycle.level(p).value() >= 0.0)
    }

    /// Signed distance, outward along a direction from a point, at which its line or circle lies, to first order near that point.
    pub(crate) fn height(&self, p: Point<T>, outward: Vector<T>) -> T {
        -self.cycle.distance(p) / self.cycle.normal_at(p).dot(outward)
    }

    /// The unit normal towards the free side at a point of the curve.
    #[inline]
    pub(crate) fn normal(&self, p: Point<T>) -> Vector<T> {
        self.cycle.normal_at(p)
    }
}

impl Curve<Dd> {
    /// The curve rounded to f64.
    pub(crate) fn rounded(&self) -> Curve {
        Curve {
            start: self.start.map(Dd::to_f64),
            end: self.end.map(Dd::to_f64),
            cycle: self.cycle.rounded(),
            middle: self.middle.map(Dd::to_f64),
            half: self.half,
        }
    }
}

impl Curve {
    /// The curve turned, then moved by `p`.
    pub(crate) fn moved(&self, p: Vector, turn: Rotation) -> Self {
        let middle = if self.cycle.is_centred() {
            turn * self.middle
        } else {
            self.middle
        };
        Self {
            start: turn * self.start + p,
            end: turn * self.end + p,
            cycle: self.cycle.moved(turn, p),
            middle,
            half: self.half,
        }
    }

    /// The smallest distance t in (0, `limit`) at which the ray p + t d meets the curve; d is a unit vector.
    ///
    /// A ray through the joint of two curves meets both.
    pub(crate) fn hit(&self, p: Point, d: Vector, limit: f64) -> Option<f64> {
        let near = self.half + JOINT;
        // Far around a large circle, places are not lengths.
        let beside = |q: Point| {
            let cycle = &self.cycle;
            !cycle.is_centred() && (cycle.place(q).x * cycle.weight).abs() >= WIDEST_ARC
        };
        let met = self.cycle.met(p, d).into_iter().filter(|&t| {
            let q = p + d * t;
            t > 0.0 && t < limit && !beside(q) && self.position(q).abs() <= near
        });
        met.reduce(f64::min)
    }

    /// A box that contains the curve.
    pub(crate) fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::of(self.start, self.end);
        if self.cycle.is_centred() {
            let size = self.cycle.size;
            let least = (self.half / size).cos();
            let (x, y) = (Vector::new(1.0, 0.0), Vector::new(0.0, 1.0));
            for axis in [x, y, -x, -y] {
                if self.middle.dot(axis) >= least {
                    let p = self.cycle.through + axis * size;
                    bounds = bounds.union(Bounds::of(p, p));
                }
            }
        } else {
            // Twice the height of the arc over its chord, and more.
            let height = 0.25 * self.cycle.weight.abs() * (self.end - self.start).length_squared();
            let height = Vector::new(height, height);
            bounds = Bounds {
                min: bounds.min + -height,
                max: bounds.max + height,
            };
        }
        bounds
    }
}

#[cfg(test)]
pub(super) mod tests;

//! A contact curve of one slice: a directed segment or arc with blocked space on its left.

use core::f64::consts::PI;

use crate::feature::tolerance::{JOINT, WIDEST_ARC};
use crate::geometry::{Point, Rotation, Vector, wrap};

use crate::part::Bounds;

use super::cycle::Cycle;

/// A directed segment or arc; free space, if any, is on the right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Curve {
    pub(crate) start: Point,
    pub(crate) end: Point,
    pub(crate) cycle: Cycle,
    /// Its middle: of a circle by its centre the angle of the contact normal there (radians), of any other its place.
    pub(crate) middle: f64,
    /// Half its length.
    pub(crate) half: f64,
}

impl Curve {
    /// From its ends, and the angles of the contact normal there, which only a circle by its centre asks for (radians).
    pub(crate) fn new(cycle: Cycle, [start, end]: [Point; 2], [from, to]: [f64; 2]) -> Self {
        let (middle, half) = if cycle.is_centred() {
            (0.5 * (from + to), 0.5 * (to - from).abs() * cycle.size)
        } else {
            let [from, to] = [start, end].map(|p| cycle.place(p).x);
            (0.5 * (from + to), 0.5 * (to - from).max(0.0))
        };
        Self {
            start,
            end,
            cycle,
            middle,
            half,
        }
    }

    /// Turned by `theta`, of which `turn` is the rotation, then moved by `p`.
    pub(crate) fn moved(&self, p: Vector, theta: f64, turn: Rotation) -> Self {
        let turned = if self.cycle.is_centred() { theta } else { 0.0 };
        Self {
            start: turn * self.start + p,
            end: turn * self.end + p,
            cycle: self.cycle.moved(turn, p),
            middle: self.middle + turned,
            half: self.half,
        }
    }

    /// Place of a point of the curve: length of travel from the middle.
    #[inline]
    pub(crate) fn position(&self, p: Point) -> f64 {
        if self.cycle.is_centred() {
            let v = (p - self.cycle.through) * self.cycle.weight;
            return wrap(v.angle() - self.middle) * self.cycle.radius();
        }
        self.cycle.place(p).x - self.middle
    }

    /// The point at a place.
    #[inline]
    pub(crate) fn point(&self, s: f64) -> Point {
        if self.cycle.is_centred() {
            let radius = self.cycle.radius();
            let normal = Vector::from_angle(self.middle + s / radius);
            return self.cycle.through + normal * radius;
        }
        self.cycle.at(Vector::new(s + self.middle, 0.0))
    }

    /// The unit normal towards the free side at a point of the curve.
    #[inline]
    pub(crate) fn normal(&self, p: Point) -> Vector {
        self.cycle.normal_at(p)
    }

    /// The smallest distance t in (0, `limit`) at which the ray p + t d meets the curve; d is a unit vector.
    ///
    /// A ray through the joint of two curves meets both of them.
    pub(crate) fn hit(&self, p: Point, d: Vector, limit: f64) -> Option<f64> {
        let near = self.half + JOINT;
        // Far around a large circle places are no lengths.
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
        let Bounds {
            min: mut lo,
            max: mut hi,
        } = Bounds::of(self.start, self.end);
        if self.cycle.is_centred() {
            let (center, r) = (self.cycle.through, self.cycle.size);
            let mid = if self.cycle.weight > 0.0 {
                self.middle
            } else {
                self.middle + PI
            };
            let half = self.half / r;
            if wrap(mid).abs() <= half {
                hi.x = center.x + r;
            }
            if wrap(mid - PI).abs() <= half {
                lo.x = center.x - r;
            }
            if wrap(mid - 0.5 * PI).abs() <= half {
                hi.y = center.y + r;
            }
            if wrap(mid + 0.5 * PI).abs() <= half {
                lo.y = center.y - r;
            }
        } else {
            // Twice the height of the arc over its chord, and more.
            let height = 0.25 * self.cycle.weight.abs() * (self.end - self.start).length_squared();
            let height = Vector::new(height, height);
            (lo, hi) = (lo + -height, hi + height);
        }
        Bounds { min: lo, max: hi }
    }
}

#[cfg(test)]
pub(super) mod tests;

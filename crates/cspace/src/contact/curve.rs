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
    /// The angle of the contact normal in the middle, and how far it turns from there to either end (radians); only of a circle by
    /// its centre.
    pub(crate) mid_angle: f64,
    pub(crate) half_angle: f64,
}

impl Curve {
    /// Half its length.
    #[inline]
    pub(crate) fn half_length(&self) -> f64 {
        if self.cycle.is_centred() {
            return self.half_angle * self.cycle.size;
        }
        let [start, end] = self.end_places();
        0.5 * (end - start).max(0.0)
    }

    /// Turned by `theta`, of which `turn` is the rotation, then moved by `p`.
    pub(crate) fn moved(&self, p: Vector, theta: f64, turn: Rotation) -> Self {
        Self {
            start: turn * self.start + p,
            end: turn * self.end + p,
            cycle: self.cycle.moved(turn, p),
            mid_angle: self.mid_angle + theta,
            half_angle: self.half_angle,
        }
    }

    /// The places of its ends; not of a circle by its centre.
    fn end_places(&self) -> [f64; 2] {
        [self.start, self.end].map(|p| self.cycle.place(p).x)
    }

    /// The place of its middle; not of a circle by its centre.
    fn middle(&self) -> f64 {
        let [start, end] = self.end_places();
        0.5 * (start + end)
    }

    /// The signed radius of a circle by its centre.
    fn radius(&self) -> f64 {
        self.cycle.size * self.cycle.weight
    }

    /// Place of a point of the curve: length of travel from the middle.
    #[inline]
    pub(crate) fn position(&self, p: Point) -> f64 {
        if self.cycle.is_centred() {
            let v = (p - self.cycle.through) * self.cycle.weight;
            return wrap(v.angle() - self.mid_angle) * self.radius();
        }
        self.cycle.place(p).x - self.middle()
    }

    /// The point at a place.
    #[inline]
    pub(crate) fn point(&self, s: f64) -> Point {
        if self.cycle.is_centred() {
            let radius = self.radius();
            let normal = Vector::from_angle(self.mid_angle + s / radius);
            return self.cycle.through + normal * radius;
        }
        self.cycle.at(Vector::new(s + self.middle(), 0.0))
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
        let near = self.half_length() + JOINT;
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
                self.mid_angle
            } else {
                self.mid_angle + PI
            };
            let half = self.half_angle;
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

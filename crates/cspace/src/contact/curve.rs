//! A contact curve of one slice: a directed segment or arc with blocked space on its left.

use core::f64::consts::{PI, TAU};

use crate::feature::tolerance::JOINT;
use crate::geometry::{Point, Vector};

use super::bow::{Bow, WIDEST};
use super::carrier::Carrier;

/// A directed segment or arc; free space, if any, is on the right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Curve {
    pub(crate) start: Point,
    pub(crate) end: Point,
    pub(crate) shape: CurveShape,
}

/// The carrier of a contact curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum CurveShape {
    /// A line; the normal points to the free side, travel is its left.
    Line { normal: Vector },
    /// A circle; travelled counter-clockwise if the radius is positive. Angles are those of the contact normal.
    Circle {
        center: Point,
        radius: f64,
        mid_angle: f64,
        half: f64,
    },
    /// A circle much larger than the parts.
    Bow(Bow<f64>),
}

/// Brings an angle to (−π, π].
#[inline]
pub(crate) fn wrap(angle: f64) -> f64 {
    let a = angle - TAU * (angle / TAU).round();
    if a <= -PI { a + TAU } else { a }
}

impl Curve {
    /// Half its length.
    #[inline]
    pub(crate) fn half_length(&self) -> f64 {
        match self.shape {
            CurveShape::Line { normal } => 0.5 * normal.left().dot(self.end - self.start),
            CurveShape::Circle { radius, half, .. } => half * radius.abs(),
            CurveShape::Bow(bow) => (0.5 * (bow.place(self.end) - bow.place(self.start))).max(0.0),
        }
    }

    /// The carrier it lies on.
    #[inline]
    pub(crate) fn carrier(&self) -> Carrier<f64> {
        match self.shape {
            CurveShape::Line { normal } => Carrier::Line {
                normal: (normal.x, normal.y),
                through: (self.start.x, self.start.y),
            },
            CurveShape::Circle { center, radius, .. } => Carrier::Circle {
                center: (center.x, center.y),
                radius,
            },
            CurveShape::Bow(bow) => Carrier::Bow(bow),
        }
    }

    /// The place of its middle on a bow.
    fn middle_of_bow(&self, bow: &Bow<f64>) -> f64 {
        0.5 * (bow.place(self.start) + bow.place(self.end))
    }

    /// Place of a point of the curve: length of travel from the middle.
    #[inline]
    pub(crate) fn position(&self, p: Point) -> f64 {
        match self.shape {
            CurveShape::Line { normal } => {
                let t = normal.left();
                0.5 * (t.dot(p - self.start) + t.dot(p - self.end))
            }
            CurveShape::Circle {
                center,
                radius,
                mid_angle,
                ..
            } => {
                let v = (p - center) * radius.signum();
                wrap(v.angle() - mid_angle) * radius
            }
            CurveShape::Bow(bow) => bow.place(p) - self.middle_of_bow(&bow),
        }
    }

    /// The point at a place.
    #[inline]
    pub(crate) fn point(&self, s: f64) -> Point {
        match self.shape {
            CurveShape::Line { normal } => self.start.midpoint(self.end) + normal.left() * s,
            CurveShape::Circle {
                center,
                radius,
                mid_angle,
                ..
            } => center + Vector::from_angle(mid_angle + s / radius) * radius,
            CurveShape::Bow(bow) => bow.point(s + self.middle_of_bow(&bow)),
        }
    }

    /// The unit normal towards the free side at a point of the curve.
    #[inline]
    pub(crate) fn normal(&self, p: Point) -> Vector {
        match self.shape {
            CurveShape::Line { normal } => normal,
            CurveShape::Circle { center, radius, .. } => (p - center) * (1.0 / radius),
            CurveShape::Bow(bow) => bow.normal_at(p),
        }
    }

    /// The smallest distance t in (0, `limit`) at which the ray p + t d meets the curve; d is a unit vector.
    ///
    /// A ray through the joint of two curves meets both of them.
    pub(crate) fn hit(&self, p: Point, d: Vector, limit: f64) -> Option<f64> {
        let mut best = None;
        let mut take = |t: f64| {
            if t > 0.0
                && t < best.unwrap_or(limit)
                && self.position(p + d * t).abs() <= self.half_length() + JOINT
            {
                best = Some(t);
            }
        };
        match self.shape {
            CurveShape::Line { normal } => take(normal.dot(self.start - p) / normal.dot(d)),
            CurveShape::Circle { center, radius, .. } => {
                let v = center - p;
                let along = v.dot(d);
                let across = v.cross(d);
                let square = (radius - across) * (radius + across);
                if square >= 0.0 {
                    take(along - square.sqrt());
                    take(along + square.sqrt());
                }
            }
            CurveShape::Bow(bow) => {
                for t in bow.met(p, d) {
                    if (bow.place(p + d * t) * bow.curvature).abs() < WIDEST {
                        take(t);
                    }
                }
            }
        }
        best
    }

    /// A box that contains the curve: lower and upper corner.
    pub(crate) fn bounds(&self) -> (Point, Point) {
        let mut lo = Point::new(self.start.x.min(self.end.x), self.start.y.min(self.end.y));
        let mut hi = Point::new(self.start.x.max(self.end.x), self.start.y.max(self.end.y));
        if let CurveShape::Circle {
            center,
            radius,
            mid_angle,
            half,
        } = self.shape
        {
            let r = radius.abs();
            let mid = if radius > 0.0 {
                mid_angle
            } else {
                mid_angle + PI
            };
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
        }
        if let CurveShape::Bow(bow) = self.shape {
            // Twice the height of the arc over its chord, and more.
            let height = 0.25 * bow.curvature.abs() * (self.end - self.start).length_squared();
            let height = Vector::new(height, height);
            (lo, hi) = (lo + -height, hi + height);
        }
        (lo, hi)
    }
}

#[cfg(test)]
pub(super) mod tests;

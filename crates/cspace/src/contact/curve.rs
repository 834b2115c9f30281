//! A contact curve of one slice: a directed segment or arc with blocked space on its left.

use core::f64::consts::PI;

use crate::feature::tolerance::{JOINT, WIDEST_ARC};
use crate::geometry::{Point, Rotation, Vector, wrap};

use crate::part::Bounds;

use super::carrier::Carrier;
use super::flat_arc::FlatArc;

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
    FlatArc(FlatArc<f64>),
}

impl Curve {
    /// Half its length.
    #[inline]
    pub(crate) fn half_length(&self) -> f64 {
        match self.shape {
            CurveShape::Line { normal } => 0.5 * normal.left().dot(self.end - self.start),
            CurveShape::Circle { radius, half, .. } => half * radius.abs(),
            CurveShape::FlatArc(arc) => {
                (0.5 * (arc.place(self.end) - arc.place(self.start))).max(0.0)
            }
        }
    }

    /// Turned by `theta`, of which `turn` is the rotation, then moved by `p`.
    pub(crate) fn moved(&self, p: Vector, theta: f64, turn: Rotation) -> Self {
        let place = |q: Point| turn * q + p;
        Self {
            start: place(self.start),
            end: place(self.end),
            shape: match self.shape {
                CurveShape::Line { normal } => CurveShape::Line {
                    normal: turn * normal,
                },
                CurveShape::Circle {
                    center,
                    radius,
                    mid_angle,
                    half,
                } => CurveShape::Circle {
                    center: place(center),
                    radius,
                    mid_angle: mid_angle + theta,
                    half,
                },
                CurveShape::FlatArc(arc) => CurveShape::FlatArc(arc.moved(turn, p)),
            },
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
            CurveShape::FlatArc(arc) => Carrier::FlatArc(arc),
        }
    }

    /// The place of its middle on a flat arc.
    fn middle_of_flat_arc(&self, arc: &FlatArc<f64>) -> f64 {
        0.5 * (arc.place(self.start) + arc.place(self.end))
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
            CurveShape::FlatArc(arc) => arc.place(p) - self.middle_of_flat_arc(&arc),
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
            CurveShape::FlatArc(arc) => arc.point(s + self.middle_of_flat_arc(&arc)),
        }
    }

    /// The unit normal towards the free side at a point of the curve.
    #[inline]
    pub(crate) fn normal(&self, p: Point) -> Vector {
        match self.shape {
            CurveShape::Line { normal } => normal,
            CurveShape::Circle { center, radius, .. } => (p - center) * (1.0 / radius),
            CurveShape::FlatArc(arc) => arc.normal_at(p),
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
            CurveShape::FlatArc(arc) => {
                for t in arc.met(p, d) {
                    if (arc.place(p + d * t) * arc.curvature).abs() < WIDEST_ARC {
                        take(t);
                    }
                }
            }
        }
        best
    }

    /// A box that contains the curve.
    pub(crate) fn bounds(&self) -> Bounds {
        let Bounds {
            min: mut lo,
            max: mut hi,
        } = Bounds::of(self.start, self.end);
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
        if let CurveShape::FlatArc(arc) = self.shape {
            // Twice the height of the arc over its chord, and more.
            let height = 0.25 * arc.curvature.abs() * (self.end - self.start).length_squared();
            let height = Vector::new(height, height);
            (lo, hi) = (lo + -height, hi + height);
        }
        Bounds { min: lo, max: hi }
    }
}

#[cfg(test)]
pub(super) mod tests;

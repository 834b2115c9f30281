//! Pieces of the boundary of free space for users: segments and arcs.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::contact::{Curve, Cycle};
use crate::feature::PairFrame;
use crate::geometry::{Point, Vector};
use crate::part::{Bounds, Edge};

/// A directed segment or circular arc.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum CurveGeometry {
    /// A segment from start to end.
    Segment {
        /// Start of the segment.
        start: Point,
        /// End of the segment.
        end: Point,
    },
    /// An arc from `start_angle` by `sweep` radians about the centre, counter-clockwise if positive.
    Arc {
        /// Centre of the circle.
        center: Point,
        /// Radius of the circle, positive.
        radius: f64,
        /// Direction from the centre to the start, radians.
        start_angle: f64,
        /// Angle from start to end, radians.
        sweep: f64,
    },
    /// An arc of a circle so large that places on it would be inaccurate if computed from its centre.
    FlatArc {
        /// Start of the arc.
        start: Point,
        /// End of the arc.
        end: Point,
        /// tan(sweep / 4), positive counter-clockwise.
        bulge: f64,
    },
}

/// Whether an arc that turns from `start_angle` by `sweep` contains a direction; all radians.
pub(crate) fn is_on_arc(start_angle: f64, sweep: f64, angle: f64) -> bool {
    let turned = (angle - start_angle) * sweep.signum();
    turned - TAU * (turned / TAU).floor() <= sweep.abs()
}

impl CurveGeometry {
    /// The point at fraction `s` of the length, 0 the start and 1 the end.
    pub fn point(&self, s: f64) -> Point {
        match *self {
            Self::Segment { start, end } => start.lerp(end, s),
            Self::Arc {
                center,
                radius,
                start_angle,
                sweep,
            } => center + Vector::from_angle(start_angle + s * sweep) * radius,
            Self::FlatArc { start, end, .. } if start == end => start,
            Self::FlatArc { start, end, bulge } => Edge::between(start, end, bulge).at(s),
        }
    }

    /// A flat arc as an edge.
    pub(crate) fn edge(&self) -> Option<Edge> {
        match *self {
            Self::FlatArc { start, end, bulge } => Some(Edge::between(start, end, bulge)),
            _ => None,
        }
    }

    /// The point of the curve that is nearest to `p`.
    pub fn nearest(&self, p: Point) -> Point {
        match *self {
            Self::Segment { start, end } => {
                let v = end - start;
                let s = (p - start).dot(v) / v.length_squared();
                // NaN for a segment of no length.
                if s > 0.0 {
                    start.lerp(end, s.min(1.0))
                } else {
                    start
                }
            }
            Self::Arc {
                center,
                radius,
                start_angle,
                sweep,
            } => {
                let v = p - center;
                if is_on_arc(start_angle, sweep, v.angle()) {
                    return center + Vector::from_angle(v.angle()) * radius;
                }
                let (start, end) = (self.point(0.0), self.point(1.0));
                nearer(p, start, end)
            }
            Self::FlatArc { start, end, bulge } => {
                let foot = Edge::between(start, end, bulge).foot(p);
                foot.unwrap_or_else(|| nearer(p, start, end))
            }
        }
    }

    /// A box that contains the curve, up to rounding.
    pub(crate) fn bounds(&self) -> Bounds {
        let ends = Bounds::of(self.point(0.0), self.point(1.0));
        match *self {
            Self::Segment { .. } => ends,
            Self::Arc {
                center,
                radius,
                start_angle,
                sweep,
            } => (0..4)
                .map(|k| FRAC_PI_2 * f64::from(k))
                .filter(|&angle| is_on_arc(start_angle, sweep, angle))
                .map(|angle| center + Vector::from_angle(angle) * radius)
                .fold(ends, |bounds, far| bounds.union(Bounds::of(far, far))),
            Self::FlatArc { start, end, bulge } => Edge::between(start, end, bulge).bounds(),
        }
    }

    /// Length of the curve.
    pub fn length(&self) -> f64 {
        match *self {
            Self::Segment { start, end } => start.distance(end),
            Self::Arc { radius, sweep, .. } => radius * sweep.abs(),
            Self::FlatArc { start, end, bulge } => Edge::between(start, end, bulge).length(),
        }
    }

    /// The unit normal towards free space (right of travel) at fraction `s`; zero for a curve that is a single point, as a segment is at
    /// the critical orientation at which it begins.
    pub fn free_normal(&self, s: f64) -> Vector {
        match *self {
            Self::Segment { start, end } | Self::FlatArc { start, end, .. } if start == end => {
                Vector::ZERO
            }
            Self::Segment { start, end } => (end - start).unit().right(),
            Self::Arc {
                start_angle, sweep, ..
            } => Vector::from_angle(start_angle + s * sweep) * sweep.signum(),
            Self::FlatArc { start, end, bulge } => {
                Edge::between(start, end, bulge).direction_at(s).right()
            }
        }
    }

    /// Converts a curve of the pair's frame.
    pub(crate) fn from_inner(
        curve: &Curve,
        from: f64,
        to: f64,
        frame: &PairFrame,
        theta: f64,
    ) -> Self {
        let outer = |p: Point| frame.outer_from_inner(p, theta).position();
        let cycle = &curve.cycle;
        if cycle.is_centred() {
            let radius = cycle.radius();
            let start = curve.middle.angle() + from / radius;
            return Self::Arc {
                center: outer(cycle.through),
                radius: frame.outer_length(cycle.size),
                start_angle: start - TAU * (start / TAU).round(),
                sweep: (to - from) / radius,
            };
        }
        let (p, q) = (curve.point(from), curve.point(to));
        let (start, end) = (outer(p), outer(q));
        if cycle.is_line() {
            return Self::Segment { start, end };
        }
        Self::FlatArc {
            start,
            end,
            bulge: cycle.bulge(cycle.place(p), cycle.place(q)),
        }
    }

    /// The first distance along the ray at which the curve is met, or at which its start is nearer to the ray than `joint`: a ray does not
    /// pass between the end of one curve and the start of the next.
    pub(crate) fn met(&self, p: Point, d: Vector, joint: f64) -> Option<f64> {
        let v = self.point(0.0) - p;
        let along = v.dot(d);
        let begins = (along > 0.0 && v.cross(d).abs() < joint).then_some(along);
        let hit = self.hit(p, d).map(|h| h.0);
        hit.into_iter().chain(begins).reduce(f64::min)
    }

    /// The first distance along the ray from `p` in the unit direction `d` at which the curve is met, and the
    /// product of the direction with the normal towards free space there.
    pub(crate) fn hit(&self, p: Point, d: Vector) -> Option<(f64, f64)> {
        match *self {
            Self::Segment { start, end } => {
                let v = end - start;
                let slope = d.cross(v);
                let t = (start - p).cross(v) / slope;
                let s = (start - p).cross(d) / slope;
                (t > 0.0 && (0.0..=1.0).contains(&s)).then(|| (t, d.dot(v.right())))
            }
            Self::Arc {
                center,
                radius,
                start_angle,
                sweep,
            } => {
                let v = center - p;
                let (along, across) = (v.dot(d), v.cross(d));
                let square = (radius - across) * (radius + across);
                if square < 0.0 {
                    return None;
                }
                let half = square.sqrt();
                [along - half, along + half].into_iter().find_map(|t| {
                    let q = (p + d * t) - center;
                    (t > 0.0 && is_on_arc(start_angle, sweep, q.angle()))
                        .then(|| (t, d.dot(q) * sweep.signum()))
                })
            }
            Self::FlatArc { start, end, bulge } => {
                let edge = Edge::between(start, end, bulge);
                let cycle = Cycle::of_edge(&edge);
                let mut both = cycle.met(p, d);
                both.sort_by(f64::total_cmp);
                both.into_iter().find_map(|t| {
                    let q = p + d * t;
                    (t > 0.0 && t.is_finite() && edge.covers(q)).then(|| (t, cycle.slope(q).dot(d)))
                })
            }
        }
    }
}

fn nearer(p: Point, start: Point, end: Point) -> Point {
    if p.distance(start) <= p.distance(end) {
        start
    } else {
        end
    }
}

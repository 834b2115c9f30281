//! Target of a drag.

use std::f64::consts::TAU;

use cspace::{AxisMotion, Configuration, Point, Vector};

use crate::error::SimulateError;
use crate::system::{PartCoordinates, System};

/// Target of a drag.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// Coordinate of a part on an axis, in radians or the model's unit of length.
    Axis(f64),
    /// Position and orientation of a part that moves in the plane; its centroid moves on a straight line.
    Planar(Configuration),
    /// Position of a point of a part: the point in the part's frame, the position in the assembly's frame. A part that
    /// moves in the plane is free to turn about the point, and follows it like a trailer; a part on an axis comes as
    /// near to the position as the axis allows, in the shorter direction.
    Point {
        /// The point, in the part's frame.
        of: Point,
        /// The place, in the assembly's frame.
        to: Point,
    },
}

/// A target in the coordinates of a part: from where to where.
#[derive(Debug, Clone, Copy)]
pub(super) enum Way {
    /// Path of a part on an axis: its coordinate.
    Axis {
        /// The index of the coordinate.
        index: usize,
        /// First and last value of the coordinate.
        ends: [f64; 2],
    },
    /// Path of a part in the plane: one of its points, in the part's frame.
    Planar {
        /// The index of x.
        first: usize,
        /// The point, in the part's frame.
        point: Point,
        /// First and last position of the point.
        ends: [Point; 2],
        /// First and last orientation, if one is requested.
        turn: Option<[f64; 2]>,
    },
}

impl Way {
    /// Path of a part from its present configuration to a target.
    pub(super) fn new(
        system: &System,
        part: usize,
        target: Target,
        q: &[f64],
    ) -> Result<Self, SimulateError> {
        let parts = &system.mechanism().parts;
        let Some(entry) = parts.get(part) else {
            let count = parts.len();
            return Err(SimulateError::NoPart { part, count });
        };
        let cannot = |why| {
            let part = entry.part.name().to_owned();
            Err(SimulateError::Drag { part, why })
        };
        let is_finite = match target {
            Target::Axis(u) => u.is_finite(),
            Target::Planar(c) => [c.x, c.y, c.theta].into_iter().all(f64::is_finite),
            Target::Point { of, to } => of.is_finite() && to.is_finite(),
        };
        if !is_finite {
            return cannot("is dragged to numbers that are not finite");
        }
        let here = |point: Point| {
            let [x, y] = system.placement(part, q).point([point.x, point.y]);
            Point::new(x, y)
        };
        match (system.parts()[part], target) {
            (PartCoordinates::Fixed, _) => cannot("does not move, and cannot be dragged"),
            (PartCoordinates::Axis { first, .. }, Target::Axis(u)) => {
                let ends = [q[first], u];
                Ok(Self::Axis { index: first, ends })
            }
            (PartCoordinates::Axis { first, motion, .. }, Target::Point { of, to }) => {
                let by = along(motion, here(of), to);
                let ends = [q[first], q[first] + by];
                Ok(Self::Axis { index: first, ends })
            }
            (PartCoordinates::Planar { first, .. }, Target::Planar(c)) => {
                let point = system.moments(part).centroid;
                let to = c.fixed_from_moving(point);
                let turn = Some([q[first + 2], c.theta]);
                let ends = [here(point), to];
                Ok(Self::Planar {
                    first,
                    point,
                    ends,
                    turn,
                })
            }
            (PartCoordinates::Planar { first, .. }, Target::Point { of, to }) => {
                let ends = [here(of), to];
                Ok(Self::Planar {
                    first,
                    point: of,
                    ends,
                    turn: None,
                })
            }
            (PartCoordinates::Axis { .. }, Target::Planar(_)) => {
                cannot("has an axis: it is dragged to a coordinate, or by a point")
            }
            (PartCoordinates::Planar { .. }, Target::Axis(_)) => {
                cannot("has no axis: it is dragged to a position and an orientation, or by a point")
            }
        }
    }

    /// Length of the path, with angles multiplied by the size of their part.
    pub(super) fn length(&self, system: &System) -> f64 {
        let lengths = system.lengths();
        match *self {
            Self::Axis {
                index,
                ends: [a, b],
            } => (b - a).abs() * lengths[index],
            Self::Planar {
                first,
                ends: [a, b],
                turn,
                ..
            } => {
                let turned = turn.map_or(0.0, |[a, b]| (b - a).abs() * lengths[first + 2]);
                a.distance(b).max(turned)
            }
        }
    }

    /// Path up to a share of this one.
    pub(super) fn at(&self, share: f64) -> Self {
        // At the end exactly there.
        let between = |[a, b]: [f64; 2]| (1.0 - share) * a + share * b;
        let to = |ends: [f64; 2]| [ends[0], between(ends)];
        match *self {
            Self::Axis { index, ends } => Self::Axis {
                index,
                ends: to(ends),
            },
            Self::Planar {
                first,
                point,
                ends: [a, b],
                turn,
            } => Self::Planar {
                first,
                point,
                ends: [a, Point::new(between([a.x, b.x]), between([a.y, b.y]))],
                turn: turn.map(to),
            },
        }
    }
}

/// Displacement of a part along its axis that brings a point of it as near to a position as possible.
fn along(motion: AxisMotion, from: Point, to: Point) -> f64 {
    match motion {
        AxisMotion::Fixed => 0.0,
        AxisMotion::Prismatic { direction } => direction.dot(to - from),
        AxisMotion::Revolute { center } => {
            let angle = |p: Point| {
                let Vector { x, y } = p - center;
                y.atan2(x)
            };
            let by = angle(to) - angle(from);
            by - TAU * (by / TAU).round()
        }
    }
}

//! Axes as the user gives them.

use crate::geometry::{Configuration, Point, Rotation, Vector};

/// Motion of a part.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case", tag = "type"))]
pub enum AxisMotion {
    /// No motion; the coordinate is 0.
    Fixed,
    /// Rotation: a point q moves to c + `R_t` (q − c), with t in radians.
    Revolute {
        /// The point c about which it turns.
        center: Point,
    },
    /// Translation: a point q moves to q + t d / |d|, with t in the model's unit of length.
    Prismatic {
        /// The direction d; its length does not matter.
        direction: Vector,
    },
}

/// Motion of a part, and its range.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Axis {
    /// The motion.
    pub motion: AxisMotion,
    /// Smallest and largest coordinate, in radians or the model's unit of length; `None` if there are no limits.
    ///
    /// Without a range a turning part repeats after a turn. With one it does not, even if the range is more than a turn.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// An axis on which the part does not move.
    pub const FIXED: Self = Self {
        motion: AxisMotion::Fixed,
        range: None,
    };

    /// An axis on which the part turns about a point, without limits.
    pub const fn revolute(center: Point) -> Self {
        Self {
            motion: AxisMotion::Revolute { center },
            range: None,
        }
    }

    /// An axis on which the part slides along a direction, without limits.
    pub const fn prismatic(direction: Vector) -> Self {
        Self {
            motion: AxisMotion::Prismatic { direction },
            range: None,
        }
    }

    /// Configuration of the part after a motion by `t`, radians or the model's unit of length: it maps the part's points to the frame in
    /// which the axis is given. A turn maps q to c + `R_t` (q − c), a slide to q + t d / |d|.
    ///
    /// ```
    /// use cspace::{Axis, Point};
    /// let axis = Axis::revolute(Point::new(1.0, 0.0));
    /// let at = axis.configuration(core::f64::consts::FRAC_PI_2).fixed_from_moving(Point::new(2.0, 0.0));
    /// assert!(at.distance(Point::new(1.0, 1.0)) < 1e-15);
    /// ```
    pub fn configuration(&self, t: f64) -> Configuration {
        match self.motion {
            AxisMotion::Fixed => Configuration::default(),
            AxisMotion::Revolute { center } => {
                let turned = Rotation::by(t) * center.to_vector();
                Configuration::new(center.x - turned.x, center.y - turned.y, t)
            }
            AxisMotion::Prismatic { direction } => {
                let by = direction.unit() * t;
                Configuration::new(by.x, by.y, 0.0)
            }
        }
    }

    /// The motion restricted to the range from `lo` to `hi`.
    #[must_use]
    pub const fn within(self, lo: f64, hi: f64) -> Self {
        Self {
            motion: self.motion,
            range: Some((lo, hi)),
        }
    }
}

/// Role of a part in a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Role {
    /// The part called fixed, whose coordinate is u.
    Fixed,
    /// The part called moving, whose coordinate is v.
    Moving,
}

impl core::fmt::Display for Role {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Fixed => "fixed",
            Self::Moving => "moving",
        })
    }
}

/// Reasons for which axes are rejected.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum AxesError {
    /// A centre, a direction or a range is not finite.
    #[error("the {part} part's axis has a number that is not finite")]
    NotFinite {
        /// Part that has the axis.
        part: Role,
    },
    /// A direction has no length.
    #[error(
        "the {part} part's direction of sliding has no length; give two numbers that are not both 0"
    )]
    NoDirection {
        /// Part that has the axis.
        part: Role,
    },
    /// A range's limits are in the wrong order or equal.
    #[error("the {part} part's range from {lo:?} to {hi:?} is empty; give the lower limit first")]
    EmptyRange {
        /// Part that has the axis.
        part: Role,
        /// The lower limit given.
        lo: f64,
        /// The upper limit given.
        hi: f64,
    },
    /// A pivot is so far from the parts that the rounding of positions exceeds the resolution.
    #[error(
        "the {part} part's centre is {} the parts' size away from them (at most {limit} times); let the part slide instead",
        Times(*times)
    )]
    TooFar {
        /// Part that has the axis.
        part: Role,
        /// The distance, in units of the parts' size.
        times: f64,
        /// The largest that is accepted.
        limit: f64,
    },
    /// Two slides without ranges are almost parallel: their parts meet so far away that the rounding of positions exceeds the resolution.
    #[error(
        "the directions of sliding are all but parallel, {angle:.1e} rad apart (at least {least:.1e}, or not at all); give both parts one direction, or one of them a range"
    )]
    NearlyParallel {
        /// The angle between them, radians.
        angle: f64,
        /// The smallest accepted angle.
        least: f64,
    },
    /// A range of a turning part has too many turns.
    #[error("the {part} part's range is {turns:.1e} turns long (at most {limit})")]
    TooManyTurns {
        /// Part that has the axis.
        part: Role,
        /// Its length in turns.
        turns: f64,
        /// The largest accepted number.
        limit: u32,
    },
    /// There are more pairs of edges than the limit.
    #[error(
        "{fixed} × {moving} edges are too many for one configuration space (at most {limit} pairs)"
    )]
    TooLarge {
        /// Edges of the fixed part.
        fixed: usize,
        /// Edges of the moving part.
        moving: usize,
        /// Largest number of pairs.
        limit: usize,
    },
    /// More pairs of contact curves may cross than the limit.
    #[error(
        "{fixed} × {moving} edges are too many for one configuration space: more than {limit} pairs of contact curves may cross"
    )]
    TooManyCrossings {
        /// Edges of the fixed part.
        fixed: usize,
        /// Edges of the moving part.
        moving: usize,
        /// Largest number of pairs of curves.
        limit: usize,
    },
}

impl AxesError {
    /// Part that has the axis.
    pub const fn part(&self) -> Role {
        match *self {
            Self::NotFinite { part }
            | Self::NoDirection { part }
            | Self::EmptyRange { part, .. }
            | Self::TooFar { part, .. }
            | Self::TooManyTurns { part, .. } => part,
            // Both parts are concerned.
            Self::NearlyParallel { .. } | Self::TooLarge { .. } | Self::TooManyCrossings { .. } => {
                Role::Moving
            }
        }
    }
}

/// A ratio in words, also for values above all numbers.
struct Times(f64);

impl core::fmt::Display for Times {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.0 {
            // Rounded up, so that it is not reported to be within the limit.
            x if x < 1e4 => write!(f, "{} times", (x * 10.0).ceil() / 10.0),
            x if x.is_finite() => write!(f, "{x:.0e} times"),
            // The square overflows.
            _ => f.write_str("more than 1e150 times"),
        }
    }
}

//! Axes as the user gives them.

use crate::geometry::{Configuration, Point, Rotation, Vector};

/// How a part can move.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case", tag = "type"))]
pub enum AxisMotion {
    /// Not at all; its coordinate is 0.
    Fixed,
    /// It turns: a point q goes to c + `R_t` (q − c), with t in radians.
    Revolute {
        /// The point c about which it turns.
        center: Point,
    },
    /// It slides: a point q goes to q + t d / |d|, with t in the model's unit of length.
    Prismatic {
        /// The direction d; its length does not matter.
        direction: Vector,
    },
}

/// How a part can move, and how far.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Axis {
    /// The motion.
    pub motion: AxisMotion,
    /// Least and largest coordinate, in radians or the model's unit of length; none if it goes on for ever.
    ///
    /// Without a range a turning part repeats after a turn. With one it does not, even if the range is more than a turn.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// The part does not move.
    pub const FIXED: Self = Self {
        motion: AxisMotion::Fixed,
        range: None,
    };

    /// The part turns about a point, without limits.
    pub const fn revolute(center: Point) -> Self {
        Self {
            motion: AxisMotion::Revolute { center },
            range: None,
        }
    }

    /// The part slides along a direction, without limits.
    pub const fn prismatic(direction: Vector) -> Self {
        Self {
            motion: AxisMotion::Prismatic { direction },
            range: None,
        }
    }

    /// Where the part is after a motion by `t`, radians or the model's unit of length: takes the part's points to the frame in
    /// which the axis is given. A turn takes q to c + `R_t` (q − c), a slide to q + t d / |d|.
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

/// Which of the two parts of a pair.
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

/// Why axes are refused.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum AxesError {
    /// A centre, a direction or a range is not finite.
    #[error("the {part} part's axis has a number that is not finite")]
    NotFinite {
        /// Whose axis it is.
        part: Role,
    },
    /// A direction has no length.
    #[error(
        "the {part} part's direction of sliding has no length; give two numbers that are not both 0"
    )]
    NoDirection {
        /// Whose axis it is.
        part: Role,
    },
    /// A range's limits are in the wrong order or equal.
    #[error("the {part} part's range from {lo:?} to {hi:?} is empty; give the lower limit first")]
    EmptyRange {
        /// Whose axis it is.
        part: Role,
        /// The lower limit given.
        lo: f64,
        /// The upper limit given.
        hi: f64,
    },
    /// A pivot is so far from the parts that positions lose the resolution by rounding.
    #[error(
        "the {part} part's centre is {} the parts' size away from them (at most {limit} times); let the part slide instead",
        Times(*times)
    )]
    TooFar {
        /// Whose axis it is.
        part: Role,
        /// The distance, in units of the parts' size.
        times: f64,
        /// The largest that is accepted.
        limit: f64,
    },
    /// Two slides without ranges are all but parallel: their parts meet so far away that positions lose the resolution by
    /// rounding.
    #[error(
        "the directions of sliding are all but parallel, {angle:.1e} rad apart (at least {least:.1e}, or not at all); give both parts one direction, or one of them a range"
    )]
    NearlyParallel {
        /// The angle between them, radians.
        angle: f64,
        /// The least that is accepted.
        least: f64,
    },
    /// A range of a turning part has too many turns.
    #[error("the {part} part's range is {turns:.1e} turns long (at most {limit})")]
    TooManyTurns {
        /// Whose axis it is.
        part: Role,
        /// Its length in turns.
        turns: f64,
        /// The most that is accepted.
        limit: u32,
    },
    /// There are more pairs of edges than can be looked at.
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
    /// More contact curves may cross than there is room for.
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
    /// Whose axis it is.
    pub const fn part(&self) -> Role {
        match *self {
            Self::NotFinite { part }
            | Self::NoDirection { part }
            | Self::EmptyRange { part, .. }
            | Self::TooFar { part, .. }
            | Self::TooManyTurns { part, .. } => part,
            // Of both.
            Self::NearlyParallel { .. } | Self::TooLarge { .. } | Self::TooManyCrossings { .. } => {
                Role::Moving
            }
        }
    }
}

/// How often, in words that are right of what is beyond all numbers, too.
struct Times(f64);

impl core::fmt::Display for Times {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.0 {
            // Rounded up, so that it is not told to be within the limit.
            x if x < 1e4 => write!(f, "{} times", (x * 10.0).ceil() / 10.0),
            x if x.is_finite() => write!(f, "{x:.0e} times"),
            // The square is beyond all numbers.
            _ => f.write_str("more than 1e150 times"),
        }
    }
}

//! Measured quantity of a requirement, and its target.

use cspace::Coordinates;

use crate::mechanism::PairEntry;

/// Requirement of a design: a measured quantity, and its target.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirement {
    /// Name, unique in the model.
    pub name: String,
    /// Measured quantity.
    pub subject: Subject,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// Target of the value, if there is one.
    pub target: Option<Target>,
}

impl Requirement {
    /// The smallest and the largest value that is allowed, if there are limits.
    pub const fn limits(&self) -> Option<[f64; 2]> {
        match self.target {
            Some(Target::Limits(lo, hi)) => Some([lo, hi]),
            _ => None,
        }
    }

    /// Required answer, if the quantity is a yes or no and one is required.
    pub const fn equals(&self) -> Option<bool> {
        match self.target {
            Some(Target::Equals(wanted)) => Some(wanted),
            _ => None,
        }
    }
}

/// Subject of a requirement: a pair or a motion, with the measured quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Subject {
    /// Quantity on the configuration space of a pair, with the window of orientations that the model gives it.
    Pair(PairEntry, Quantity),
    /// Quantity of the motion of the whole mechanism, over this many seconds.
    Motion(f64, MotionQuantity),
}

impl Subject {
    /// The name in a model.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Pair(_, Quantity::Play { .. }) => "play",
            Self::Pair(_, Quantity::Position { .. }) => "position",
            Self::Pair(_, Quantity::Clearance { .. }) => "clearance",
            Self::Pair(_, Quantity::Angle { .. }) => "angle",
            Self::Pair(_, Quantity::Bottleneck { .. }) => "bottleneck",
            Self::Pair(_, Quantity::Extreme { .. }) => "extreme",
            Self::Pair(_, Quantity::Caged { .. }) => "caged",
            Self::Pair(_, Quantity::Connected { .. }) => "connected",
            Self::Pair(_, Quantity::Fits { .. }) => "fits",
            Self::Pair(_, Quantity::Ranges { what, .. }) => what.name(),
            Self::Motion(_, MotionQuantity::Event { .. }) => "event",
            Self::Motion(_, MotionQuantity::Stroke { .. }) => "stroke",
            Self::Motion(_, MotionQuantity::Ratio { .. }) => "ratio",
        }
    }

    /// Gives a coordinate of the configuration at which it is measured another value; false if it has no such coordinate.
    pub fn put(&mut self, of: Coordinate, value: f64) -> bool {
        let Self::Pair(_, quantity) = self else {
            return false;
        };
        let at = quantity.at();
        of.put(at, value);
        of.of(*at).is_some()
    }

    /// The indices of the two parts that it is about, if it is about two.
    pub const fn parts(&self) -> Option<[usize; 2]> {
        match *self {
            Self::Pair(pair, _) => Some([pair.fixed, pair.moving]),
            Self::Motion(_, MotionQuantity::Event { parts, .. }) => parts,
            Self::Motion(_, MotionQuantity::Ratio { by, of }) => Some([by, of]),
            Self::Motion(_, MotionQuantity::Stroke { .. }) => None,
        }
    }
}

/// Dimension of a value, which determines its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, schemars::JsonSchema, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Dimension {
    /// A length in the model's unit.
    Length,
    /// An angle in radians.
    Angle,
    /// A time in seconds.
    Time,
    /// A number without a unit, or a length for each radian.
    Number,
    /// Yes or no.
    Truth,
}

/// Quantity measured on a simulated motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MotionQuantity {
    /// Time of an event.
    Event {
        /// Kind of the event.
        happens: Happening,
        /// Indices of the two parts concerned; `None` for any parts.
        parts: Option<[usize; 2]>,
        /// Number of the event among several of its kind, counted from 1.
        number: u32,
    },
    /// Range of a coordinate from its smallest to its largest value: in the last cycle if the motion repeats, else in
    /// all of it.
    Stroke {
        /// The part.
        part: usize,
        /// The coordinate: x, y or θ of a planar part; V, the only one of a part on an axis.
        of: Coordinate,
    },
    /// Ratio of the displacements of two parts: in a cycle if the motion repeats, else in all of it.
    Ratio {
        /// Part whose displacement is the denominator.
        by: usize,
        /// Part whose displacement is the numerator.
        of: usize,
    },
}

/// Kind of an event in a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Happening {
    /// Two parts strike each other.
    Impact,
    /// Two parts come into contact that lasts.
    Touch,
    /// Two parts are released from each other.
    Release,
    /// Two parts no longer slide on each other.
    Stick,
    /// Two parts begin to slide on each other.
    Slip,
    /// Impacts are over.
    Rest,
}

impl Happening {
    /// All kinds of events, by name.
    pub(super) const ALL: [(&'static str, Self); 6] = [
        ("touch", Self::Touch),
        ("release", Self::Release),
        ("impact", Self::Impact),
        ("stick", Self::Stick),
        ("slip", Self::Slip),
        ("rest", Self::Rest),
    ];
}

/// A coordinate of a pair's configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, schemars::JsonSchema, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Coordinate {
    /// The position of the moving part along the first axis of the fixed part's frame.
    X,
    /// Coordinate along the second axis.
    Y,
    /// The orientation, radians.
    Theta,
    /// The motion of the fixed part on its axis.
    U,
    /// The motion of the moving part on its axis.
    V,
}

impl Coordinate {
    pub(in crate::model) const PLANAR: [(&'static str, Self); 3] =
        [("x", Self::X), ("y", Self::Y), ("theta", Self::Theta)];
    pub(in crate::model) const AXES: [(&'static str, Self); 2] = [("u", Self::U), ("v", Self::V)];

    /// Name in configurations.
    pub const fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Theta => "theta",
            Self::U => "u",
            Self::V => "v",
        }
    }

    /// Index among the coordinates of its class: x, y and θ, or u and v.
    pub const fn index(self) -> usize {
        match self {
            Self::X | Self::U => 0,
            Self::Y | Self::V => 1,
            Self::Theta => 2,
        }
    }

    /// Gives it a value in a configuration; one in the coordinates of another class stays.
    pub fn put(self, at: &mut Coordinates, value: f64) {
        match (self, at) {
            (Self::X, Coordinates::Planar(c)) => c.x = value,
            (Self::Y, Coordinates::Planar(c)) => c.y = value,
            (Self::Theta, Coordinates::Planar(c)) => c.theta = value,
            (Self::U, Coordinates::Axes { u, .. }) => *u = value,
            (Self::V, Coordinates::Axes { v, .. }) => *v = value,
            _ => {}
        }
    }

    /// Value in a configuration; `None` if that is of another class.
    pub const fn of(self, at: Coordinates) -> Option<f64> {
        match (self, at) {
            (Self::X, Coordinates::Planar(c)) => Some(c.x),
            (Self::Y, Coordinates::Planar(c)) => Some(c.y),
            (Self::Theta, Coordinates::Planar(c)) => Some(c.theta),
            (Self::U, Coordinates::Axes { u, .. }) => Some(u),
            (Self::V, Coordinates::Axes { v, .. }) => Some(v),
            _ => None,
        }
    }
}

/// Quantity measured on the configuration space of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// The length of the whole range of a coordinate that is free around a configuration, the others held.
    Play {
        /// The coordinate.
        of: Coordinate,
        /// The configuration.
        at: Coordinates,
    },
    /// The value of a coordinate where a motion of constant rates meets the first contact.
    Position {
        /// Configuration at the start.
        from: Coordinates,
        /// Total displacement.
        along: Coordinates,
        /// The coordinate.
        of: Coordinate,
    },
    /// The distance of the parts at a configuration.
    Clearance {
        /// The configuration.
        at: Coordinates,
    },
    /// The angle between the common normal of two features and the motion of the point where they touch when a coordinate changes:
    /// the pressure angle, 0 where the one pushes the other straight on.
    Angle {
        /// The configuration, at which the nearest features count.
        at: Coordinates,
        /// A displacement to a first contact, whose features count then.
        along: Option<Coordinates>,
        /// The coordinate.
        of: Coordinate,
    },
    /// The clearance of the widest motion from one configuration to another, where it is narrowest.
    Bottleneck {
        /// Configuration at the start.
        at: Coordinates,
        /// Configuration at the end.
        to: Coordinates,
    },
    /// The largest or the smallest value of a coordinate in the free region of a configuration.
    Extreme {
        /// The configuration.
        at: Coordinates,
        /// The coordinate.
        of: Coordinate,
        /// Whether the largest value is meant, and not the smallest.
        upper: bool,
    },
    /// Whether the free region of a configuration is bounded.
    Caged {
        /// The configuration.
        at: Coordinates,
    },
    /// Whether a motion without overlap connects two configurations.
    Connected {
        /// First configuration.
        at: Coordinates,
        /// Second configuration.
        to: Coordinates,
    },
    /// The largest clearance of a configuration in a box, less than 0 where none is free: by how much the moving part is larger all around
    /// than one that is.
    Fits {
        /// The middle of the box.
        at: Coordinates,
        /// Half its extent in x, y and θ.
        within: [f64; 3],
    },
    /// A quantity of two parts on axes over all motions that their ranges allow.
    Ranges {
        /// The quantity.
        what: OverRanges,
        /// A configuration in the free region that counts.
        at: Coordinates,
    },
}

/// Quantity of two parts on axes over all motions that their ranges allow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OverRanges {
    /// The smallest distance of the parts, 0 if they touch somewhere.
    Clearance,
    /// Whether the part of a coordinate comes to both ends of its range, or around.
    Reaches(Coordinate),
    /// By how much a coordinate changes for each unit of the other, where neither part can turn without the other.
    Follows(Coordinate),
    /// Whether neither part can turn without the other.
    Together,
    /// The largest play of a coordinate while the other part is held, over a turn, where neither can turn without the other.
    Backlash(Coordinate),
}

impl OverRanges {
    /// The name in a model.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Clearance => "clearance",
            Self::Reaches(_) => "reaches",
            Self::Follows(_) | Self::Together => "follows",
            Self::Backlash(_) => "backlash",
        }
    }
}

impl Quantity {
    /// The configuration at which it is measured, or where its motion begins.
    pub const fn at(&mut self) -> &mut Coordinates {
        match self {
            Self::Play { at, .. }
            | Self::Clearance { at }
            | Self::Angle { at, .. }
            | Self::Bottleneck { at, .. }
            | Self::Extreme { at, .. }
            | Self::Caged { at }
            | Self::Connected { at, .. }
            | Self::Fits { at, .. }
            | Self::Ranges { at, .. }
            | Self::Position { from: at, .. } => at,
        }
    }
}

/// Target of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// Range from one limit to another, both included.
    Limits(f64, f64),
    /// True or false.
    Equals(bool),
}

//! Faults in the dynamic data of a mechanism.

use core::fmt;

/// A fault: the item, the key, and what is wrong. [`help`](DynamicsFault::help) of the fault says what to do.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{item}, {key}: {fault}; {}", fault.help())]
pub struct DynamicsError {
    /// Item that has the fault.
    pub item: DynamicsItem,
    /// Key of the value, as in a model file.
    pub key: &'static str,
    /// Kind of fault.
    pub fault: DynamicsFault,
}

/// Item of a mechanism that can have a fault, by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DynamicsItem {
    /// The mechanism as a whole.
    Mechanism,
    /// A part.
    Part(usize),
    /// Contact data of two parts.
    Pair(usize, usize),
    /// A drive.
    Drive(usize),
    /// A load.
    Load(usize),
    /// A spring.
    Spring(usize),
}

/// Kind of fault of a value.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum DynamicsFault {
    /// A number is infinite or NaN.
    NotFinite,
    /// A number that must be positive is not.
    NotPositive(f64),
    /// A number that must not be negative is.
    Negative(f64),
    /// A coefficient of restitution is not between 0 and 1.
    NotUpToOne(f64),
    /// An inertia is given for a part without mass.
    NoMass,
    /// No part has this index.
    NoSuchPart {
        /// The index.
        part: usize,
        /// Number of parts.
        parts: usize,
    },
    /// The part cannot move.
    StandsStill,
    /// The part moves freely, so it cannot be driven along an axis.
    MovesFreely,
    /// Three numbers are given for a part on an axis.
    OnAnAxis,
    /// One number is given for a part that moves freely.
    InThePlane,
    /// A position along an axis is outside the range of the part's motion.
    OutOfRange {
        /// The position.
        value: f64,
        /// The lower limit.
        lo: f64,
        /// The upper limit.
        hi: f64,
    },
    /// A part has two drives.
    DrivenTwice {
        /// The earlier drive.
        first: usize,
    },
    /// The start or the rate is given for a part whose drive already gives it.
    Driven {
        /// The drive.
        drive: usize,
    },
    /// A table has fewer than two points.
    ShortTable {
        /// Number of points.
        points: usize,
    },
    /// A time of a table is not after the previous one.
    TimeOrder {
        /// The later point.
        point: usize,
        /// Its time.
        time: f64,
        /// The previous time.
        before: f64,
    },
    /// Two parts have a friction or restitution of their own but are not a pair of the mechanism.
    NoPair,
    /// Two parts have two entries for their own friction or restitution.
    PairTwice,
    /// A spring connects a part to itself.
    OnePart,
    /// A spring has neither stiffness nor damping.
    Idle,
}

impl fmt::Display for DynamicsItem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mechanism => f.write_str("the mechanism"),
            Self::Part(i) => write!(f, "part {i}"),
            Self::Pair(a, b) => write!(f, "the pair of parts {a} and {b}"),
            Self::Drive(i) => write!(f, "drive {i}"),
            Self::Load(i) => write!(f, "load {i}"),
            Self::Spring(i) => write!(f, "spring {i}"),
        }
    }
}

impl fmt::Display for DynamicsFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite => f.write_str("a number is not finite"),
            Self::NotPositive(x) => write!(f, "{x:?} is not positive"),
            Self::Negative(x) => write!(f, "{x:?} is negative"),
            Self::NotUpToOne(x) => write!(f, "{x:?} is not from 0 to 1"),
            Self::NoMass => f.write_str("the part has an inertia and no mass"),
            Self::NoSuchPart { part, parts } => {
                write!(f, "there is no part {part}: there are {parts}")
            }
            Self::StandsStill => f.write_str("the part stands still"),
            Self::MovesFreely => f.write_str("the part moves freely and cannot be driven"),
            Self::OnAnAxis => {
                f.write_str("three numbers for a part that turns or slides on an axis")
            }
            Self::InThePlane => f.write_str("one number for a part that moves freely"),
            Self::OutOfRange { value, lo, hi } => write!(
                f,
                "{value:?} is outside of the range of the part's motion, {lo:?} to {hi:?}"
            ),
            Self::DrivenTwice { first } => write!(f, "drive {first} drives the same part"),
            Self::Driven { drive } => write!(f, "drive {drive} already says it"),
            Self::ShortTable { points: 1 } => f.write_str("a table of one point"),
            Self::ShortTable { points } => write!(f, "a table of {points} points"),
            Self::TimeOrder {
                point,
                time,
                before,
            } => write!(
                f,
                "the time {time:?} of point {point} is not after the time before, {before:?}"
            ),
            Self::NoPair => f.write_str("the two parts are no pair of the mechanism"),
            Self::PairTwice => f.write_str("the two parts have it already"),
            Self::OnePart => f.write_str("a spring between a part and itself"),
            Self::Idle => f.write_str("a spring without stiffness and damping does nothing"),
        }
    }
}

impl DynamicsFault {
    /// Text that says how to correct the fault.
    pub const fn help(&self) -> &'static str {
        match self {
            Self::NotFinite => "give finite numbers",
            Self::NotPositive(_) => "give a number above 0, or leave it out",
            Self::Negative(_) => "give 0 or more",
            Self::NotUpToOne(_) => {
                "give a number from 0, where parts do not bounce, to 1, where they lose no speed"
            }
            Self::NoMass => "give the part a mass or a density, or leave out the inertia",
            Self::NoSuchPart { .. } => "choose one of the parts, counted from 0",
            Self::StandsStill => "leave it out, or give the part a motion other than fixed",
            Self::MovesFreely => {
                "drive a part whose motion is revolute or prismatic, and let it push this one"
            }
            Self::OnAnAxis => "give one number, how far along its axis",
            Self::InThePlane => "give three numbers, [x, y, theta] or their rates",
            Self::OutOfRange { .. } => "stay within the range, or widen it",
            Self::DrivenTwice { .. } => "keep one of the two",
            Self::Driven { .. } => "leave it out, or remove the drive",
            Self::ShortTable { .. } => "give two points or more, [[t, u], [t, u], ...]",
            Self::TimeOrder { .. } => "order the points by time, each time once",
            Self::NoPair => "list the two parts among the pairs",
            Self::PairTwice => "give it once",
            Self::OnePart => {
                "name two different parts, or one part alone for a spring to the ground"
            }
            Self::Idle => "give a stiffness, a damping or both",
        }
    }
}

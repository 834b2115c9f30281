//! Result of a displacement.

use cspace::pair::PairMotion;
use cspace::{Coordinates, Location, MotionError, PairSpace, QueryError};

use crate::motion::Motion;
use crate::touching::{FeaturePair, touching};

/// How a displacement ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Nothing touches all the way.
    Free,
    /// It meets a first contact.
    Contact,
    /// The parts overlap where it begins.
    Blocked,
    /// It leaves the window of orientations or the range of a motion.
    Leaves,
}

impl Outcome {
    /// In one word: `free`, `contact`, `blocked` or `leaves`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::Contact => "contact",
            Self::Blocked => "blocked",
            Self::Leaves => "leaves",
        }
    }
}

/// A displacement, as far as it goes.
#[derive(Debug, Clone, PartialEq)]
pub struct Displaced {
    /// How it ends.
    pub outcome: Outcome,
    /// How much of it is done, from 0 to 1.
    pub fraction: f64,
    /// Where it ends.
    pub at: Coordinates,
    /// Features in contact there.
    pub features: Vec<FeaturePair>,
}

/// Moves from a configuration by a displacement, which is the motion's rate, up to the first contact.
///
/// # Errors
/// If the configuration is outside the space or in the coordinates of another class, or numbers are not finite.
pub fn displace(space: &PairSpace, motion: &Motion) -> Result<Displaced, QueryError> {
    if space.locate(motion.from)? == Location::Outside {
        return Err(QueryError::Outside);
    }
    let (outcome, fraction, features) = match motion.first_contact(space, 1.0) {
        Err(QueryError::Motion(MotionError::StartsBlocked)) => (Outcome::Blocked, 0.0, Vec::new()),
        Err(error) => return Err(error),
        Ok(PairMotion::Free) => (Outcome::Free, 1.0, Vec::new()),
        Ok(PairMotion::Leaves { time }) => (Outcome::Leaves, time, Vec::new()),
        Ok(PairMotion::Contact(contact)) => {
            let features = touching(space, motion, &contact)?;
            (Outcome::Contact, contact.time, features)
        }
    };
    Ok(Displaced {
        outcome,
        fraction,
        at: motion.at(fraction),
        features,
    })
}

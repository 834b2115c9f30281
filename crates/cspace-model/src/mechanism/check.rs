//! Checks of a mechanism.

use std::collections::HashMap;

use cspace::fixed_axes::AxisMotion;
use cspace::pair::{Joint, PairError};
use cspace::space::LONGEST_WINDOW;

use super::dynamics::DynamicsError;
use super::entries::{JointEntry, Mechanism, PairEntry, PartEntry};

/// Reason why a mechanism is rejected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MechanismError {
    /// Two parts have the same name.
    #[error(
        "part {part}: the name is already that of part {first}; give every part a name of its own"
    )]
    SameName {
        /// The later part.
        part: usize,
        /// The earlier part.
        first: usize,
    },
    /// A declared symmetry is not a symmetry of the outline.
    #[error(
        "part {part} is not {declared}-fold symmetric, but {largest}-fold; turning it by 360/{declared} degrees about its centre does not map its outline to itself"
    )]
    Symmetry {
        /// The part.
        part: usize,
        /// The fold that is declared.
        declared: u32,
        /// The largest fold of the outline.
        largest: u32,
    },
    /// No part has this index.
    #[error("there is no part {part}: there are {parts}")]
    NoSuchPart {
        /// The index.
        part: usize,
        /// Number of parts.
        parts: usize,
    },
    /// A joint joins a part to itself.
    #[error("joint {joint} joins a part to itself; a joint connects two different parts")]
    JoinsItself {
        /// The joint.
        joint: usize,
    },
    /// Two joints join the same parts.
    #[error("joint {joint} joins the same parts as joint {first}; keep one of the two")]
    JoinedTwice {
        /// The later joint.
        joint: usize,
        /// The earlier joint.
        first: usize,
    },
    /// A joint with a part that does not move contradicts the other part's motion.
    #[error(
        "joint {joint} does not let part {part} move as its motion says; give both the same type and the same centre or direction"
    )]
    Contradiction {
        /// The joint.
        joint: usize,
        /// The part that moves.
        part: usize,
    },
    /// A part is paired with itself.
    #[error("pair {pair} is a part and itself; name two different parts")]
    PairedWithItself {
        /// The pair.
        pair: usize,
    },
    /// A pair is listed twice.
    #[error("pair {pair} is the same pair as pair {first}; list every pair once")]
    PairedTwice {
        /// The later entry.
        pair: usize,
        /// The earlier entry.
        first: usize,
    },
    /// A window of orientations is empty or more than a turn.
    #[error("pair {pair}: the window from {lo} to {hi} is not an interval of at most one turn")]
    Window {
        /// The pair.
        pair: usize,
        /// First orientation.
        lo: f64,
        /// Last orientation.
        hi: f64,
    },
    /// Dynamic data of the mechanism are invalid.
    #[error("{0}")]
    Dynamics(DynamicsError),
    /// The configuration space of a pair cannot be computed.
    #[error("{fixed} and {moving}: {error}")]
    Pair {
        /// Name of the fixed part.
        fixed: String,
        /// Name of the moving part.
        moving: String,
        /// Reason.
        error: PairError,
    },
}

/// Relative tolerance, compared with the size of the drawing, within which centres and directions of a joint and a motion are equal:
/// coordinates are rounded in drawings.
const SAME: f64 = 1e-6;

impl Mechanism {
    /// Checks the mechanism: names and pairs are unique, indices are those of parts, joints agree with motions, and the dynamic data fit
    /// the parts.
    ///
    /// # Errors
    /// The first fault, in the order parts, joints, pairs, dynamics.
    pub fn check(&self) -> Result<(), MechanismError> {
        let mut names = HashMap::new();
        for (i, entry) in self.parts.iter().enumerate() {
            let members = entry.members.iter().map(|m| m.name.as_str());
            for name in [entry.part.name()].into_iter().chain(members) {
                if let Some(first) = names.insert(name, i) {
                    return Err(MechanismError::SameName { part: i, first });
                }
            }
            entry.check(i)?;
        }
        for (i, joint) in self.joints.iter().enumerate() {
            joint.check(i, &self.joints[..i], &self.parts)?;
        }
        let mut known = HashMap::new();
        for (i, pair) in self.pairs.iter().enumerate() {
            pair.check(i, self.parts.len())?;
            let both = (pair.fixed.min(pair.moving), pair.fixed.max(pair.moving));
            if let Some(first) = known.insert(both, i) {
                return Err(MechanismError::PairedTwice { pair: i, first });
            }
        }
        self.dynamics.check(self).map_err(MechanismError::Dynamics)
    }
}

impl PartEntry {
    /// Checks that the outline, of part number `part`, has the declared symmetry.
    ///
    /// # Errors
    /// If it does not.
    pub fn check(&self, part: usize) -> Result<(), MechanismError> {
        match self.symmetry {
            Some(declared) if !self.part.is_symmetric(declared) => Err(MechanismError::Symmetry {
                part,
                declared,
                largest: self.part.symmetry().fold(),
            }),
            _ => Ok(()),
        }
    }
}

impl JointEntry {
    /// Checks that joint number `joint` connects two parts that no previous joint connects, and that their motions are compatible with it.
    ///
    /// # Errors
    /// If not.
    pub fn check(
        &self,
        joint: usize,
        before: &[Self],
        parts: &[PartEntry],
    ) -> Result<(), MechanismError> {
        let (a, b) = self.parts;
        check_two(self.parts, parts.len())?;
        if a == b {
            return Err(MechanismError::JoinsItself { joint });
        }
        let same = |j: &Self| j.parts == (a, b) || j.parts == (b, a);
        if let Some(first) = before.iter().position(same) {
            return Err(MechanismError::JoinedTwice { joint, first });
        }
        // A joint with a part that does not move leaves the other part only the motion of the joint.
        let still = |i: usize| parts[i].axis.is_some_and(|x| x.motion == AxisMotion::Fixed);
        let part = match (still(a), still(b)) {
            (true, _) => b,
            (_, true) => a,
            _ => return Ok(()),
        };
        if self.lets_move(&parts[part]) {
            Ok(())
        } else {
            Err(MechanismError::Contradiction { joint, part })
        }
    }

    /// Whether a part that is joined to one that does not move can move along its axis.
    fn lets_move(&self, moving: &PartEntry) -> bool {
        let Some(axis) = moving.axis else { return true };
        match (self.joint, axis.motion) {
            (Joint::Revolute { at }, AxisMotion::Revolute { center }) => {
                at.distance(center) <= SAME * (moving.part.size() + at.to_vector().length())
            }
            (Joint::Prismatic { direction: d, .. }, AxisMotion::Prismatic { direction: e }) => {
                d.unit().cross(e.unit()).abs() <= SAME
            }
            _ => false,
        }
    }
}

impl PairEntry {
    /// Checks that pair number `pair` names two of the parts, and that its window is an interval of at most one turn.
    ///
    /// # Errors
    /// If not.
    pub fn check(&self, pair: usize, parts: usize) -> Result<(), MechanismError> {
        check_two((self.fixed, self.moving), parts)?;
        if self.fixed == self.moving {
            return Err(MechanismError::PairedWithItself { pair });
        }
        match self.window {
            Some((lo, hi)) if !(lo < hi && hi - lo <= LONGEST_WINDOW) => {
                Err(MechanismError::Window { pair, lo, hi })
            }
            _ => Ok(()),
        }
    }
}

/// Checks that two indices are those of parts.
fn check_two((a, b): (usize, usize), parts: usize) -> Result<(), MechanismError> {
    let part = a.max(b);
    if part < parts {
        Ok(())
    } else {
        Err(MechanismError::NoSuchPart { part, parts })
    }
}

//! Mechanisms: parts, their motions, joints, pairs of interest, and data of motions. It reads no files.

mod body;
mod check;
mod dynamics;
mod entries;
mod relation;

pub use body::BodyError;
pub use check::MechanismError;
pub use dynamics::{
    Drive, DriveMotion, Dynamics, DynamicsError, DynamicsFault, DynamicsItem, Load, LoadKind, Mass,
    MassProperties, PairSurface, PartDynamics, PartPosition, PartVelocity, Spring, SpringKind,
};
pub use entries::{JointEntry, Mechanism, Member, PairEntry, PartEntry, Show, View};
pub use relation::{Compute, compute_anew};

#[cfg(test)]
mod tests;

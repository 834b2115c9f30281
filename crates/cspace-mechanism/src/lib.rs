//! Mechanisms: parts, their motions, joints, and pairs of interest.
//!
//! A [`Mechanism`] determines the relation of the two parts of every pair ([`Mechanism::relation`]), and so the method by which its
//! configuration space is computed ([`Mechanism::compute`]). Its [`Dynamics`] are the data for its motion.
//!
//! Data of this crate can be written and read by `serde`. The crate reads no files and prints nothing: `cspace-io` reads models.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod check;
mod dynamics;
mod entries;
mod relation;

pub use check::MechanismError;
pub use dynamics::{
    Drive, DriveMotion, Dynamics, DynamicsError, DynamicsFault, DynamicsItem, Load, LoadKind, Mass,
    MassProperties, PairSurface, PartDynamics, PartPosition, PartVelocity, Spring, SpringKind,
};
pub use entries::{JointEntry, Mechanism, PairEntry, PartEntry};
pub use relation::{Compute, compute_anew};

#[cfg(test)]
mod tests;

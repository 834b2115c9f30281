//! Mechanisms: parts, how each may move, how they are joined, and which pairs of them matter.
//!
//! A [`Mechanism`] says of every pair how its two parts are related ([`Mechanism::relation`]), and so by which method its
//! configuration space is computed ([`Mechanism::compute`]). Its [`Dynamics`] say what makes it move.

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
pub use relation::Compute;

#[cfg(test)]
mod tests;

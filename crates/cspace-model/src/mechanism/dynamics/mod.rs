//! Dynamic data of a mechanism: masses, gravity, drives, loads and springs.
//!
//! Lengths are in the model's unit, times in seconds, masses in kg, angles in radians; so forces are in kg·unit/s², torques
//! and the stiffness of torsion springs in kg·unit²/s².

mod at;
mod check;
mod data;
mod fault;
mod force;
mod mass;
mod motion;
mod properties;

pub use data::{Dynamics, PairSurface, PartDynamics};
pub use fault::{DynamicsError, DynamicsFault, DynamicsItem};
pub use force::{Load, LoadKind, Spring, SpringKind};
pub use mass::{Mass, MassProperties};
pub use motion::{Drive, DriveMotion, PartPosition, PartVelocity};

#[cfg(test)]
mod tests;

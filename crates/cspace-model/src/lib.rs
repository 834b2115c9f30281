//! Mechanisms of planar parts and their files: reads models, writes and reads configuration spaces.
//!
//! A [`Mechanism`] has parts, their motions, joints, and the pairs of interest. It determines the relation of the two parts of every
//! pair ([`Mechanism::relation`]), and so the method by which its configuration space is computed ([`Mechanism::compute`]). Its
//! [`Dynamics`] are the data for its motion.
//!
//! [`read`] reads a file, of a model or of a space; [`model::read`] and [`saved::read`] read one kind. Every error is a
//! [`ModelError`]: it names the file, the line, the part, loop and vertex, and gives advice.
//!
//! Saved contact spaces are JSON; `docs/contact-space.schema.json` in the project's repository describes them field by
//! field. [`write`](mod@write) has meshes and pictures.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod angle;
mod file;
mod mechanism;
pub mod model;
mod quantity;
pub mod saved;
pub mod shown;
pub mod write;

pub use angle::parse_angle;
pub use cspace::LARGEST_ANGLE;
pub use file::{Host, Refused};
pub use mechanism::{
    BodyError, Compute, Drive, DriveMotion, Dynamics, DynamicsError, DynamicsFault, DynamicsItem,
    JointEntry, Load, LoadKind, Mass, MassProperties, Mechanism, MechanismError, Member, PairEntry,
    PairSurface, PartDynamics, PartEntry, PartPosition, PartVelocity, Show, Spring, SpringKind,
    View, compute_anew,
};
pub use model::{Model, ModelError};
pub use quantity::{Quantity, Shown};
pub use saved::{Document, SavedFile, read, read_from, read_from_hosted, read_hosted};

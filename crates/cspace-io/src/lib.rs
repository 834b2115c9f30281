//! Model files for `cspace`, and writers for contact spaces.

pub mod model;
pub mod write;

pub use model::{Joint, JointKind, Model, ModelError, Motion, Pair, PairClass, PartEntry};

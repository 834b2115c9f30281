//! Model files for `cspace`, and writers for contact spaces.

pub mod model;

pub use model::{Joint, JointKind, Model, ModelError, Motion, Pair, PairClass, PartEntry};

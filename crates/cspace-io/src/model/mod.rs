//! Mechanisms and their file format: parts, motions, joints and pairs, in TOML or JSON.
//!
//! A file is read in three steps, each of which reports what it finds wrong as a [`ModelError`]: bytes become text,
//! text becomes a tree of values, the tree becomes a [`Model`].

mod class;
mod error;
mod locate;
mod mechanism;
mod node;
mod parts;
mod place;
mod read;
mod relations;
mod suggest;
mod table;
mod to_toml;

pub(crate) use read::no_json;

pub use cspace::PairClass;
pub use error::ModelError;
pub use mechanism::{Joint, JointKind, Model, Motion, Pair, PartEntry};

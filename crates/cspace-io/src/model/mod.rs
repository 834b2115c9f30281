//! File format of mechanisms: parts, motions, joints, pairs, and dynamics, in TOML or JSON.
//!
//! A file is read in three steps, each of which reports errors as a [`ModelError`]: bytes become text, text becomes a
//! tree of values, the tree becomes a [`Mechanism`](cspace_mechanism::Mechanism). `docs/model.md` in the project's repository
//! describes the format, [`schema()`] is its schema.

mod drawings;
mod dynamics;
mod entry;
mod error;
mod expression;
mod fit;
mod forces;
mod keys;
mod locate;
mod loops;
mod measure;
mod names;
mod node;
mod outline;
mod parameters;
mod part_dynamics;
mod parts;
mod pattern;
mod place;
mod profile;
mod read;
mod relations;
mod requirements;
mod schema;
mod scope;
mod slips;
mod slopes;
mod snap;
mod suggest;
mod table;
mod to_json;
mod to_toml;
mod tolerance;
mod toml_dynamics;
mod toml_values;
mod value;

pub(crate) use read::no_json;

pub(crate) use drawings::Files;
pub use error::ModelError;
pub use parameters::{Parameter, Setting};
pub use read::{MOST_PARTS, Model, Template, from_json, from_toml, read};
pub(crate) use read::{from_text, json_in, read_hosted, toml_in};
pub use requirements::{
    Coordinate, Dimension, Happening, MotionQuantity, Quantity, Requirement, Subject, Target,
};
pub use schema::schema;
pub use slips::{Slip, slips};
pub use slopes::{PartSlopes, RequirementSlopes, Slopes};
pub use snap::{Snapped, snap};
pub use to_json::to_json;
pub use to_toml::to_toml;
pub use tolerance::{Distribution, Position};

//! File format of mechanisms: parts, motions, joints, pairs, and dynamics, in TOML or JSON.
//!
//! A file is read in three steps, each of which reports errors as a [`ModelError`]: bytes become text, text becomes a
//! tree of values, the tree becomes a [`Mechanism`](crate::mechanism::Mechanism). An expression is evaluated where a number is
//! read, so that no name is taken for one. `docs/model.md` in the project's repository describes the format, [`schema()`] is its
//! schema.

mod bodies;
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
mod placement;
mod profile;
mod read;
mod relations;
mod requirements;
mod schema;
mod scope;
mod show;
mod slips;
mod slopes;
mod snap;
mod suggest;
mod table;
mod template;
mod to_json;
mod to_toml;
mod tolerance;
mod toml_dynamics;
mod toml_values;
mod union;
mod unmoved;
mod value;

pub use error::ModelError;
pub use parameters::{Parameter, Setting};
pub use read::{MOST_PARTS, Model};
pub use requirements::{
    Coordinate, Dimension, Happening, MotionQuantity, OverRanges, Quantity, Requirement, Subject,
    Target,
};
pub use schema::schema;
pub use slips::{Slip, slips};
pub use slopes::{PartSlopes, RequirementSlopes, Slopes};
pub use snap::{Snapped, snap};
pub use template::{Template, from_json, from_toml, read};
pub(crate) use template::{from_text, in_text, no_json, read_hosted};
pub use to_json::to_json;
pub use to_toml::to_toml;
pub use tolerance::{Distribution, Position};

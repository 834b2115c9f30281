//! How far two parts are apart while they move.
//!
//! A leg is a motion of constant rates of all coordinates. The least distance of the two boundaries along it is found by branch
//! and bound over pairs of discs around pieces of the boundaries and over time; no bound is sampled. It knows the parts
//! alone, and nothing of their contact space: a path that it passes is free whatever the space says.

mod about;
mod apart;
mod at;
mod body;
mod depth;
mod flat;
mod flats;
mod meet;
mod near;
mod normals;
mod overlap;
mod pieces;
mod pose;
mod scene;
mod search;
mod shape;
mod tree;

pub(crate) use about::{configuration_about, numbers_about};
pub(crate) use body::{Between, Body};
pub use near::Near;
pub use pose::Coords;
pub use scene::Scene;
pub use search::Nearest;

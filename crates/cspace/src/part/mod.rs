//! Planar parts: closed loops of line segments and circular arcs.
//!
//! A [`Part`] is made by [`Part::new`] alone, which checks that its loops bound something; whatever
//! takes a part can rely on that.

mod bounds;
mod check;
mod corner;
mod curve;
mod distance;
mod edge;
mod error;
mod frame;
mod loops;
mod measure;
mod meeting;
mod nearness;
mod outline;
mod status;
mod sweep;
mod symmetry;
pub mod tolerance;
mod vertex;

pub use bounds::Bounds;
pub(crate) use distance::distance_of;
pub use edge::Edge;
pub use error::PartError;
pub use loops::{Loop, Part};
pub(crate) use measure::Inside;
pub(crate) use symmetry::{Corresponding, LoopImage, Symmetrized};
pub use symmetry::{PartSymmetry, SYMMETRIC};
pub use vertex::Vertex;

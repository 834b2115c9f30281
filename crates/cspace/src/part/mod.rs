//! Planar parts: closed loops of line segments and circular arcs.

mod edge;
mod error;
mod loops;
mod vertex;

pub use edge::Edge;
pub use error::PartError;
pub use loops::{Loop, Part};
pub use vertex::Vertex;

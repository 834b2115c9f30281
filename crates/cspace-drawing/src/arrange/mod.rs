//! The arrangement of lines and arcs: the faces into which they divide the plane.
//!
//! ```text
//! edges ──split──> pieces between vertices ──cycles──> boundary cycles ──faces──> faces ──boundary──> loops
//! ```
//!
//! [`split`] cuts edges where they cross, touch or overlap, and takes places within a tolerance as one vertex.
//! [`cycles`] orders the pieces around each vertex, removes those that bound nothing, and follows the boundaries.
//! [`faces`] finds which cycles lie within which, and the face at a point; [`enclosed`] by which closed curves a face is enclosed;
//! [`boundary`] makes loops of chosen faces.

mod boundary;
mod cycles;
mod enclosed;
mod faces;
mod split;

pub(crate) use boundary::{BoundaryEdge, around, boundary};
pub(crate) use enclosed::enclosed;
pub(crate) use faces::Faces;
pub(crate) use split::{Arrangement, split};

#[cfg(test)]
mod tests;

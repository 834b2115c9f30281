//! Exact configuration spaces of planar parts bounded by line segments and circular arcs.

pub mod geometry;
pub mod part;

pub use geometry::{Configuration, Point, Rotation, Vector};
pub use part::{Edge, Loop, Part, PartError, Vertex};

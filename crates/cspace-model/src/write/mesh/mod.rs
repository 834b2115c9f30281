//! The contact surface as triangles.
//!
//! Orientations are cut into slabs: at every critical orientation, and between these as finely as the tolerance asks
//! for. At each level (an end of slabs) the curves of the patches become rows of vertices, shared by the slab below and
//! the slab above; within a slab each patch is a strip between two rows. Neighbours along a row share its ends. At a
//! critical orientation curves of different patches lie on each other, from below or above: they are cut at each
//! other's ends, and pieces that coincide have the same vertices.

mod level;
mod strip;
mod surface;
#[cfg(test)]
mod tests;

pub use surface::{Mesh, MeshError, MeshOptions, Openings, Triangle};

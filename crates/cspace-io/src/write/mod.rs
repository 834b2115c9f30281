//! Writers for contact spaces and slices.

pub mod mesh;
pub mod ply;
pub mod svg;

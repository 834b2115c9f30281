//! Writers for contact spaces and slices.

pub mod glb;
pub mod mesh;
pub mod obj;
pub mod ply;
pub mod stl;
pub mod svg;
pub mod svg_axes;

//! Writers for contact surfaces.

pub mod glb;
pub mod mesh;
pub mod obj;
pub mod ply;
pub mod stl;

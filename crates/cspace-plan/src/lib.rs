//! Paths between configurations of planar parts, or the proof that there is none.

pub mod legs;
mod push;
mod route;

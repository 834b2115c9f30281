//! Paths made better: more clearance, then fewer legs.

mod legs;
mod outside;
mod raise;
mod search;
mod shorten;
mod simple;
mod steps;
mod tidy;
mod tracks;
mod unwind;

pub(crate) use legs::Legs;
pub(crate) use outside::Outside;
pub use simple::Prefer;
pub(crate) use steps::{MOST_LEGS, divided};

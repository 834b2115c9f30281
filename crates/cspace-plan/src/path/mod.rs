//! Paths made better: more clearance, then fewer legs.

mod legs;
mod raise;
mod shorten;
mod steps;

pub(crate) use legs::Legs;
pub(crate) use steps::{MOST_LEGS, divided};

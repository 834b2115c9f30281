//! Points, vectors, rotations and configurations of the plane.

mod configuration;
mod convert;
mod point;
mod rotation;

pub use configuration::Configuration;
pub use point::{Point, Vector};
pub use rotation::{LARGEST_ANGLE, Rotation};
pub(crate) use rotation::{images, time_of_known_angle, unwrap_near, wrap};

#[cfg(test)]
mod tests;

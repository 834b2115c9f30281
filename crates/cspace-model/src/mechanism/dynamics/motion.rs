//! Initial positions and velocities of parts, and prescribed motions.

use cspace::geometry::{Configuration, Vector};
use serde::{Deserialize, Serialize};

/// Position of a part at the start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PartPosition {
    /// Position of a part without an axis of its own: its frame as seen from the assembly's.
    Planar(Configuration),
    /// Position of a part that turns or slides, along its axis: radians or the model's unit of length.
    Axis(f64),
}

/// Velocity of a part at the start: the derivative of its [`PartPosition`] by time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PartVelocity {
    /// Velocity of a part without an axis of its own.
    Planar {
        /// The velocity of the origin of the part's frame, in the assembly's frame, unit/s.
        linear: Vector,
        /// The angular velocity, rad/s.
        angular: f64,
    },
    /// Velocity of a part that turns or slides: rad/s or unit/s.
    Axis(f64),
}

/// A part whose motion is prescribed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Drive {
    /// The index of the part, which turns or slides.
    pub part: usize,
    /// Motion of the part along its axis.
    pub motion: DriveMotion,
}

/// Motion of a driven part along its axis; its coordinate u is in radians or the model's unit of length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DriveMotion {
    /// Motion at a constant rate from the part's start: rad/s or unit/s.
    Rate(f64),
    /// Motion along a cubic spline through all points (t, u); t in seconds, increasing.
    Table(Vec<(f64, f64)>),
}

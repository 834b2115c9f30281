//! Mechanisms in motion.
#![warn(clippy::print_stdout, clippy::print_stderr)]

mod drive;
mod error;
mod kinematic;
mod linear;
mod pairs;
mod record;
mod simulate;
mod system;

pub use drive::{DriveCurve, Driven};
pub use error::SimulateError;
pub use pairs::{MovingPair, Pairs, Touch};
pub use record::{Event, EventKind, Obstacle, Record, Sample, Status, What};
pub use simulate::{Settings, Simulation};
pub use system::{PartCoordinates, Row, System};

//! Dynamics with contacts: event-driven, on exact contact functions.
//!
//! Between events the bearing contacts are constraints, and their modes (sticking or sliding, and the direction) stay
//! the same: the motion is smooth, and integrated with high order (`flow.rs`). An event is the root of a function: of a
//! gap, of a contact's force, of a rate of sliding, of the friction reserve. It is located approximately on a
//! polynomial through the step, and refined by repeating the step with a shorter length until the function is 0 at its
//! end, to rounding (`step/`). At an event, impacts change velocities at once, and the modes of the contacts are
//! determined anew (`complementarity/`). Impacts that accumulate are closed at their limit (`accumulate.rs`).

mod accumulate;
mod bridge;
mod bridges;
mod change_point;
mod choose;
mod crowd;
mod direct;
mod flow;
mod impact;
mod motion;
mod run;
mod settle;
mod step;
mod stepping;
mod world;

pub use crate::complementarity::Mode;
pub use motion::{Choice, Ended, Event, EventKind, Motion, Observer, Options, Work};
pub use run::{run, run_through};
pub use stepping::step_through;
pub use world::{Acting, Equations, Joints, Sought, State, Step, Surface, Touch, World};

/// Contacts with gaps of this share of the size or less are closed: more than what projection leaves.
pub const CLOSED: f64 = 1e-10;
/// Threshold of rates that count as 0, as a share of the largest so far.
pub const STILL: f64 = 1e-10;

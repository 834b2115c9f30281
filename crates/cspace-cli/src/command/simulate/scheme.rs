//! The integration scheme of the dynamic mode, and its step.

use crate::args::{Mode, Scheme, SimulateArgs};
use crate::failure::Failure;

/// Number of steps unless `--step` gives their length.
const STEPS: f64 = 10_000.0;

/// The length of a step, for the scheme with steps of one length.
pub(super) fn step(args: &SimulateArgs, mode: Mode) -> Result<Option<f64>, Failure> {
    match (args.scheme, args.step) {
        (Scheme::Event, None) => Ok(None),
        (Scheme::Event, Some(_)) => Err(Failure::new(
            "--step is of --scheme stepping; from event to event steps are as long as accuracy allows",
        )
        .help("add --scheme stepping, or leave --step out")),
        (Scheme::Stepping, _) if mode == Mode::Kinematic => Err(Failure::new(
            "--scheme stepping is of the dynamic mode, and the mode is kinematic",
        )
        .help("give the parts a mass or a density, or leave --scheme out")),
        (Scheme::Stepping, step) => Ok(Some(step.unwrap_or(args.time / STEPS))),
    }
}

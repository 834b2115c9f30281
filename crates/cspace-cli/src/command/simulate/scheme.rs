//! Which way the dynamic mode goes on.

use crate::args::{Mode, Scheme, SimulateArgs};
use crate::failure::Failure;

/// So many steps there are unless another length is asked for.
const STEPS: f64 = 10_000.0;

/// The length of steps, of the scheme that has some.
pub(super) fn step(args: &SimulateArgs, mode: Mode) -> Result<Option<f64>, Failure> {
    match (args.scheme, args.step) {
        (Scheme::Event, None) => Ok(None),
        (Scheme::Event, Some(_)) => Err(Failure::input(
            "--step is of --scheme stepping; from event to event steps are as long as accuracy allows",
        )
        .help("add --scheme stepping, or leave --step out")),
        (Scheme::Stepping, _) if mode == Mode::Kinematic => Err(Failure::input(
            "--scheme stepping is of the dynamic mode, and the mode is kinematic",
        )
        .help("give the parts a mass or a density, or leave --scheme out")),
        (Scheme::Stepping, step) => Ok(Some(step.unwrap_or(args.time / STEPS))),
    }
}

//! Computations whose stages are timed.

use std::time::Instant;

use cspace::{ComputeError, ContactSpace, Options, Part, Progress, Stage};

/// A clock, from which the stage times of a space's statistics are computed.
struct Clock(Instant);

impl Progress for Clock {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        Ok(())
    }

    fn seconds(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

/// The contact space of two parts, whose statistics have times.
pub(crate) fn compute(
    fixed: &Part,
    moving: &Part,
    options: &Options,
) -> Result<ContactSpace, ComputeError> {
    ContactSpace::compute_with(fixed, moving, options, &Clock(Instant::now()))
}

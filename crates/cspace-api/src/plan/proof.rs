//! The proof that there is no path, beside the answer.

use cspace::{ComputeError, Coordinates, PairError, PairSpace};
use cspace_plan::proof::{ProofError, prove};

use super::answer::Plan;
use crate::error::Error;
use crate::subject::Chosen;

/// Adds a proof to an answer, or why there is none.
///
/// # Errors
/// If the depth that was asked for is none, or the computation was interrupted.
pub(super) fn add(
    plan: &mut Plan,
    pair: &Chosen<'_>,
    space: &PairSpace,
    ends: [Coordinates; 2],
    depth: Option<f64>,
) -> Result<(), Error> {
    let (PairSpace::Planar(space), [Coordinates::Planar(from), Coordinates::Planar(to)]) =
        (space, ends)
    else {
        plan.unproved = Some(ProofError::NotPlanar.to_string());
        return Ok(());
    };
    let progress = pair.host().begin(&pair.names());
    match prove(space, from, to, depth, &*progress) {
        Ok(mut proof) => {
            proof.unit = pair.unit_label().map(str::to_owned);
            plan.proof = Some(proof);
        }
        Err(ProofError::Depth(d)) => {
            return Err(Error::new(format_args!(
                "{} {d:?}: it has to be positive",
                pair.option("depth")
            )));
        }
        Err(ProofError::Pair(e)) if e == PairError::Compute(ComputeError::Interrupted) => {
            return Err(pair.failure(&e));
        }
        Err(error) => plan.unproved = Some(error.to_string()),
    }
    Ok(())
}

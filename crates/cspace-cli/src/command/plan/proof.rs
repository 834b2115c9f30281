//! The proof that there is no path, beside the answer.

use cspace::{ComputeError, Coordinates, PairError, PairSpace};
use cspace_proof::{ProofError, prove};

use crate::failure::Failure;
use crate::progress::Bar;
use crate::subject::InWords;
use cspace_api::Chosen;

use cspace_api::plan::Told;

/// Adds a proof to an answer, or why there is none.
///
/// # Errors
/// If the depth that was asked for is none, or the computation was interrupted.
pub(super) fn add(
    told: &mut Told,
    pair: &Chosen<'_>,
    space: &PairSpace,
    ends: [Coordinates; 2],
    depth: Option<f64>,
) -> Result<(), Failure> {
    let (PairSpace::Planar(space), [Coordinates::Planar(from), Coordinates::Planar(to)]) =
        (space, ends)
    else {
        told.unproved = Some(ProofError::NotPlanar.to_string());
        return Ok(());
    };
    let proved = Bar::new(pair.names()).watch(|bar| prove(space, from, to, depth, bar));
    match proved {
        Ok(mut proof) => {
            proof.unit = pair.unit_label().map(str::to_owned);
            told.proof = Some(proof);
        }
        Err(ProofError::Depth(d)) => {
            return Err(Failure::new(format_args!(
                "--depth {d:?}: it has to be positive"
            )));
        }
        Err(ProofError::Pair(e)) if e == PairError::Compute(ComputeError::Interrupted) => {
            return Err(pair.failure(&e).into());
        }
        Err(error) => told.unproved = Some(error.to_string()),
    }
    Ok(())
}

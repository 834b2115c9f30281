//! Whole contact spaces of random pairs.

use cspace::Silent;
use cspace_load::{Effort, check};
use cspace_oracle::Case;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::draw::{Bytes, member, nearly_tied};
use crate::{Finding, axes};

/// Largest product of the parts' numbers of edges; larger pairs take long and are left to other tests.
const MOST_EDGES: usize = 600;

/// Number of configurations asked of each contact space.
const CONFIGURATIONS: usize = 60;

/// Bands compared with slices from scratch.
const BANDS: usize = 6;

/// One of so many pairs is also computed the other way round, with two threads, and tried with a classifier.
const THOROUGH: usize = 16;

/// One of so many pairs is put on fixed axes.
const ON_AXES: usize = 4;

pub(crate) fn run(data: &[u8]) -> Result<u64, Finding> {
    let mut bytes = Bytes::new(data);
    let thorough = bytes.below(THOROUGH) == THOROUGH - 1;
    let Some(case) = drawn(&mut bytes) else {
        return Ok(0);
    };
    if case.fixed.edges().count() * case.moving.edges().count() > MOST_EDGES {
        return Ok(0);
    }
    if bytes.below(ON_AXES) == ON_AXES - 1 {
        return axes::run(&case, &mut bytes);
    }
    let effort = Effort {
        configurations: CONFIGURATIONS,
        bands: BANDS,
        thorough,
    };
    // The queries do not depend on how the pair was drawn, so that a smaller input with the same pair has the same
    // findings.
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let about = |f: Finding| f.about(&case.fixed, &case.moving, case.window);
    let report = check(&case, effort, &mut rng, &Silent)
        .map_err(|e| about(Finding::new(format!("no contact space: {e}"))))?;
    if let Some(first) = report.faults.first() {
        let said = format!(
            "{} faults, the first {first:?}; {} conflicts",
            report.faults.len(),
            report.conflicts
        );
        return Err(about(Finding::new(said)));
    }
    Ok(report.certain + report.bands)
}

/// A pair that favours ties, or one of a family; `None` if it is no pair.
fn drawn(bytes: &mut Bytes<'_>) -> Option<Case> {
    if bytes.below(4) > 0 {
        return nearly_tied(bytes).ok();
    }
    member(bytes).ok()
}

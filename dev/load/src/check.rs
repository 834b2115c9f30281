//! Computation and check of one pair.

use std::time::Instant;

use cspace::{
    Classifier, ComputeError, Configuration, ContactSpace, Options, Progress, Slicer, StageSeconds,
};
use cspace_oracle::{Case, Oracle, Verdict};
use rand_chacha::ChaCha8Rng;

use crate::report::{Fault, Report, is_right};
use crate::trial::{CERTAIN, Trial};

/// Effort of a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Number of configurations to ask.
    pub configurations: usize,
    /// Bands to compare with slices from scratch, at most.
    pub bands: usize,
    /// Whether to compute with two threads and the other way round, too, and to try the classifier.
    pub thorough: bool,
}

/// Computes the contact space of a pair, and judges it.
///
/// # Errors
/// Why it could not be computed; or `progress` ended it.
pub fn check(
    case: &Case,
    effort: Effort,
    rng: &mut ChaCha8Rng,
    progress: &dyn Progress,
) -> Result<Report, ComputeError> {
    let options = Options {
        window: case.window,
        ..Options::default()
    };
    let begin = Instant::now();
    let space = ContactSpace::compute_with(&case.fixed, &case.moving, &options, progress)?;
    let features = space.features();
    let mut report = Report {
        conflicts: space.statistics().conflicts,
        computed: begin.elapsed().as_secs_f64(),
        bytes: bytes(&space),
        feature_pairs: u64::from(features.fixed) * u64::from(features.moving),
        ..Report::default()
    };
    let slicer = Slicer::new(&case.fixed, &case.moving);
    let mut trial = Trial {
        case,
        space: &space,
        slicer: &slicer,
        oracle: Oracle::new(&case.fixed, &case.moving),
        rng,
        report: &mut report,
        kept: Vec::new(),
    };
    trial.configurations(effort.configurations);
    trial.bands(effort.bands);
    if effort.thorough {
        let kept = core::mem::take(&mut trial.kept);
        let oracle = trial.oracle;
        report.thorough = true;
        report
            .faults
            .extend(inverse(case, &kept, &oracle, progress)?);
        report.faults.extend(classifier(&space, &kept));
        if !same_with_two_threads(case, &options, &space, progress)? {
            report.faults.push(Fault::Threads);
        }
        let data = space.data();
        if !ContactSpace::from_data(data.clone()).is_ok_and(|s| s.data() == data) {
            report.faults.push(Fault::Saved);
        }
    }
    Ok(report)
}

/// Configurations at which the inverse pair disagrees with the oracle; for a window, it covers the negative
/// orientations.
fn inverse(
    case: &Case,
    kept: &[(Configuration, Verdict)],
    oracle: &Oracle,
    progress: &dyn Progress,
) -> Result<Vec<Fault>, ComputeError> {
    let options = Options {
        window: case.window.map(|(lo, hi)| (-hi, -lo)),
        ..Options::default()
    };
    let back = ContactSpace::compute_with(&case.moving, &case.fixed, &options, progress)?;
    let wrong = kept.iter().filter(|(c, verdict)| {
        let there = c.inverse();
        // The inverse is rounded.
        let rounding = 16.0 * f64::EPSILON * (c.x.abs() + c.y.abs() + there.x.abs());
        let least = (back.resolution()).max(CERTAIN * oracle.size());
        verdict.margin > least + rounding && !is_right(&back, there, *verdict)
    });
    Ok(wrong
        .map(|&(at, verdict)| Fault::Inverse { at, verdict })
        .collect())
}

/// Configurations at which the classifier disagrees with the space it was made from.
fn classifier(space: &ContactSpace, kept: &[(Configuration, Verdict)]) -> Vec<Fault> {
    let classifier = Classifier::new(space);
    kept.iter()
        .filter(|(c, _)| classifier.classify(*c) != space.classify(*c))
        .map(|&(at, _)| Fault::Classifier { at })
        .collect()
}

/// Whether two threads give the same result as this thread's pool.
fn same_with_two_threads(
    case: &Case,
    options: &Options,
    space: &ContactSpace,
    progress: &dyn Progress,
) -> Result<bool, ComputeError> {
    let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(2).build() else {
        // If no more threads are available, the check is skipped.
        return Ok(true);
    };
    let compute = || {
        pool.install(|| ContactSpace::compute_with(&case.fixed, &case.moving, options, progress))
    };
    // A thread of a pool that waits for another pool takes up more work of its own meanwhile, one pair within the other, until
    // its stack is full: so another thread waits.
    let other = std::thread::scope(|s| s.spawn(compute).join());
    let other = other.unwrap_or_else(|panic| std::panic::resume_unwind(panic))?;
    let saved = |space: &ContactSpace| {
        let mut saved = space.data().clone();
        saved.statistics.seconds = StageSeconds::default();
        saved
    };
    Ok(saved(&other) == saved(space))
}

/// Bytes of what grows with a contact space.
fn bytes(space: &ContactSpace) -> u64 {
    let saved = [
        size_of_val(space.patches()),
        size_of_val(space.side_links()),
        size_of_val(space.vertical_links()),
        size_of_val(space.critical_orientations()),
    ];
    saved.iter().sum::<usize>() as u64
}

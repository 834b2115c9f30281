//! One pair, computed and judged.

use std::time::Instant;

use cspace::{
    Classification, ComputeError, Configuration, ContactSpace, Options, Progress, Slicer,
    StageSeconds,
};
use cspace_oracle::{Case, Oracle, Verdict};
use rand_chacha::ChaCha8Rng;

use crate::trial::Trial;

/// How hard to look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Configurations to ask.
    pub configurations: usize,
    /// Bands to compare with slices from scratch, at most.
    pub bands: usize,
    /// Also compute with two threads and the other way round, and try the classifier.
    pub thorough: bool,
}

/// Something that must not be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// A configuration is classified otherwise than by brute force.
    Wrong {
        /// Where.
        at: Configuration,
        /// What brute force says.
        verdict: Verdict,
    },
    /// A slice from scratch that is not doubtful says otherwise than brute force.
    Scratch {
        /// Where.
        at: Configuration,
        /// What brute force says.
        verdict: Verdict,
    },
    /// In the middle of a band the slice of the space and that from scratch have different numbers of loops, and neither is
    /// doubtful.
    Loops {
        /// The orientation.
        theta: f64,
        /// Loops of the space's slice.
        space: usize,
        /// Loops of the slice from scratch.
        scratch: usize,
        /// The width of the band.
        width: f64,
    },
    /// A curve of a slice of the space that is not doubtful does not begin where the one before it ends.
    Open {
        /// The orientation.
        theta: f64,
        /// How far apart, as a share of the size.
        gap: f64,
    },
    /// One thread and two give different contact spaces.
    Threads,
    /// The space is not read back as plain data.
    Saved,
    /// The inverse pair says otherwise than brute force.
    Inverse {
        /// Where, as a configuration of the pair itself.
        at: Configuration,
        /// What brute force says.
        verdict: Verdict,
    },
    /// The classifier says otherwise than the slice.
    Classifier {
        /// Where.
        at: Configuration,
    },
}

/// What came of one pair.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Configurations asked.
    pub asked: u64,
    /// Those whose verdict counts.
    pub certain: u64,
    /// Those of them beside contact.
    pub near: u64,
    /// Those of the certain ones that are free.
    pub free: u64,
    /// Otherwise than the oracle says, but nearer to contact than [`ContactSpace::resolution`].
    pub within_resolution: u64,
    /// Slices taken from the contact space.
    pub slices: u64,
    /// Those of them that are doubtful.
    pub doubtful_slices: u64,
    /// Configurations that these tell otherwise than the oracle, while they are classified rightly.
    pub doubtful_wrong: u64,
    /// Bands sliced from scratch.
    pub bands: u64,
    /// Those of them of which one of the two slices is doubtful: loops are not counted.
    pub doubtful_bands: u64,
    /// Shells decided cell by cell.
    pub conflicts: u64,
    /// Whether the thorough checks were done.
    pub thorough: bool,
    /// Bytes of patches and links.
    pub bytes: u64,
    /// Features of one part times those of the other.
    pub feature_pairs: u64,
    /// Seconds the contact space took.
    pub computed: f64,
    /// What must not be.
    pub faults: Vec<Fault>,
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
        let saved = space.to_saved();
        if !ContactSpace::from_saved(saved.clone()).is_ok_and(|s| s.to_saved() == saved) {
            report.faults.push(Fault::Saved);
        }
    }
    Ok(report)
}

/// Where the inverse pair says otherwise than the oracle: of a window, it covers the negative orientations.
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
        let least = (back.resolution()).max(crate::trial::CERTAIN * oracle.size());
        verdict.margin > least + rounding && !is_right(&back, there, *verdict)
    });
    Ok(wrong
        .map(|&(at, verdict)| Fault::Inverse { at, verdict })
        .collect())
}

/// Whether a configuration is classified as brute force has it.
pub(crate) fn is_right(space: &ContactSpace, c: Configuration, verdict: Verdict) -> bool {
    let expected = if verdict.overlap {
        Classification::Blocked
    } else {
        Classification::Free
    };
    space.classify(c) == Some(expected)
}

/// Where the classifier says otherwise than the space it was made from.
fn classifier(space: &ContactSpace, kept: &[(Configuration, Verdict)]) -> Vec<Fault> {
    let classifier = space.classifier();
    kept.iter()
        .filter(|(c, _)| classifier.classify(*c) != space.classify(*c))
        .map(|&(at, _)| Fault::Classifier { at })
        .collect()
}

/// Whether two threads give what this thread's pool gave.
fn same_with_two_threads(
    case: &Case,
    options: &Options,
    space: &ContactSpace,
    progress: &dyn Progress,
) -> Result<bool, ComputeError> {
    let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(2).build() else {
        // No more threads are to be had: nothing is found out about them.
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
        let mut saved = space.to_saved();
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

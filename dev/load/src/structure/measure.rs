//! Measurements of one space that are certain.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

use cspace::{ComputeError, ContactSpace, Options, Progress, Stage, Window};
use cspace_oracle::{Case, Compared, Fill};

use super::Specimen;
use crate::output::panic_text;

/// Bands of less than this are narrow, radians.
const NARROW: f64 = 1e-5;

/// Effort spent on each specimen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Number of times that boxes of the flood fill are divided; `None` for no flood fill.
    pub flood: Option<u32>,
    /// Whether the pair is also computed with fixed and moving part exchanged.
    pub inverse: bool,
    /// A computation that takes longer is given up when its next stage begins.
    pub patience: Duration,
}

/// Outcome for one specimen.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// Measurements of the pair.
    Measured(Measured),
    /// One of the outlines is no part.
    Refused(String),
    /// There is no space, for this reason.
    GivenUp(String),
    /// The computation panicked.
    Panicked(String),
}

/// Measurements of one pair.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Features of the fixed and the moving part.
    pub features: (u32, u32),
    /// Free regions.
    pub regions: usize,
    /// Shells whose bounds and tests disagree.
    pub conflicts: u64,
    /// Computations of the pair: more than one where an attempt is in conflict, or divides circles that are touched.
    pub runs: u32,
    /// Patches of the contact space.
    pub patches: usize,
    /// Total width of doubtful orientations, radians.
    pub doubtful: f64,
    /// Bands narrower than 10⁻⁵ rad.
    pub narrow: usize,
    /// Duration of the computation.
    pub seconds: f64,
    /// Free regions of the pair with fixed and moving exchanged, which are as many in truth.
    pub inverse: Option<usize>,
    /// Result of a flood fill.
    pub flood: Option<Flood>,
}

/// Result of a flood fill, compared with the number of free regions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Flood {
    /// The flood fill confirms this number, except for pockets smaller than a box.
    Agrees(usize),
    /// The flood fill finds this number, except for pockets smaller than a box, and the space has more.
    Fewer(usize),
    /// The boxes are too large: there are at least this many regions.
    CannotTell(usize),
    /// The regions of the space contradict it.
    Wrong(Vec<String>),
}

/// Breaks off what takes too long, and counts computations by their first stage.
struct Watch {
    deadline: Instant,
    runs: AtomicU32,
}

impl Watch {
    fn new(patience: Duration) -> Self {
        Self {
            deadline: Instant::now() + patience,
            runs: AtomicU32::new(0),
        }
    }
}

impl Progress for Watch {
    fn stage(&self, stage: Stage) -> Result<(), ComputeError> {
        if stage == Stage::Sheets {
            self.runs.fetch_add(1, Ordering::Relaxed);
        }
        if Instant::now() > self.deadline {
            return Err(ComputeError::Interrupted);
        }
        Ok(())
    }
}

/// Computes the space of a specimen.
pub fn measure(specimen: &Specimen, effort: Effort) -> Outcome {
    let case = match specimen.case() {
        Ok(case) => case,
        Err(error) => return Outcome::Refused(error.to_string()),
    };
    match catch_unwind(AssertUnwindSafe(|| measured(&case, effort))) {
        Ok(Ok(measured)) => Outcome::Measured(measured),
        Ok(Err(error)) => Outcome::GivenUp(error.to_string()),
        Err(panic) => Outcome::Panicked(panic_text(&*panic).to_owned()),
    }
}

fn measured(case: &Case, effort: Effort) -> Result<Measured, ComputeError> {
    let begin = Instant::now();
    let options = Options {
        window: case.window,
        ..Options::default()
    };
    let watch = Watch::new(effort.patience);
    let space = ContactSpace::compute_with(&case.fixed, &case.moving, &options, &watch)?;
    let seconds = begin.elapsed().as_secs_f64();
    // Relative orientations of the inverse are the negative ones.
    let inverse = if effort.inverse {
        let options = Options {
            window: case.window.map(|(lo, hi)| (-hi, -lo)),
            ..Options::default()
        };
        let watch = Watch::new(effort.patience);
        let inverse = ContactSpace::compute_with(&case.moving, &case.fixed, &options, &watch)?;
        Some(inverse.free_regions().len())
    } else {
        None
    };
    let features = space.features();
    let doubtful = space.doubtful_orientations().iter();
    let bands = space.bands();
    Ok(Measured {
        features: (features.fixed, features.moving),
        regions: space.free_regions().len(),
        conflicts: space.statistics().conflicts,
        runs: watch.runs.into_inner(),
        patches: space.patches().len(),
        doubtful: doubtful.map(|(lo, hi)| hi - lo).sum(),
        narrow: bands.iter().filter(|b| b.hi - b.lo < NARROW).count(),
        seconds,
        inverse,
        flood: effort.flood.map(|depth| flood(case, &space, depth)),
    })
}

fn flood(case: &Case, space: &ContactSpace, depth: u32) -> Flood {
    let Window { lo, hi, full_turn } = space.window();
    let fill = Fill::new(case, (lo, hi), full_turn, depth);
    let regions = space.free_regions().len();
    let compared = fill.compare(regions, |c| Some(space.locate(c).region()?.0));
    if !compared.wrong.is_empty() {
        return Flood::Wrong(compared.wrong);
    }
    let Compared { least, .. } = compared;
    match compared.is_settled() {
        true if regions == least => Flood::Agrees(least),
        true => Flood::Fewer(least),
        false => Flood::CannotTell(least),
    }
}

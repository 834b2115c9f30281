//! Options of a computation, its errors, and the trait by which it reports progress.

use core::f64::consts::TAU;

use super::symmetry::Symmetry;

/// Excess over a turn that a window may have by rounding, radians.
pub(crate) const WINDOW_SLACK: f64 = 1e-12;

/// The longest window of orientations: a turn, plus rounding.
pub const LONGEST_WINDOW: f64 = TAU + WINDOW_SLACK;

/// The orientations a contact space covers.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Window {
    /// First orientation, radians.
    pub lo: f64,
    /// Last orientation, radians.
    pub hi: f64,
    /// Whether these are all orientations: the last is then the first again.
    pub full_turn: bool,
}

/// Options of a computation: the window of orientations, and the use of symmetry.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// Only orientations from the first to the second, in radians; `None` is the full turn.
    pub window: Option<(f64, f64)>,
    /// Whether symmetric parts are computed for one period of orientations only; the other periods are then copies.
    pub symmetry: Symmetry,
}

/// Reasons for which a contact space cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ComputeError {
    /// The window is reversed, empty, longer than a turn, or not finite.
    #[error("the window of orientations from {lo} to {hi} is not an interval of at most one turn")]
    Window {
        /// First orientation given.
        lo: f64,
        /// Last orientation given.
        hi: f64,
    },
    /// A part has too many edges.
    #[error("part {part} has {edges} edges, too many for a contact space (at most {limit})")]
    TooManyEdges {
        /// The part's name.
        part: String,
        /// Its edges.
        edges: usize,
        /// Largest number of edges.
        limit: usize,
    },
    /// There are more pairs of edges than can be numbered.
    #[error("{fixed} × {moving} edges are too many for one contact space (at most {limit} pairs)")]
    TooLarge {
        /// Edges of the fixed part.
        fixed: usize,
        /// Edges of the moving part.
        moving: usize,
        /// Largest number of pairs.
        limit: usize,
    },
    /// More pairs of features can touch than the limit.
    #[error(
        "{fixed} × {moving} edges are too many for one contact space: more than {limit} contacts of two features"
    )]
    TooManyContacts {
        /// Edges of the fixed part.
        fixed: usize,
        /// Edges of the moving part.
        moving: usize,
        /// Largest number of contacts, each over orientations in which its ends stay the same.
        limit: usize,
    },
    /// More pairs of contacts may cross than the limit.
    #[error(
        "{fixed} × {moving} edges are too many for one contact space: more than {limit} pairs of contacts may be in each other's way"
    )]
    TooManyCrossings {
        /// Edges of the fixed part.
        fixed: usize,
        /// Edges of the moving part.
        moving: usize,
        /// Largest number of pairs of contacts that may cross.
        limit: usize,
    },
    /// The contact space has more patches than the limit.
    #[error(
        "{fixed} × {moving} edges are too many for one contact space: more than {limit} patches"
    )]
    TooManyPatches {
        /// Edges of the fixed part.
        fixed: usize,
        /// Edges of the moving part.
        moving: usize,
        /// Largest number of patches.
        limit: usize,
    },
    /// The computation was interrupted.
    #[error("the computation was interrupted")]
    Interrupted,
}

/// Stages of a computation, for progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Stage {
    /// Features and sheets.
    Sheets,
    /// Which sheets may cross.
    Candidates,
    /// Events of pairs.
    PairEvents,
    /// Crossings.
    Branches,
    /// Events of three sheets.
    TripleEvents,
    /// Cells.
    Cells,
    /// Free or blocked.
    Shells,
    /// Patches and links.
    Graph,
}

impl Stage {
    /// Number of stages.
    pub const COUNT: u64 = 8;
}

/// Receiver of a computation's progress, which may stop it.
pub trait Progress: Sync {
    /// Called when a stage begins; an error ends the computation. All stages begin again if the pair is computed again: because
    /// of a conflict, or because a circle that was divided for symmetry is touched.
    ///
    /// # Errors
    /// [`ComputeError::Interrupted`] if the computation is to be stopped.
    fn stage(&self, stage: Stage) -> Result<(), ComputeError>;

    /// Called in work of many alike pieces, such as samples by chance: so many of so many are done. Where all are, other work follows.
    fn pieces(&self, _done: u64, _of: u64) {}

    /// Reading of a clock in seconds, since any moment: the [`StageSeconds`](super::StageSeconds) of the space are differences of readings.
    /// The library has no clock of its own, since not all machines have one; without this method all stages take 0 s.
    fn seconds(&self) -> f64 {
        0.0
    }
}

/// Progress receiver that shows nothing and never stops a computation.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Silent};
/// let square = |name: &str| Part::rectangle(name, (0.0, 0.0), 2.0, 2.0);
/// let space = ContactSpace::compute_with(&square("a")?, &square("b")?, &Options::default(), &Silent)?;
/// assert_eq!(space.free_regions().len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Silent;

impl<P: Progress + ?Sized> Progress for &P {
    fn stage(&self, stage: Stage) -> Result<(), ComputeError> {
        (**self).stage(stage)
    }

    fn pieces(&self, done: u64, of: u64) {
        (**self).pieces(done, of);
    }

    fn seconds(&self) -> f64 {
        (**self).seconds()
    }
}

impl Progress for Silent {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        Ok(())
    }
}

//! Certainty of the structure of contact spaces.
//!
//! A [`Specimen`] is a pair of outlines that belongs to a family: drawn on a grid, so that lengths of both parts are
//! equal, or changed a little by noise or by rounding. [`specimens`] returns all of them. [`measure`](measure())
//! computes the space of one and measures its doubtful orientations, and [`Totals`] sums up.

mod families;
pub mod files;
mod measure;
mod table;
mod totals;

use cspace::{Part, PartError};
use cspace_oracle::Case;
use cspace_oracle::families::loops_of;

pub use families::Change;
pub use measure::{Effort, Flood, Measured, Outcome, measure};
pub use totals::Totals;

use crate::outline::Loops;

/// The family of pairs whose number of free regions is known, most of them.
pub const TABLE: &str = "table";

/// A pair of outlines to measure.
#[derive(Debug, Clone)]
pub struct Specimen {
    /// Family of the specimen.
    pub family: &'static str,
    /// Change relative to the drawing on a grid.
    pub change: Change,
    /// Name within the family.
    pub name: String,
    /// The fixed part's outline; it may be no part.
    pub fixed: Loops,
    /// The moving part's outline.
    pub moving: Loops,
    /// The orientations to compute, radians; `None` is the full turn.
    pub window: Option<(f64, f64)>,
    /// Number of free regions, if known.
    pub expected: Option<usize>,
}

impl Specimen {
    fn new(family: &'static str, name: impl Into<String>, fixed: &Part, moving: &Part) -> Self {
        Self {
            family,
            change: Change::None,
            name: name.into(),
            fixed: loops_of(fixed),
            moving: loops_of(moving),
            window: None,
            expected: None,
        }
    }

    fn expecting(self, regions: usize) -> Self {
        Self {
            expected: Some(regions),
            ..self
        }
    }

    /// Title: name and change, different for all specimens.
    pub fn title(&self) -> String {
        match self.change {
            Change::None => self.name.clone(),
            change => format!("{}, {change}", self.name),
        }
    }

    /// Pair of the outlines.
    ///
    /// # Errors
    /// If one of the outlines is no part, possibly due to the change.
    pub fn case(&self) -> Result<Case, PartError> {
        let mut case = Case::new(self.fixed.clone(), self.moving.clone())?;
        case.window = self.window;
        Ok(case)
    }
}

/// Specimens of all families; each with `times` different samples of noise.
pub fn specimens(seed: u64, times: u32) -> Vec<Specimen> {
    let mut all = table::table();
    table::add_sofas(&mut all, seed, times);
    families::add(&mut all, seed, times);
    all
}

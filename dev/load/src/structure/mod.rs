//! How certain the structure of contact spaces is.
//!
//! A [`Specimen`] is a pair of outlines that belongs to a family: drawn on a grid, so that lengths of both parts are equal, or
//! changed a little by noise or by rounding. [`specimens`] are all of them. [`measure`](measure()) computes the space of one
//! and says what is doubtful of it, [`Totals`] sums that up.

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
    /// How it differs from what is drawn on a grid.
    pub change: Change,
    /// Which one of the family it is.
    pub name: String,
    /// The fixed part's outline; it may be no part.
    pub fixed: Loops,
    /// The moving part's outline.
    pub moving: Loops,
    /// The orientations to compute, radians; `None` is the full turn.
    pub window: Option<(f64, f64)>,
    /// How many free regions there are, if that is known.
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

    /// Its name and how it was changed: different for all specimens.
    pub fn title(&self) -> String {
        match self.change {
            Change::None => self.name.clone(),
            change => format!("{}, {change}", self.name),
        }
    }

    /// The pair.
    ///
    /// # Errors
    /// If one of the outlines is no part, or no longer.
    pub fn case(&self) -> Result<Case, PartError> {
        let mut case = Case::new(self.fixed.clone(), self.moving.clone())?;
        case.window = self.window;
        Ok(case)
    }
}

/// All specimens but those of files: those with noise so many times with different noise.
pub fn specimens(seed: u64, times: u32) -> Vec<Specimen> {
    let mut all = table::table();
    table::add_sofas(&mut all, seed, times);
    families::add(&mut all, seed, times);
    all
}

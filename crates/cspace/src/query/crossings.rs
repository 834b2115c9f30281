//! All contacts that a motion of constant rates crosses.

use crate::geometry::{Configuration, Vector};
use crate::ids::PatchId;
use crate::space::ContactSpace;

use super::path::{Approach, MotionError, Path};
use super::touch::Search;

impl ContactSpace {
    /// All contacts that a motion of constant rates crosses at times from 0 to `duration`, also where the parts overlap: time, patch, and
    /// whether the motion enters blocked space there; in order of time.
    ///
    /// Roots are found as by [`first_contact`](Self::first_contact). Where the motion passes from one patch to the next, both may be
    /// reported.
    ///
    /// # Errors
    /// If numbers are not finite, the motion begins outside the window, or it turns farther than [`LARGEST_ANGLE`](crate::LARGEST_ANGLE)
    /// while contact is possible.
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Options, Part};
    /// let space = ContactSpace::compute(&Part::circle("table", [0.0, 0.0], 2.0)?, &Part::circle("coin", [0.0, 0.0], 1.0)?, &Options::default())?;
    /// // Straight through: in at −3, out at 3.
    /// let found = space.crossings(Configuration::new(-5.0, 0.0, 0.0), [1.0, 0.0, 0.3], 10.0)?;
    /// let times: Vec<f64> = found.iter().map(|c| c.0).collect();
    /// assert!((times[0] - 2.0).abs() < 1e-9 && (times[times.len() - 1] - 8.0).abs() < 1e-9);
    /// assert!(found[0].2 && !found[found.len() - 1].2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn crossings(
        &self,
        from: Configuration,
        rates: [f64; 3],
        duration: f64,
    ) -> Result<Vec<(f64, PatchId, bool)>, MotionError> {
        self.crossings_about(from, rates, Vector::ZERO, duration)
    }

    /// As [`crossings`](Self::crossings), for the motion of [`first_contact_about`](Self::first_contact_about): the point `about` of the
    /// moving part, in its frame, moves on a straight line while the part turns.
    ///
    /// # Errors
    /// As [`crossings`](Self::crossings).
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Options, Part, Vector};
    /// let table = Part::circle("table", [0.0, 0.0], 2.0)?;
    /// // A coin drawn beside its origin. About its own centre it stays where it is; about its origin it swings onto the table.
    /// let coin = Part::circle("coin", [7.0, 0.0], 1.0)?;
    /// let space = ContactSpace::compute(&table, &coin, &Options::default())?;
    /// let from = Configuration::new(-7.0, 0.0, -1.0);
    /// assert!(space.crossings_about(from, [0.0, 0.0, 3.0], Vector::new(7.0, 0.0), 1.0)?.is_empty());
    /// assert!(!space.crossings(from, [0.0, 0.0, 3.0], 1.0)?.is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn crossings_about(
        &self,
        from: Configuration,
        rates: [f64; 3],
        about: Vector,
        duration: f64,
    ) -> Result<Vec<(f64, PatchId, bool)>, MotionError> {
        let path = Path::new(self, from, rates, about, duration)?;
        if !self.covers(from) {
            return Err(MotionError::StartsOutside);
        }
        let leaves = path.time_in_window(self.window());
        let end = leaves.map_or(duration, |t| t.min(duration));
        match path.approach() {
            Approach::Near => {}
            Approach::At(time) if time < end => {
                let from = path.outer_at(time);
                let found = self.crossings_about(from, rates, about, duration - time)?;
                let later = |(t, patch, enters)| (t + time, patch, enters);
                return Ok(found.into_iter().map(later).collect());
            }
            Approach::At(_) | Approach::Never => return Ok(Vec::new()),
        }
        if path.turns_too_far(end) {
            return Err(MotionError::TurnsTooFar);
        }
        Ok(Search::new(self, path, false).all(end))
    }
}

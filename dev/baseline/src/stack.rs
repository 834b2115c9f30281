//! Slices of a pair, one above the other.

use cspace::{Part, Slice, Slicer};
use rayon::prelude::*;

/// Slices at increasing orientations over a turn; the last is followed by the first.
#[derive(Debug, Clone)]
pub struct Stack {
    /// The slices.
    pub slices: Vec<Slice>,
}

impl Stack {
    /// Computes the slices at increasing orientations in radians, less than a turn from first to last, with the product's own
    /// kernel on all threads.
    ///
    /// ```
    /// use cspace::{Part, Vertex};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let orientations = cspace_baseline::evenly(0.1)?;
    /// let stack = cspace_baseline::Stack::new(&square("fixed", 2.0)?, &square("moving", 1.0)?, &orientations);
    /// assert_eq!(stack.slices.len(), 63);
    /// assert!(stack.slices.iter().all(|s| s.loops.len() == 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(fixed: &Part, moving: &Part, orientations: &[f64]) -> Self {
        let slicer = Slicer::new(fixed, moving);
        let slices = orientations
            .par_iter()
            .map(|&theta| slicer.slice(theta))
            .collect();
        Self { slices }
    }
}

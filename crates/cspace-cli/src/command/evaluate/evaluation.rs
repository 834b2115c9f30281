//! All that is measured.

use serde::Serialize;

use super::averages::Averages;
use super::measure::Measured;
use super::special::Survey;

/// Everything that was measured.
#[derive(Serialize)]
pub(super) struct Evaluation {
    /// Between slices of the general algorithm, radians.
    pub(super) separation: f64,
    /// Number of runs of which the times are medians.
    pub(super) repeat: u16,
    /// Under which the search of critical orientations had to end, seconds.
    pub(super) criticality_limit: f64,
    pub(super) threads: usize,
    pub(super) pairs: Vec<Measured>,
    pub(super) averages: Averages,
    pub(super) survey: Survey,
}

//! All that is measured.

use serde::Serialize;

use crate::averages::Averages;
use crate::measure::Measured;
use crate::special::Survey;

/// Everything that was measured.
#[derive(Serialize)]
pub(crate) struct Evaluation {
    /// Between slices of the general algorithm, radians.
    pub(crate) separation: f64,
    /// Number of runs of which the times are medians.
    pub(crate) repeat: u16,
    /// Under which the search of critical orientations had to end, seconds.
    pub(crate) criticality_limit: f64,
    pub(crate) threads: usize,
    pub(crate) pairs: Vec<Measured>,
    pub(crate) averages: Averages,
    pub(crate) survey: Survey,
}

//! The rows of a sweep, computed.

use std::time::{Duration, Instant};

use cspace_design::{Row, Sweep};

use crate::interrupt::is_interrupted;
use crate::progress::Steps;

/// The rows in order, until an interrupt.
pub(super) fn all(sweep: &Sweep<'_>, rows: &[Vec<f64>]) -> Vec<Row> {
    /// Rows are done together that take about so long: an interrupt waits for them.
    const TOGETHER: Duration = Duration::from_millis(50);
    let steps = Steps::new(rows.len());
    let mut done = Vec::with_capacity(rows.len());
    let mut together = rayon::current_num_threads();
    while done.len() < rows.len() && !is_interrupted() {
        let next = &rows[done.len()..rows.len().min(done.len() + together)];
        let begin = Instant::now();
        done.extend(steps.steps(next.len() as u64, || sweep.rows(next)));
        if begin.elapsed() < TOGETHER {
            together *= 2;
        } else if begin.elapsed() > 2 * TOGETHER {
            together = (together / 2).max(1);
        }
    }
    done
}

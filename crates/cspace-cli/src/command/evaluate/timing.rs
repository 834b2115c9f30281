//! Seconds that work takes.

use std::time::Instant;

/// The seconds that something takes, and what it makes.
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let begin = Instant::now();
    let made = work();
    (begin.elapsed().as_secs_f64(), made)
}

/// The middle one, or the mean of the two in the middle; 0 of none.
pub(super) fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    let n = seconds.len();
    match n {
        0 => 0.0,
        _ => 0.5 * (seconds[(n - 1) / 2] + seconds[n / 2]),
    }
}

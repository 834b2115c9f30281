//! Seconds that work takes.

use cpu_time::ProcessTime;

/// Seconds that the processor works on something, on all threads together, and the result.
///
/// Other programs on the machine take no part in them, as they do in the time of a clock.
pub(crate) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let begin = ProcessTime::now();
    let made = work();
    (begin.elapsed().as_secs_f64(), made)
}

/// The middle one, or the mean of the two in the middle; 0 of none.
pub(crate) fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    let n = seconds.len();
    match n {
        0 => 0.0,
        _ => 0.5 * (seconds[(n - 1) / 2] + seconds[n / 2]),
    }
}

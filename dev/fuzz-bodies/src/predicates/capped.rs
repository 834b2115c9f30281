//! Events that are reported with the largest allowed error, and would need a larger one.

/// Largest error with which an event is reported, radians.
const LARGEST_ERROR: f64 = 1e-6;

/// The error of a coefficient of an event, in units of the lengths it is made of: 8 roundings of four times their sum.
const COEFFICIENT_ERROR: f64 = 32.0 * f64::EPSILON;

/// A function of an amplitude below this, in units of the lengths it is made of, hardly turns.
const HARDLY: f64 = 1e-2;

/// Whether a root of a function that hardly varies, beside a tangency, may be missing: by its amplitude, its slope
/// there, and the lengths of which it is made.
///
/// An error e of the coefficients moves a root by e over the slope, and by √(2 e / amplitude) at most.
pub(super) fn is_capped(amplitude: f64, slope: f64, lengths: f64) -> bool {
    let e = COEFFICIENT_ERROR * lengths;
    let error = (e / slope).min((2.0 * e / amplitude).sqrt());
    amplitude < HARDLY * lengths && error > 0.5 * LARGEST_ERROR
}

#[test]
fn an_event_needs_a_large_error_only_where_little_turns() {
    assert!(!is_capped(1.0, 0.0, 1.0));
    assert!(is_capped(1e-12, 1e-13, 1.0));
}

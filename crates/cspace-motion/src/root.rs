//! Roots of functions of one variable.

/// A root is found to this share of where it is looked for, or to rounding.
const ROOT: f64 = 1e-15;
/// Largest number of function values.
const TRIES: usize = 100;

/// A root between two places: the first has a positive value, the second one below 0. Found by the method of Illinois with
/// halving, from the side where the function is not positive.
pub(crate) fn root(
    (mut lo, mut f_lo): (f64, f64),
    (mut hi, mut f_hi): (f64, f64),
    f: impl Fn(f64) -> Option<f64>,
) -> Option<f64> {
    let width = hi - lo;
    for i in 0..TRIES {
        if hi - lo <= ROOT * width {
            break;
        }
        let secant = (lo * f_hi - hi * f_lo) / (f_hi - f_lo);
        let at = if i % 3 == 2 || !(secant > lo && secant < hi) {
            0.5 * (lo + hi)
        } else {
            secant
        };
        if at <= lo || at >= hi {
            break;
        }
        let value = f(at)?;
        if value > 0.0 {
            (lo, f_lo) = (at, value);
            f_hi *= 0.5;
        } else {
            (hi, f_hi) = (at, value);
            f_lo *= 0.5;
        }
        if value == 0.0 {
            return Some(at);
        }
    }
    Some(hi)
}

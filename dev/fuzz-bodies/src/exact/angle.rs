//! Cosine and sine of a double to many digits.

use num_bigint::BigInt;

use super::Dyadic;

/// Bits behind the point.
const BITS: i64 = 280;

/// The angle is halved so often before the series is summed.
const HALVINGS: i64 = 16;

/// Terms of the series: (16 · 2⁻¹⁶)^(2 · 16) / 32! is below 2⁻⁴⁰⁰.
const TERMS: u32 = 16;

/// Exponent of the error of cosines and sines, to base 2.
///
/// Each of the 16 terms is rounded to 2⁻²⁸⁰, and each doubling multiplies the error by 4 at most and adds some roundings:
/// 2⁻²⁸⁰ · 2⁶ · 4¹⁶ < 2⁻²⁴⁰.
pub const ANGLE_ERROR: i64 = -240;

/// Cosine and sine of an angle of magnitude up to 16 radians, to 2 to the power of [`ANGLE_ERROR`].
///
/// ```
/// use cspace_fuzz::exact::{Dyadic, cos_sin};
/// let (cos, sin) = cos_sin(0.7);
/// let one = &cos.square() + &sin.square();
/// assert!((&one - &Dyadic::of(1.0)).abs() < Dyadic::of(1.0).shifted(-230));
/// assert!((cos.near() - 0.7f64.cos()).abs() < 1e-15);
/// ```
pub fn cos_sin(angle: f64) -> (Dyadic, Dyadic) {
    let x = Dyadic::of(angle).scaled(BITS - HALVINGS);
    let square: BigInt = (&x * &x) >> BITS;
    let one = BigInt::from(1) << BITS;
    // The versine 1 − cos keeps its digits when it is doubled; the sine likewise.
    let (mut versine, mut sin) = (BigInt::ZERO, BigInt::ZERO);
    let (mut even, mut odd) = (one.clone(), x);
    for k in 0..TERMS {
        sin += &odd;
        even = -((even * &square) >> BITS) / ((2 * k + 1) * (2 * k + 2));
        odd = -((odd * &square) >> BITS) / ((2 * k + 2) * (2 * k + 3));
        versine -= &even;
    }
    for _ in 0..HALVINGS {
        // 1 − cos 2x = 2 sin² x and sin 2x = 2 sin x cos x.
        let cos = &one - &versine;
        versine = (&sin * &sin) >> (BITS - 1);
        sin = (sin * cos) >> (BITS - 1);
    }
    let at = |m: BigInt| Dyadic::new(m, -BITS);
    (at(one - versine), at(sin))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_doubles_and_with_itself() {
        for k in -40..=40 {
            let x = 0.37 * f64::from(k);
            let (cos, sin) = cos_sin(x);
            assert!((cos.near() - x.cos()).abs() < 4e-16, "{x}");
            assert!((sin.near() - x.sin()).abs() < 4e-16, "{x}");
            // sin 2x and cos 2x from the same series at another angle; 2x is exact.
            let (twice_cos, twice_sin) = cos_sin(0.5 * x);
            let error = Dyadic::of(1.0).shifted(ANGLE_ERROR + 4);
            let product = (&twice_cos * &twice_sin).shifted(1);
            assert!((&product - &sin).abs() < error, "{x}");
            let square = &twice_cos.square() - &twice_sin.square();
            assert!((&square - &cos).abs() < error, "{x}");
        }
    }
}

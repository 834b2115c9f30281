//! Roots of α cos θ + β sin θ + γ.

use core::f64::consts::{PI, TAU};

use cspace::fuzzing::{Root, trig_roots};

use crate::Finding;
use crate::draw::Bytes;
use crate::exact::{Dyadic, cos_sin};

/// Number of bits by which roots are looked up.
const BITS: i64 = 640;

/// Largest variation, as a share of its scale, of a function that counts as constant: twice the library's value.
const CONSTANT: f64 = 128.0 * f64::EPSILON;

/// Distance from an end of the interval (radians) within which a root may be reported or not.
const AT_THE_END: f64 = 1e-9;

/// Largest value of the function at a reported root, in units of the scale: coefficients have some roundings.
const SPURIOUS: f64 = 64.0 * f64::EPSILON;

/// α cos θ + β sin θ + γ, exactly.
#[derive(Debug, Clone)]
pub(super) struct Exact {
    pub(super) alpha: Dyadic,
    pub(super) beta: Dyadic,
    pub(super) gamma: Dyadic,
}

/// The direction of a root, times a positive number.
#[derive(Debug, Clone)]
pub(super) struct Direction {
    cos: Dyadic,
    sin: Dyadic,
    /// The angle as a double, to some roundings.
    pub(super) near: f64,
}

impl Exact {
    /// α² + β².
    pub(super) fn square(&self) -> Dyadic {
        &self.alpha.square() + &self.beta.square()
    }

    /// Discriminant α² + β² − γ²: positive where there are two roots, negative where there is none.
    pub(super) fn discriminant(&self) -> Dyadic {
        &self.square() - &self.gamma.square()
    }

    /// Roots as (c, s): all directions with α c + β s + γ = 0, (−α γ ∓ β √D, −β γ ± α √D) / (α² + β²).
    pub(super) fn roots(&self) -> Vec<Direction> {
        let (square, discriminant) = (self.square(), self.discriminant());
        if square.sign() == 0 || discriminant.sign() < 0 {
            return Vec::new();
        }
        let root = discriminant.root(BITS);
        let at = |root: &Dyadic| {
            let cos = -&(&(&self.alpha * &self.gamma) + &(&self.beta * root));
            let sin = &(&self.alpha * root) - &(&self.beta * &self.gamma);
            let near = sin.near().atan2(cos.near());
            Direction { cos, sin, near }
        };
        if root.sign() == 0 {
            return vec![at(&root)];
        }
        vec![at(&root), at(&-&root)]
    }

    /// The value at an angle, and the sign if it is certain.
    pub(super) fn at(&self, angle: f64) -> Dyadic {
        let (cos, sin) = cos_sin(angle);
        &(&(&self.alpha * &cos) + &(&self.beta * &sin)) + &self.gamma
    }
}

impl Direction {
    /// Whether a root reported with this error is certainly not this one.
    ///
    /// An angle up to e has a sine up to e: the sine of the angle between the two is compared, times the length of this
    /// direction, squared so that no root is needed.
    fn is_missed_by(&self, &(theta, error): &Root) -> bool {
        let (cos, sin) = cos_sin(theta);
        let dot = &(&cos * &self.cos) + &(&sin * &self.sin);
        if dot.sign() < 0 {
            return true;
        }
        let cross = &(&cos * &self.sin) - &(&sin * &self.cos);
        let length = &self.cos.square() + &self.sin.square();
        cross.square() > &Dyadic::of(error).square() * &length
    }

    /// Whether the root is clearly within (mid − half, mid + half), modulo whole turns.
    fn is_within(&self, mid: f64, half: f64) -> bool {
        let off = self.near - mid;
        (off - TAU * (off / TAU).round()).abs() <= half - AT_THE_END
    }

    /// Whether one of the reported roots is this one.
    pub(super) fn is_told(&self, told: &[Root]) -> bool {
        told.iter().any(|r| !self.is_missed_by(r))
    }

    /// Reports a finding if this root is missing among those found.
    pub(super) fn expect(
        &self,
        told: &[Root],
        mid: f64,
        half: f64,
        of: impl FnOnce() -> String,
    ) -> Result<(), Finding> {
        if !self.is_within(mid, half) || self.is_told(told) {
            return Ok(());
        }
        Err(Finding::new(format!(
            "the root {:?} of {} is not among those from {mid:?} − {half:?} to {mid:?} + {half:?}: {told:?}",
            self.near,
            of()
        )))
    }
}

/// Coefficients of a function whose roots nearly coincide or vanish, or random ones.
pub(super) fn coefficients(bytes: &mut Bytes<'_>) -> [f64; 3] {
    let (alpha, beta) = (bytes.unit(), bytes.unit());
    let (alpha, beta) = match bytes.below(4) {
        0 => (alpha * 1e-6, beta * 1e-6),
        1 => (bytes.nudged(0.0), beta),
        _ => (alpha, beta),
    };
    let gamma = match bytes.below(4) {
        0 => alpha.hypot(beta),
        1 => -alpha.hypot(beta),
        2 => alpha * bytes.unit(),
        _ => bytes.unit(),
    };
    [alpha, beta, bytes.nudged(gamma)]
}

/// An interval of orientations: its middle and half its length.
pub(super) fn interval(bytes: &mut Bytes<'_>) -> (f64, f64) {
    let half = bytes.one_of(&[PI, PI, 1.0, 0.1, 1e-3, 1e-6]);
    (bytes.orientation(), half)
}

pub(super) fn run(bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    let [alpha, beta, gamma] = coefficients(bytes);
    let (mid, half) = interval(bytes);
    let size = alpha.abs() + beta.abs() + gamma.abs();
    let scale = size * bytes.one_of(&[1.0, 1.0, 16.0, 1024.0]);
    let told = trig_roots([alpha, beta, gamma], scale, mid, half);
    let exact = Exact {
        alpha: Dyadic::of(alpha),
        beta: Dyadic::of(beta),
        gamma: Dyadic::of(gamma),
    };
    let of = || format!("{alpha:?} cos θ + {beta:?} sin θ + {gamma:?}, scale {scale:?},");
    if exact.square() > Dyadic::of(CONSTANT * scale).square() {
        for root in exact.roots() {
            root.expect(&told, mid, half, of)?;
        }
    }
    for &(theta, error) in &told {
        let most = alpha.hypot(beta) * error * (1.0 + 1e-9) + SPURIOUS * scale;
        if exact.at(theta).abs() > Dyadic::of(most) {
            return Err(Finding::new(format!(
                "the root {theta:?} ± {error:?} of {} is none: the value there is {:e}",
                of(),
                exact.at(theta).near()
            )));
        }
    }
    Ok(1 + told.len() as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos θ = 1/2 at ±60°.
    #[test]
    fn a_root_that_is_off_or_left_out_is_seen() {
        let exact = Exact {
            alpha: Dyadic::of(1.0),
            beta: Dyadic::zero(),
            gamma: Dyadic::of(-0.5),
        };
        let roots = exact.roots();
        assert_eq!(roots.len(), 2);
        let third = PI / 3.0;
        let right = [(third, 1e-15), (-third, 1e-15)];
        assert!(roots.iter().all(|r| r.is_told(&right)));
        assert!(roots.iter().any(|r| !r.is_told(&right[..1])));
        let off = [(third + 1e-13, 1e-14), (-third, 1e-15)];
        let missed = |r: &Direction| r.expect(&off, 0.0, PI, String::new).is_err();
        assert_eq!(roots.iter().filter(|r| missed(r)).count(), 1);
        // A root outside of the interval need not be reported.
        assert!(
            roots
                .iter()
                .all(|r| r.expect(&[], 3.0, 0.5, String::new).is_ok())
        );
    }
}

//! Numbers known to lie between two floating-point numbers; every operation rounds outwards.

use core::ops::{Add, Mul, Neg, Sub};

/// A real number between `lo` and `hi`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct I {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
}

const fn between(lo: f64, hi: f64) -> I {
    I { lo, hi }
}

/// π lies between this number and the next.
pub(crate) const PI: I = between(core::f64::consts::PI, core::f64::consts::PI.next_up());

pub(crate) fn exact(x: f64) -> I {
    between(x, x)
}

fn outwards(lo: f64, hi: f64) -> I {
    between(lo.next_down(), hi.next_up())
}

impl I {
    pub(crate) fn square(self) -> Self {
        let square = self.abs() * self.abs();
        between(square.lo.max(0.0), square.hi)
    }

    pub(crate) fn sqrt(self) -> Self {
        // Square roots are rounded correctly (IEEE 754).
        outwards(self.lo.max(0.0).sqrt(), self.hi.max(0.0).sqrt())
    }

    pub(crate) fn abs(self) -> Self {
        between(self.lo.max(-self.hi).max(0.0), self.hi.max(-self.lo))
    }

    /// Reciprocal of a number that is certainly not 0; unbounded otherwise.
    pub(crate) fn recip(self) -> Self {
        if self.sign().is_some() {
            outwards(1.0 / self.hi, 1.0 / self.lo)
        } else {
            between(f64::NEG_INFINITY, f64::INFINITY)
        }
    }

    /// Whether it is certainly positive or certainly negative.
    pub(crate) fn sign(self) -> Option<bool> {
        (self.lo > 0.0 || self.hi < 0.0).then_some(self.lo > 0.0)
    }

    /// Sine and cosine of a number: Taylor's series at a small part of it, then doubled.
    pub(crate) fn sin_cos(x: f64) -> (Self, Self) {
        let mut halvings = 0;
        let mut small = x;
        while small.abs() > 0.125 {
            small *= 0.5;
            halvings += 1;
        }
        let (mut term, mut sums) = (exact(1.0), [exact(0.0); 2]);
        for k in 0..14 {
            let signed = if k % 4 < 2 { term } else { -term };
            sums[k % 2] = sums[k % 2] + signed;
            term = term * exact(small) * exact(k as f64 + 1.0).recip();
        }
        // The omitted rest of an alternating series is less than its next term, which is less than the last one.
        let rest = term.abs().hi;
        let [mut cos, mut sin] = sums.map(|s| s + between(-rest, rest));
        for _ in 0..halvings {
            let two = exact(2.0);
            (sin, cos) = (two * sin * cos, exact(1.0) - two * sin.square());
        }
        (sin, cos)
    }
}

impl Add for I {
    type Output = I;
    fn add(self, o: I) -> I {
        outwards(self.lo + o.lo, self.hi + o.hi)
    }
}

impl Neg for I {
    type Output = I;
    fn neg(self) -> I {
        between(-self.hi, -self.lo)
    }
}

impl Sub for I {
    type Output = I;
    fn sub(self, o: I) -> I {
        self + -o
    }
}

impl Mul for I {
    type Output = I;
    fn mul(self, o: I) -> I {
        let p = [
            self.lo * o.lo,
            self.lo * o.hi,
            self.hi * o.lo,
            self.hi * o.hi,
        ];
        // Infinity times 0 says nothing.
        if p.iter().any(|x| x.is_nan()) {
            return between(f64::NEG_INFINITY, f64::INFINITY);
        }
        let least = p.into_iter().fold(f64::INFINITY, f64::min);
        outwards(least, p.into_iter().fold(f64::NEG_INFINITY, f64::max))
    }
}

//! A function over an interval and in its middle, each of which bounds the other.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Ball, Real, SecondOrder};

/// Enclosures of a function of θ and of its first two derivatives, in the middle of an interval and over all of it.
///
/// After each operation Taylor's theorem narrows the enclosure over the interval. So the square of a function that vanishes linearly beside
/// the interval is known to be positive in it, and has a root that can be differentiated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Expansion {
    pub(crate) at: SecondOrder<1, Ball>,
    pub(crate) over: SecondOrder<1, Ball>,
    /// Half the length of the interval; 0 for constants.
    half: f64,
}

/// The largest absolute value.
fn most(b: Ball) -> f64 {
    b.mid.abs() + b.radius
}

/// The narrower of two enclosures.
fn narrower(a: Ball, b: Ball) -> Ball {
    if b.radius < a.radius || a.radius.is_nan() {
        b
    } else {
        a
    }
}

impl Expansion {
    /// The variable θ itself, between two numbers.
    pub(crate) fn variable(lo: f64, hi: f64) -> Self {
        let theta = |ball| SecondOrder::variable(ball, 0);
        Self {
            at: theta(Ball::constant(0.5 * (lo + hi))),
            over: theta(Ball::between(lo, hi)),
            half: 0.5 * (hi - lo),
        }
    }

    fn new(at: SecondOrder<1, Ball>, mut over: SecondOrder<1, Ball>, half: f64) -> Self {
        let about =
            |at: Ball, by: f64| Ball::between(at.mid - at.radius - by, at.mid + at.radius + by);
        let bend = most(over.hessian[0][0]) * half;
        over.gradient[0] = narrower(over.gradient[0], about(at.gradient[0], bend));
        let rise =
            (most(at.gradient[0]) * half + 0.5 * bend * half).min(most(over.gradient[0]) * half);
        over.value = narrower(over.value, about(at.value, rise));
        Self { at, over, half }
    }

    /// A lower bound of the function in the interior of the interval; infinite if the function is monotonous.
    pub(crate) fn least(&self) -> f64 {
        if self.over.gradient[0].sign() != 0 {
            return f64::INFINITY;
        }
        let low = |b: Ball| b.mid - b.radius;
        // Where it is convex it decreases no further than a parabola does.
        let (slope, bend) = (most(self.at.gradient[0]), low(self.over.hessian[0][0]));
        let fall = if bend > 0.0 {
            0.5 * slope * slope / bend
        } else {
            f64::INFINITY
        };
        low(self.over.value).max(low(self.at.value) - fall)
    }
}

impl Add for Expansion {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.at + o.at, self.over + o.over, self.half.max(o.half))
    }
}

impl Sub for Expansion {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.at - o.at, self.over - o.over, self.half.max(o.half))
    }
}

impl Neg for Expansion {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            at: -self.at,
            over: -self.over,
            half: self.half,
        }
    }
}

impl Mul for Expansion {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(self.at * o.at, self.over * o.over, self.half.max(o.half))
    }
}

impl Div for Expansion {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        Self::new(self.at / o.at, self.over / o.over, self.half.max(o.half))
    }
}

impl Real for Expansion {
    const ROUNDING: f64 = f64::EPSILON;

    fn constant(value: f64) -> Self {
        Self {
            at: SecondOrder::constant(value),
            over: SecondOrder::constant(value),
            half: 0.0,
        }
    }

    fn value(self) -> f64 {
        self.at.value()
    }

    fn sqrt(self) -> Self {
        Self::new(self.at.sqrt(), self.over.sqrt(), self.half)
    }

    fn sin_cos(self) -> (Self, Self) {
        let ((s, c), (sin, cos)) = (self.at.sin_cos(), self.over.sin_cos());
        (Self::new(s, sin, self.half), Self::new(c, cos, self.half))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All enclosures hold at places of the interval, also for a root of a function that almost vanishes beside it.
    #[test]
    fn encloses_a_function_and_its_derivatives() {
        fn f<T: Real>(cos: T, sin: T) -> T {
            // 1 − cos vanishes twice at 0.
            let less = T::constant(1.0) - cos;
            (less * less * T::constant(4.0) + sin * sin).sqrt()
                + cos * sin / (T::constant(2.0) - sin)
        }
        for (lo, hi) in [(1e-3, 1.5e-3), (-0.8, -0.6), (0.2, 0.9), (-2e-6, -1.5e-6)] {
            let theta = Expansion::variable(lo, hi);
            let (sin, cos) = theta.sin_cos();
            let (g, mut least) = (f(cos, sin), f64::INFINITY);
            assert!(g.over.value.radius < 2.0 * (hi - lo), "{g:?}");
            for i in 0..=20 {
                let t = lo + (hi - lo) * f64::from(i) / 20.0;
                let (s, c) = SecondOrder::<1>::variable(t, 0).sin_cos();
                let exact = f(c, s);
                for (ball, value) in [
                    (theta.over.value, t),
                    (g.over.value, exact.value),
                    (g.over.gradient[0], exact.gradient[0]),
                    (g.over.hessian[0][0], exact.hessian[0][0]),
                ] {
                    assert!(
                        (ball.mid - value).abs() <= ball.radius + 1e-9 * value.abs(),
                        "{ball:?} {value}"
                    );
                }
                least = least.min(exact.value);
            }
            assert!(g.least() <= least || g.least() == f64::INFINITY);
        }
    }
}

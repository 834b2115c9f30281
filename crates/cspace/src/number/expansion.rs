//! A function over an interval and in its middle, so that each bounds the other.

use core::ops::{Add, Mul, Neg, Sub};

use super::{Ball, Real, Series};

/// Enclosures of a function of θ and of its first two derivatives, in the middle of an interval and over all of it.
///
/// After each operation Taylor's theorem narrows what is known over the interval. So the square of what vanishes linearly
/// beside the interval is known not to vanish in it, and has a root that can be differentiated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Expansion {
    pub(crate) at: Series<Ball>,
    pub(crate) over: Series<Ball>,
    /// Half the length of the interval; 0 of constants.
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
    /// θ − `origin`, and the cosine and sine of θ, for θ between two numbers.
    pub(crate) fn angle(lo: f64, hi: f64, origin: f64) -> (Self, (Self, Self)) {
        let (one, zero) = (Ball::constant(1.0), Ball::constant(0.0));
        let (middle, over) = (Ball::constant(0.5 * (lo + hi)), Ball::between(lo, hi));
        let from = |theta: Ball| Series {
            value: theta - Ball::constant(origin),
            slope: one,
            bend: zero,
        };
        let turn = |theta: Ball| {
            let (cos, sin) = theta.cos_sin();
            Series::turn(cos, sin)
        };
        let half = 0.5 * (hi - lo);
        let ((c, s), (cos, sin)) = (turn(middle), turn(over));
        (
            Self::new(from(middle), from(over), half),
            (Self::new(c, cos, half), Self::new(s, sin, half)),
        )
    }

    fn new(at: Series<Ball>, mut over: Series<Ball>, half: f64) -> Self {
        let about =
            |at: Ball, by: f64| Ball::between(at.mid - at.radius - by, at.mid + at.radius + by);
        let bend = most(over.bend) * half;
        over.slope = narrower(over.slope, about(at.slope, bend));
        let rise = (most(at.slope) * half + 0.5 * bend * half).min(most(over.slope) * half);
        over.value = narrower(over.value, about(at.value, rise));
        Self { at, over, half }
    }

    /// A number below which no value in the interval is; infinite if the function rises or falls throughout.
    pub(crate) fn least(&self) -> f64 {
        if self.over.slope.sign() != 0 {
            return f64::INFINITY;
        }
        let low = |b: Ball| b.mid - b.radius;
        // Where it is convex it falls no further than a parabola does.
        let (slope, bend) = (most(self.at.slope), low(self.over.bend));
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

impl Real for Expansion {
    fn constant(value: f64) -> Self {
        Self {
            at: Series::constant(value),
            over: Series::constant(value),
            half: 0.0,
        }
    }

    fn over(self, divisor: Self) -> Self {
        let half = self.half.max(divisor.half);
        Self::new(
            self.at.over(divisor.at),
            Real::over(self.over, divisor.over),
            half,
        )
    }

    fn root(self) -> Self {
        Self::new(self.at.root(), self.over.root(), self.half)
    }

    fn rough(self) -> f64 {
        self.at.rough()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All that is told is so at places of the interval, also of a root of what all but vanishes beside it.
    #[test]
    fn encloses_a_function_and_its_derivatives() {
        fn f<T: Real>(cos: T, sin: T) -> T {
            // 1 − cos vanishes twice at 0.
            let less = T::constant(1.0) - cos;
            (less * less * T::constant(4.0) + sin * sin).root()
                + (cos * sin).over(T::constant(2.0) - sin)
        }
        for (lo, hi) in [(1e-3, 1.5e-3), (-0.8, -0.6), (0.2, 0.9), (-2e-6, -1.5e-6)] {
            let (theta, (cos, sin)) = Expansion::angle(lo, hi, 0.25);
            let (g, mut least) = (f(cos, sin), f64::INFINITY);
            assert!(g.over.value.radius < 2.0 * (hi - lo), "{g:?}");
            for i in 0..=20 {
                let t = lo + (hi - lo) * f64::from(i) / 20.0;
                let (c, s) = Series::cos_sin(t);
                let exact = f(c, s);
                for (ball, value) in [
                    (theta.over.value, t - 0.25),
                    (g.over.value, exact.value),
                    (g.over.slope, exact.slope),
                    (g.over.bend, exact.bend),
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

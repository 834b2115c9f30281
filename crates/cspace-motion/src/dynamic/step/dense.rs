//! States within a step, without its being taken again.

use nalgebra::DVector;

use super::super::world::State;
use super::take::Taken;

/// Weights of the slopes in the last term of the interpolation (Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I,
/// II.6).
const WEIGHTS: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// The polynomial of degree 4 through a step, of order 4.
#[derive(Debug, Clone)]
pub(super) struct Dense {
    h: f64,
    q: [DVector<f64>; 5],
    v: [DVector<f64>; 5],
}

impl Dense {
    /// Interpolates a step of length `h`.
    pub(super) fn new(from: &State, h: f64, taken: &Taken) -> Self {
        let slopes = &taken.slopes;
        let q = |k: usize| &slopes[k].0;
        let v = |k: usize| &slopes[k].1;
        Self {
            h,
            q: terms(&from.q, &taken.state.q, h, q),
            v: terms(&from.v, &taken.state.v, h, v),
        }
    }

    /// After a time from its beginning, with what joints and contacts miss.
    pub(super) fn at(&self, from: &State, after: f64) -> State {
        let share = after / self.h;
        let value = |[a, b, c, d, e]: &[DVector<f64>; 5]| {
            let mut sum = e * (1.0 - share);
            sum += d;
            sum *= share;
            sum += c;
            sum *= 1.0 - share;
            sum += b;
            sum *= share;
            sum += a;
            sum
        };
        State {
            t: from.t + after,
            q: value(&self.q),
            v: value(&self.v),
        }
    }
}

/// y = a + θ (b + (1 − θ) (c + θ (d + (1 − θ) e))).
fn terms<'s>(
    from: &DVector<f64>,
    to: &DVector<f64>,
    h: f64,
    slope: impl Fn(usize) -> &'s DVector<f64>,
) -> [DVector<f64>; 5] {
    let change = to - from;
    let begins = h * slope(0) - &change;
    let ends = &change - h * slope(6) - &begins;
    let mut last = DVector::zeros(from.len());
    for (k, weight) in WEIGHTS.iter().enumerate() {
        last.axpy(h * weight, slope(k), 1.0);
    }
    [from.clone(), change, begins, ends, last]
}

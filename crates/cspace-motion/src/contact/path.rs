//! Path of the mechanism in one step of the motion.

use core::cell::OnceCell;

/// Configurations along a step: the cubics that have the coordinates and rates of its ends.
#[derive(Debug, Clone)]
pub(crate) struct Path<'a> {
    ends: [&'a [f64]; 2],
    rates: [&'a [f64]; 2],
    /// Duration of the step, s.
    duration: f64,
    middle: OnceCell<Vec<f64>>,
}

impl<'a> Path<'a> {
    /// Creates the path from coordinates and rates at both ends.
    pub(crate) fn new(
        (a, va): (&'a [f64], &'a [f64]),
        (b, vb): (&'a [f64], &'a [f64]),
        duration: f64,
    ) -> Self {
        Self {
            ends: [a, b],
            rates: [va, vb],
            duration,
            middle: OnceCell::new(),
        }
    }

    /// Coordinates at the start.
    pub(crate) fn from(&self) -> &'a [f64] {
        self.ends[0]
    }

    /// Coordinates at the end.
    pub(crate) fn to(&self) -> &'a [f64] {
        self.ends[1]
    }

    /// The rates with which it begins.
    pub(super) fn begins(&self) -> &'a [f64] {
        self.rates[0]
    }

    /// Duration, s.
    pub(super) fn duration(&self) -> f64 {
        self.duration
    }

    /// The coordinates after half of it.
    pub(crate) fn middle(&self) -> &[f64] {
        self.middle.get_or_init(|| self.at(0.5))
    }

    /// The coordinates after a share of it.
    pub(crate) fn at(&self, share: f64) -> Vec<f64> {
        let rest = 1.0 - share;
        let ([a, b], [va, vb]) = (self.ends, self.rates);
        let cubic = |i: usize| {
            rest * rest * (1.0 + 2.0 * share) * a[i]
                + share * share * (1.0 + 2.0 * rest) * b[i]
                + self.duration * rest * share * (rest * va[i] - share * vb[i])
        };
        (0..a.len()).map(cubic).collect()
    }

    /// The rates there, per share.
    pub(crate) fn rates(&self, share: f64) -> Vec<f64> {
        let rest = 1.0 - share;
        let ([a, b], [va, vb]) = (self.ends, self.rates);
        let slope = |i: usize| {
            6.0 * rest * share * (b[i] - a[i])
                + self.duration
                    * (rest * (1.0 - 3.0 * share) * va[i] + share * (3.0 * share - 2.0) * vb[i])
        };
        (0..a.len()).map(slope).collect()
    }
}

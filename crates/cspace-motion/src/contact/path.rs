//! The way that a step of the motion goes.

use crate::system::System;

/// A piece of a path is straight if it is no farther than this from the straight way, relative to the size of the mechanism: what is
/// met by less goes unseen.
const STRAIGHT: f64 = 1e-6;
/// The distance falls with the square of the number of pieces; there are no more than that.
const MOST_PIECES: usize = 8;
/// The first of a step that may begin in contact is short: this share of it.
const FIRST: f64 = 1.0 / 64.0;

/// Configurations along a step: the cubics that have the coordinates and rates of its ends.
#[derive(Debug, Clone)]
pub(crate) struct Path<'a> {
    ends: [&'a [f64]; 2],
    rates: [&'a [f64]; 2],
    /// How long it takes, s.
    duration: f64,
}

impl<'a> Path<'a> {
    /// With the coordinates and rates of both ends.
    pub(crate) fn new(
        (a, va): (&'a [f64], &'a [f64]),
        (b, vb): (&'a [f64], &'a [f64]),
        duration: f64,
    ) -> Self {
        Self {
            ends: [a, b],
            rates: [va, vb],
            duration,
        }
    }

    /// Where it begins.
    pub(crate) fn from(&self) -> &'a [f64] {
        self.ends[0]
    }

    /// Where it ends.
    pub(crate) fn to(&self) -> &'a [f64] {
        self.ends[1]
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

    /// Places along it, with their shares, between which it is nearly straight.
    pub(crate) fn places(&self, system: &System) -> Vec<(f64, Vec<f64>)> {
        /// The largest value of (1 − s)² s, by which a rate at an end that is not that of the straight way moves the path.
        const BULGE: f64 = 4.0 / 27.0;
        let off = |i: usize| {
            let way = self.ends[1][i] - self.ends[0][i];
            let each = self.rates.map(|v| (self.duration * v[i] - way).abs());
            (each[0] + each[1]) * system.lengths()[i]
        };
        let bulge = BULGE * (0..self.from().len()).map(off).fold(0.0, f64::max);
        let pieces = (bulge / (STRAIGHT * system.size())).sqrt().ceil();
        let count = (pieces as usize).clamp(1, MOST_PIECES);
        let inside = (1..count).map(|k| k as f64 / count as f64);
        core::iter::once((0.0, self.from().to_vec()))
            .chain(
                core::iter::once(FIRST)
                    .chain(inside)
                    .map(|share| (share, self.at(share))),
            )
            .chain([(1.0, self.to().to_vec())])
            .collect()
    }
}

//! The way that a step of the motion goes.

/// Straight pieces that stand for the path of a step end at these shares of it. Their distance from the path falls with the square of
/// their number. The first of a step that begins in contact is short.
const PIECES: [f64; 5] = [1.0 / 64.0, 0.25, 0.5, 0.75, 1.0];

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

    /// Places along it, with their shares, between which it is nearly straight.
    pub(crate) fn places(&self) -> Vec<(f64, Vec<f64>)> {
        let inside = PIECES.iter().filter(|&&share| share < 1.0);
        core::iter::once((0.0, self.from().to_vec()))
            .chain(inside.map(|&share| (share, self.at(share))))
            .chain([(1.0, self.to().to_vec())])
            .collect()
    }
}

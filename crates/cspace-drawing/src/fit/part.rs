//! Smooth parts of curves, between the ends that they were joined to.

use cspace::{Point, Vector};

use crate::curve::Curve;
use crate::join::ChainPiece;

/// A part of a span of a curve in the direction of travel. Where the ends of a curve were moved to others, all of it is
/// moved: from what its start was moved by to what its end was, evenly along its parameter.
#[derive(Clone, Copy)]
pub(super) struct Part<'c> {
    curve: &'c Curve,
    pub(super) piece: &'c ChainPiece<'c>,
    span: usize,
    /// The fractions of the span at which it starts and ends; down if it is travelled backward.
    range: [f64; 2],
    /// Start and end: at a sharp turn, the corner that stands for it.
    ends: [Point; 2],
    /// Displacement of the curve at its start and its end.
    moved: [Vector; 2],
    /// The length, and the derivative by the span's parameter, that is rounding: as where a control point is at the end.
    still: f64,
}

impl<'c> Part<'c> {
    /// The parts of a piece, in the direction of travel: its spans, cut where they turn sharply within a length.
    pub(super) fn all(curve: &'c Curve, piece: &'c ChainPiece<'c>, within: f64) -> Vec<Self> {
        /// Rounding of points and of derivatives of a curve, as a share of its size.
        const STILL: f64 = 1e-12;
        const SLOW: f64 = 1e-9;
        let spans = curve.spans();
        let size = curve.bounds().diagonal();
        let own = match piece.is_backward {
            true => [curve.end(), curve.start()],
            false => [curve.start(), curve.end()],
        };
        let moved = [piece.start - own[0], piece.end - own[1]];
        let mut parts = Vec::with_capacity(spans);
        for k in 0..spans {
            let span = if piece.is_backward { spans - 1 - k } else { k };
            // Control points that are the same make spans of no length.
            let is_still = (1..=4).all(|i| {
                let at = |i: u8| curve.at(span, f64::from(i) / 4.0).0;
                at(i).distance(at(0)) <= STILL * size
            });
            if is_still {
                continue;
            }
            let mut turns = curve.sharp_turns(span, within);
            if turns.iter().any(|&[from, to]| from == 0.0 && to == 1.0) {
                turns.clear();
            }
            let mut ranges = between(&turns);
            if piece.is_backward {
                ranges.reverse();
            }
            for range in ranges {
                let [first, last] = match piece.is_backward {
                    true => [range[1], range[0]],
                    false => range,
                };
                let along = |s: f64| {
                    (k as f64 + if piece.is_backward { 1.0 - s } else { s }) / spans as f64
                };
                let by = |s: f64| moved[0] + (moved[1] - moved[0]) * along(s);
                let place = |corner: f64| match along(corner) {
                    0.0 => piece.start,
                    1.0 => piece.end,
                    _ => curve.at(span, corner).0 + by(corner),
                };
                parts.push(Self {
                    curve,
                    piece,
                    span,
                    range: [first.0, last.0],
                    ends: [first, last].map(|(_, corner)| place(corner)),
                    moved: [first, last].map(|(s, _)| by(s)),
                    still: SLOW * size,
                });
            }
        }
        parts
    }

    /// Both halves of it.
    pub(super) fn halves(&self) -> [Self; 2] {
        let (middle, _) = self.at(0.5);
        let [from, to] = self.range;
        let (cut, by) = (
            f64::midpoint(from, to),
            (self.moved[0] + self.moved[1]) * 0.5,
        );
        let first = Self {
            range: [from, cut],
            ends: [self.ends[0], middle],
            moved: [self.moved[0], by],
            ..*self
        };
        let second = Self {
            range: [cut, to],
            ends: [middle, self.ends[1]],
            moved: [by, self.moved[1]],
            ..*self
        };
        [first, second]
    }

    /// The point at a fraction of the part, and the direction of travel; the chord's where the derivative vanishes.
    pub(super) fn at(&self, s: f64) -> (Point, Vector) {
        let [from, to] = self.range;
        let shift = |s: f64| self.moved[0] + (self.moved[1] - self.moved[0]) * s;
        let (on_curve, derivative) = self.curve.at(self.span, from + (to - from) * s);
        let point = match s {
            0.0 => self.ends[0],
            1.0 => self.ends[1],
            _ => on_curve + shift(s),
        };
        let mut velocity = derivative * (to - from) + (self.moved[1] - self.moved[0]);
        if velocity.length() <= self.still * (to - from).abs() {
            /// Steps along a part over which a cusp's direction shows: over the first, if that is more than rounding.
            const STEPS: [f64; 4] = [1e-3, 1e-2, 1e-1, 1.0];
            let near = |s: f64| self.curve.at(self.span, from + (to - from) * s).0 + shift(s);
            velocity = (STEPS.iter())
                .map(|step| near((s + step).min(1.0)) - near((s - step).max(0.0)))
                .find(|v| v.length() > self.still)
                .unwrap_or(self.ends[1] - self.ends[0]);
        }
        (point, velocity.unit())
    }
}

/// The fractions of a span between its sharp turns, each with the fraction at which its corner is.
fn between(turns: &[[f64; 2]]) -> Vec<[(f64, f64); 2]> {
    let mut ranges = Vec::with_capacity(turns.len() + 1);
    let mut start = (0.0, 0.0);
    for &[from, to] in turns {
        let corner = match (from, to) {
            (0.0, _) => 0.0,
            (_, 1.0) => 1.0,
            _ => f64::midpoint(from, to),
        };
        ranges.push([start, (from, corner)]);
        start = (to, corner);
    }
    ranges.push([start, (1.0, 1.0)]);
    ranges.retain(|[start, end]| start.0 < end.0);
    ranges
}

//! Monotone functions of one coordinate, and the intervals between two of them.

use core::f64::consts::TAU;

use cspace::fixed_axes::{PlaneCurve, SweptPlane};
use cspace::{Ball, Real};

/// A monotone function over a band: a contact curve and a constant, or a constant alone.
#[derive(Clone, Copy)]
pub(crate) struct Graph<'a> {
    curve: Option<(&'a SweptPlane, PlaneCurve)>,
    add: f64,
}

impl<'a> Graph<'a> {
    pub(crate) fn level(at: f64) -> Self {
        Self {
            curve: None,
            add: at,
        }
    }

    pub(crate) fn curve(plane: &'a SweptPlane, curve: PlaneCurve) -> Self {
        Self {
            curve: Some((plane, curve)),
            add: 0.0,
        }
    }

    pub(crate) fn at(&self, x: f64) -> f64 {
        self.curve.map_or(0.0, |(plane, c)| plane.value(c, x)) + self.add
    }

    /// An enclosure of the slope over an interval.
    pub(crate) fn slope(&self, interval: (f64, f64)) -> Ball {
        match self.curve {
            Some((plane, c)) => plane.slope(c, interval),
            None => Ball::constant(0.0),
        }
    }

    pub(crate) fn moved(self, by: f64) -> Self {
        Self {
            add: self.add + by,
            ..self
        }
    }
}

/// The values between two monotone functions.
#[derive(Clone, Copy)]
pub(crate) struct Span<'a> {
    pub(crate) lower: Graph<'a>,
    pub(crate) upper: Graph<'a>,
}

impl Span<'_> {
    pub(crate) fn at(&self, x: f64) -> (f64, f64) {
        (self.lower.at(x), self.upper.at(x))
    }

    /// Minimum and maximum value over an interval.
    pub(crate) fn hull(&self, (lo, hi): (f64, f64)) -> (f64, f64) {
        (
            self.lower.at(lo).min(self.lower.at(hi)),
            self.upper.at(lo).max(self.upper.at(hi)),
        )
    }

    /// Copy moved by whole turns.
    pub(crate) fn turned(self, turns: i32) -> Self {
        let by = TAU * f64::from(turns);
        Self {
            lower: self.lower.moved(by),
            upper: self.upper.moved(by),
        }
    }

    /// Copy narrower by `opening`, which is empty where the width is less than that.
    pub(crate) fn narrowed(self, opening: f64) -> Self {
        Self {
            lower: self.lower.moved(0.5 * opening),
            upper: self.upper.moved(-0.5 * opening),
        }
    }
}

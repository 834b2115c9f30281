//! A step that is taken, in which something may happen.

use super::super::flow::{Bearings, Flow};
use super::super::world::{State, Step, World};
use super::dense::Dense;
use super::take::{Span, Taken};
use crate::root::root;

/// Largest number of true steps by which a root of the polynomial is refined: each reduces the error by as much as the
/// polynomial's own.
const MENDED: usize = 6;
/// Share of the interval of the root over which the slope of the function is computed from the polynomial.
const SLOPE: f64 = 1e-3;
/// Largest number of times that a refined root, at which the function is still positive, is moved a little farther.
const FARTHER: usize = 6;

/// The step, with its polynomial.
pub(super) struct Course<'c, 'a, W: World + ?Sized> {
    pub(super) flow: &'c Flow<'a, W>,
    pub(super) span: Span<'c>,
    pub(super) bearing: Vec<usize>,
    dense: Dense,
}

impl<'c, 'a, W: World + ?Sized> Course<'c, 'a, W> {
    /// A step of a length.
    pub(super) fn new(flow: &'c Flow<'a, W>, span: Span<'c>, h: f64, taken: &Taken) -> Self {
        Self {
            flow,
            span,
            bearing: span.bearings.iter().map(|b| b.0).collect(),
            dense: Dense::new(span.from, h, taken),
        }
    }

    pub(super) fn world(&self) -> &'a W {
        self.flow.world
    }

    pub(super) fn bearings(&self) -> &'c Bearings {
        self.span.bearings
    }

    /// A shorter step.
    pub(super) fn at(&self, h: f64) -> Option<Taken> {
        self.flow.take(self.span, h)
    }

    /// Approximate state after a shorter step: the interpolation, projected to where joints and contacts hold.
    pub(super) fn near(&self, h: f64) -> Option<State> {
        let state = self.dense.at(self.span.from, h);
        Some(self.flow.projected(state, self.bearings())?.0)
    }

    /// Whether something was met up to a state.
    pub(super) fn met(&self, to: &State) -> bool {
        self.world().met(Step {
            from: self.span.from,
            to,
            bearing: &self.bearing,
        })
    }

    /// Interpolated state after a shorter step, without the projection: joints and contacts are violated slightly.
    pub(super) fn rough(&self, h: f64) -> State {
        self.dense.at(self.span.from, h)
    }

    /// A root of a function between two times, at which it is positive and below 0: of a step to there, and how long it is.
    pub(super) fn root(
        &self,
        (lo, f_lo): (f64, f64),
        (hi, f_hi): (f64, f64),
        value: &dyn Fn(&State) -> Option<f64>,
    ) -> Option<(f64, Taken)> {
        let about = self.about((lo, f_lo), (hi, f_hi), value)?;
        self.exactly(about, (lo, f_lo), (hi, f_hi), value)
    }

    /// Approximate time of the root, by the interpolating polynomial.
    pub(super) fn about(
        &self,
        begin: (f64, f64),
        end: (f64, f64),
        value: &dyn Fn(&State) -> Option<f64>,
    ) -> Option<f64> {
        root(begin, end, |h| value(&self.rough(h)))
    }

    /// Exact root and the step to it, from an approximate one.
    pub(super) fn exactly(
        &self,
        about: f64,
        (lo, f_lo): (f64, f64),
        (hi, f_hi): (f64, f64),
        value: &dyn Fn(&State) -> Option<f64>,
    ) -> Option<(f64, Taken)> {
        if let Some(found) = self.mended(about, (lo, hi), value) {
            return Some(found);
        }
        let h = root((lo, f_lo), (hi, f_hi), |h| value(&self.at(h)?.state))?;
        Some((h, self.at(h)?))
    }

    /// Refines a root of the polynomial by secants.
    fn mended(
        &self,
        about: f64,
        (lo, hi): (f64, f64),
        value: &dyn Fn(&State) -> Option<f64>,
    ) -> Option<(f64, Taken)> {
        let side = SLOPE * (hi - lo);
        let (before, after) = ((about - side).max(lo), (about + side).min(hi));
        let of = |h: f64| value(&self.rough(h));
        let mut slope = (of(after)? - of(before)?) / (after - before);
        let mut h = about;
        let mut taken = self.at(h)?;
        let mut f = value(&taken.state)?;
        let time = |h: f64| self.span.from.t + h;
        for _ in 0..MENDED {
            // A root at the end, to rounding, is there.
            let next = (h - f / slope).min(hi);
            if !(slope < 0.0 && next > lo) {
                return (f == 0.0).then_some((h, taken));
            }
            if f == 0.0 || time(next) == time(h) {
                break;
            }
            let there = self.at(next)?;
            let g = value(&there.state)?;
            if g.abs() >= f.abs() {
                break;
            }
            let secant = (g - f) / (next - h);
            if secant.is_finite() {
                slope = secant;
            }
            (h, taken, f) = (next, there, g);
        }
        // The step must end past the root, where the function is not positive.
        let mut more = (f / slope).abs().max(f64::EPSILON * time(h).abs());
        for _ in 0..FARTHER {
            if f <= 0.0 || h >= hi {
                break;
            }
            h = (h + more).min(hi);
            more *= 2.0;
            taken = self.at(h)?;
            f = value(&taken.state)?;
        }
        (f <= 0.0).then_some((h, taken))
    }
}

/// A state a very short time before another, along its rates.
pub(super) fn just_before(state: &State, time: f64) -> State {
    let mut before = state.clone();
    before.t -= time;
    before.q.axpy(-time, &state.v, 1.0);
    before
}

//! Steps of the motion between events, and the events at their ends.

use nalgebra::DVector;

use crate::dormand_prince::{DIFFERENCE, STAGES};

use super::flow::{Bearings, Flow};
use super::modes::Mode;
use super::world::{State, World};

/// Errors of a step, as a share of the largest value of each coordinate and rate so far.
const TOLERANCE: f64 = 1e-12;
/// A root in a step is found to this share of it, or to rounding of the time.
const ROOT: f64 = 1e-15;
/// And after so many steps at most.
const TRIES: usize = 100;

/// A function that is smaller than this share of its value at the end of a step begins at 0.
const START: f64 = 1e-6;
/// And is looked at down to this share of the step.
const SHORTEST: f64 = 1e-9;

/// What may happen to a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Watched {
    /// The gap of a contact that does not bear.
    Gap,
    /// The force of one that does.
    Force,
    /// The rate at which one slides.
    Sliding,
    /// What the friction of one that sticks is short of.
    Sticking,
}

/// A function that ends a step where it falls below 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Watch {
    pub(super) contact: usize,
    pub(super) kind: Watched,
    value: f64,
}

/// Where a step ends.
#[derive(Debug, Clone)]
pub(super) struct Stepped {
    pub(super) state: State,
    /// What ended it, if anything did.
    pub(super) events: Vec<(usize, Watched)>,
    /// How long the next may be.
    pub(super) next: f64,
}

impl<W: World + ?Sized> Flow<'_, W> {
    /// One step of a length, with its error as a share of what is allowed.
    fn take(
        &self,
        from: &State,
        h: f64,
        bearings: &Bearings,
        largest: &(DVector<f64>, DVector<f64>),
    ) -> Option<(State, f64)> {
        let mut slopes: Vec<(DVector<f64>, DVector<f64>)> = Vec::with_capacity(7);
        let mut at = from.clone();
        slopes.push((at.v.clone(), self.accelerations(&at, bearings)?.x));
        for (time, weights) in STAGES {
            at.t = from.t + time * h;
            at.q.copy_from(&from.q);
            at.v.copy_from(&from.v);
            for (&weight, slope) in weights.iter().zip(&slopes) {
                at.q += &slope.0 * (h * weight);
                at.v += &slope.1 * (h * weight);
            }
            slopes.push((at.v.clone(), self.accelerations(&at, bearings)?.x));
        }
        let mut error = 0.0_f64;
        for k in 0..at.q.len() {
            let (mut q, mut v) = (0.0, 0.0);
            for (weight, slope) in DIFFERENCE.iter().zip(&slopes) {
                q += h * weight * slope.0[k];
                v += h * weight * slope.1[k];
            }
            error = error.max(q.abs() / (TOLERANCE * largest.0[k]));
            error = error.max(v.abs() / (TOLERANCE * largest.1[k]));
        }
        // The last stage is the end of the step.
        let end = self.projected(at, bearings)?;
        Some((end, error))
    }

    /// The functions that are watched, at a state.
    pub(super) fn watches(&self, state: &State, bearings: &Bearings) -> Option<Vec<Watch>> {
        let mut found = Vec::new();
        for contact in 0..self.world.contacts() {
            if bearings.iter().all(|b| b.0 != contact) {
                let value = self.world.touch(contact, &state.q).gap;
                found.push(Watch {
                    contact,
                    kind: Watched::Gap,
                    value,
                });
            }
        }
        let solution = self.accelerations(state, bearings)?;
        for (k, &(contact, mode)) in bearings.iter().enumerate() {
            let (normal, tangential) = (solution.normal[k], solution.tangential[k]);
            found.push(Watch {
                contact,
                kind: Watched::Force,
                value: normal,
            });
            let friction = self.world.surface(contact).friction;
            let rate = self.world.touch(contact, &state.q).tangent.dot(&state.v);
            let (kind, value) = match mode {
                Mode::Stick => (Watched::Sticking, friction * normal - tangential.abs()),
                // Without friction it does not matter which way it slides.
                _ if friction == 0.0 => continue,
                mode => (Watched::Sliding, rate * mode.direction()),
            };
            found.push(Watch {
                contact,
                kind,
                value,
            });
        }
        Some(found)
    }

    /// A step of at most a length, to the first event in it if there is one. `None` if the equations of the modes have no solution.
    pub(super) fn step(
        &self,
        from: &State,
        longest: f64,
        bearings: &Bearings,
        largest: &(DVector<f64>, DVector<f64>),
    ) -> Option<Stepped> {
        let mut h = longest;
        let (mut end, error) = loop {
            let (end, error) = self.take(from, h, bearings, largest)?;
            if error <= 1.0 || h <= 1e-12 * longest.max(f64::MIN_POSITIVE) {
                break (end, error);
            }
            h *= (0.9 * error.powf(-0.2)).clamp(0.1, 0.9);
        };
        let next = h * (0.9 * error.max(1e-10).powf(-0.2)).clamp(0.2, 5.0);
        let before = self.watches(from, bearings)?;
        let at = |h: f64| -> Option<(State, Vec<Watch>)> {
            let (state, _) = self.take(from, h, bearings, largest)?;
            let watches = self.watches(&state, bearings)?;
            Some((state, watches))
        };
        let mut watches = self.watches(&end, bearings)?;
        // A gap that closes and opens again within the step.
        for k in 0..before.len() {
            let (first, last) = (before[k], watches[k]);
            if first.kind != Watched::Gap || last.value < 0.0 {
                continue;
            }
            let rate = |state: &State| {
                self.world
                    .touch(first.contact, &state.q)
                    .normal
                    .dot(&state.v)
            };
            if rate(from) < 0.0 && rate(&end) > 0.0 {
                let lowest = |h: f64| at(h).map(|(state, _)| -rate(&state));
                let least = root((0.0, -rate(from)), (h, -rate(&end)), lowest)?;
                let (state, there) = at(least)?;
                if there[k].value < 0.0 {
                    (h, end, watches) = (least, state, there);
                }
            }
        }
        let mut events = Vec::new();
        // Of what falls below 0 the first; then what is below 0 there, if anything still is.
        while let Some(k) = (0..watches.len()).find(|&k| falls(&before[k], &watches[k])) {
            let value = |h: f64| at(h).map(|(_, w)| w[k].value);
            // What begins at 0 and grows is positive somewhere in between.
            let mut begin = (0.0, before[k].value);
            let mut ahead = h;
            while begin.1 <= START * watches[k].value.abs() && ahead > SHORTEST * h {
                ahead *= 0.5;
                begin = (ahead, value(ahead)?);
            }
            let first = if begin.1 > 0.0 {
                root(begin, (h, watches[k].value), value)?
            } else {
                ahead
            };
            let (state, mut there) = at(first)?;
            // It is 0 here, whatever rounding makes of it.
            there[k].value = 0.0;
            events.retain(|&(j, _): &(usize, Watched)| there[j].value <= 0.0);
            events.push((k, watches[k].kind));
            for &(j, _) in &events {
                there[j].value = 0.0;
            }
            if first >= h {
                break;
            }
            (h, end, watches) = (first, state, there);
        }
        Some(Stepped {
            state: end,
            events: events
                .into_iter()
                .map(|(k, kind)| (before[k].contact, kind))
                .collect(),
            next,
        })
    }
}

/// Whether a function is below 0 after a step, by more than it was before.
fn falls(before: &Watch, after: &Watch) -> bool {
    after.value < before.value.min(0.0)
}

/// A root between two places: the first has a positive value, the second one below 0. Found by the method of Illinois with
/// halving, from the side where the function is positive.
fn root(
    (mut lo, mut f_lo): (f64, f64),
    (mut hi, mut f_hi): (f64, f64),
    f: impl Fn(f64) -> Option<f64>,
) -> Option<f64> {
    let width = hi - lo;
    for i in 0..TRIES {
        if hi - lo <= ROOT * width {
            break;
        }
        let secant = (lo * f_hi - hi * f_lo) / (f_hi - f_lo);
        let at = if i % 3 == 2 || !(secant > lo && secant < hi) {
            0.5 * (lo + hi)
        } else {
            secant
        };
        if at <= lo || at >= hi {
            break;
        }
        let value = f(at)?;
        if value > 0.0 {
            (lo, f_lo) = (at, value);
            f_hi *= 0.5;
        } else {
            (hi, f_hi) = (at, value);
            f_lo *= 0.5;
        }
        if value == 0.0 {
            return Some(at);
        }
    }
    Some(hi)
}

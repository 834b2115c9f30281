//! Steps of the motion between events, and the events at their ends.

use nalgebra::DVector;

use crate::dormand_prince::{DIFFERENCE, STAGES};

use super::flow::{Bearings, Flow};
use super::modes::Mode;
use super::world::{Acting, Sought, State, Step, World};

/// The error of a step, as a share of the size, and of the largest rate so far.
const TOLERANCE: f64 = 1e-11;
/// A root in a step is found to this share of it, or to rounding of the time.
const ROOT: f64 = 1e-15;
/// And after so many steps at most.
const TRIES: usize = 100;

/// What a step met is located to this share of it.
const LOCATED: f64 = 1e-14;
/// A root between two times is looked for when they are within these shares of the step.
const QUICK: [f64; 3] = [0.125, 1e-3, 1e-6];
/// Nothing is met at this share of the two times before it.
const BEFORE: f64 = 1e-7;
/// A function is looked for whose root is not farther back than coordinates change by this, relative to the size.
const NEAR_EVENT: f64 = 1e-6;

/// And one whose root is not farther ahead than this: what contacts are known to.
const EARLY: f64 = 4.0 * super::CLOSED;

/// A function other than a gap that is smaller than this share of its value at the end of a step begins at 0.
const START: f64 = 1e-6;
/// And is looked at down to this share of the step.
const SHORTEST: f64 = 1e-12;

/// What may happen to a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Watched {
    /// The gap of a contact that does not bear.
    Gap,
    /// The same, where it never opened by more than rounding.
    Back,
    /// The force of one that does.
    Force,
    /// The rate at which one slides.
    Sliding,
    /// What the friction of one that sticks is short of.
    Sticking,
}

/// What is looked at in steps between two events, beside the forces of what bears.
#[derive(Debug, Clone, Default)]
pub(super) struct Looked {
    /// Contacts whose gaps may close.
    pub(super) gaps: Vec<usize>,
    /// Contacts with the force of sliding that others keep from it: they do not slide, and begin to only after another event.
    pub(super) idle: Vec<usize>,
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
    /// Whether it met something beside these.
    pub(super) met: bool,
    /// How long the next may be.
    pub(super) next: f64,
    /// How far closed contacts and joints were open before they were brought together.
    pub(super) open: f64,
    /// The work of drives and what was lost by friction, on the way.
    pub(super) work: [f64; 2],
}

/// The end of a step.
#[derive(Debug, Clone)]
pub(super) struct Taken {
    pub(super) state: State,
    /// The error, as a share of what is allowed.
    pub(super) error: f64,
    pub(super) open: f64,
    pub(super) work: [f64; 2],
}

impl<W: World + ?Sized> Flow<'_, W> {
    /// One step of a length.
    pub(super) fn take(
        &self,
        from: &State,
        h: f64,
        bearings: &Bearings,
        fastest: f64,
    ) -> Option<Taken> {
        let mut slopes: Vec<(DVector<f64>, DVector<f64>)> = Vec::with_capacity(7);
        let mut work = [0.0; 2];
        let mut at = from.clone();
        // The weights of the last stage are those of the step.
        let shares = STAGES.last().map_or(&[][..], |s| s.1);
        let mut slope = |at: &State, k: usize| {
            let solution = self.accelerations(at, bearings)?;
            if let Some(share) = shares.get(k).filter(|s| **s != 0.0) {
                let acting = Acting::of(&solution, bearings);
                let powers = self.world.powers(at, &acting);
                work[0] += share * h * powers[0];
                work[1] += share * h * powers[1];
            }
            Some((at.v.clone(), solution.x))
        };
        slopes.push(slope(&at, 0)?);
        for (k, (time, weights)) in STAGES.iter().enumerate() {
            at.t = from.t + time * h;
            at.q.copy_from(&from.q);
            at.v.copy_from(&from.v);
            for (&weight, slope) in weights.iter().zip(&slopes) {
                at.q.axpy(h * weight, &slope.0, 1.0);
                at.v.axpy(h * weight, &slope.1, 1.0);
            }
            slopes.push(slope(&at, k + 1)?);
        }
        let (mut q, mut v) = (DVector::zeros(at.q.len()), DVector::zeros(at.q.len()));
        for (weight, slope) in DIFFERENCE.iter().zip(&slopes) {
            q.axpy(h * weight, &slope.0, 1.0);
            v.axpy(h * weight, &slope.1, 1.0);
        }
        let error = (self.world.reach(&q) / self.world.size()).max(self.world.reach(&v) / fastest)
            / TOLERANCE;
        if error.is_nan() {
            return None;
        }
        // The last stage is the end of the step.
        let (state, open) = self.projected(at, bearings)?;
        Some(Taken {
            state,
            error,
            open,
            work,
        })
    }

    /// The functions that are watched, at a state.
    pub(super) fn watches(
        &self,
        state: &State,
        bearings: &Bearings,
        looked: &Looked,
    ) -> Option<Vec<Watch>> {
        let mut found = Vec::new();
        for &contact in &looked.gaps {
            if bearings.iter().all(|b| b.0 != contact) {
                let value = self.world.touch(contact, state.t, &state.q).gap;
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
            let touch = self.world.touch(contact, state.t, &state.q);
            let rate = touch.sliding(&state.v);
            let (kind, value) = match mode {
                Mode::Stick => (Watched::Sticking, friction * normal - tangential.abs()),
                // Without friction it does not matter which way it slides.
                _ if friction == 0.0 => continue,
                _ if looked.idle.contains(&contact) => continue,
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

    /// A step of at most a length, to the first event in it if there is one, with the gaps of some contacts looked at. `None` if the equations of the modes have no solution.
    pub(super) fn step(
        &self,
        from: &State,
        longest: f64,
        bearings: &Bearings,
        looked: &Looked,
        fastest: f64,
    ) -> Option<Stepped> {
        let mut h = longest;
        let shortest = 1e-12 * longest.max(f64::MIN_POSITIVE);
        let mut taken = loop {
            // What cannot be followed so far may be followed less far.
            let Some(taken) = self.take(from, h, bearings, fastest) else {
                h *= 0.25;
                if h < shortest {
                    return None;
                }
                continue;
            };
            if taken.error <= 1.0 || h <= shortest {
                break taken;
            }
            h *= (0.9 * taken.error.powf(-0.2)).clamp(0.1, 0.9);
        };
        let next = h * (0.9 * taken.error.max(1e-10).powf(-0.2)).clamp(0.2, 5.0);
        let before = self.watches(from, bearings, looked)?;
        let at = |h: f64| -> Option<(Taken, Vec<Watch>)> {
            let taken = self.take(from, h, bearings, fastest)?;
            let watches = self.watches(&taken.state, bearings, looked)?;
            Some((taken, watches))
        };
        let mut watches = self.watches(&taken.state, bearings, looked)?;
        // A gap that closes and opens again within the step.
        for k in 0..before.len() {
            let (first, last) = (before[k], watches[k]);
            if first.kind != Watched::Gap || last.value < 0.0 {
                continue;
            }
            let rate = |state: &State| {
                let touch = self.world.touch(first.contact, state.t, &state.q);
                touch.opening(&state.v)
            };
            if rate(from) < 0.0 && rate(&taken.state) > 0.0 {
                let lowest = |h: f64| at(h).map(|(taken, _)| -rate(&taken.state));
                let least = root((0.0, -rate(from)), (h, -rate(&taken.state)), lowest)?;
                let (there, values) = at(least)?;
                if values[k].value < 0.0 {
                    (h, taken, watches) = (least, there, values);
                }
            }
        }
        let mut events = Vec::new();
        let mut ignored: Vec<usize> = Vec::new();
        // Of what falls below 0 the first; then what is below 0 there, if anything still is.
        while let Some(k) =
            (0..watches.len()).find(|k| !ignored.contains(k) && falls(&before[*k], &watches[*k]))
        {
            let value = |h: f64| at(h).map(|(_, w)| w[k].value);
            // What begins at 0 and grows is positive somewhere in between.
            let mut begin = (0.0, before[k].value);
            let mut ahead = h;
            let nothing = match watches[k].kind {
                Watched::Gap => f64::EPSILON * self.world.size(),
                _ => START * watches[k].value.abs(),
            };
            while begin.1 <= nothing && ahead > SHORTEST * h {
                ahead *= 0.5;
                begin = (ahead, value(ahead)?);
            }
            let kind = match watches[k].kind {
                Watched::Gap if begin.1 <= nothing => Watched::Back,
                kind => kind,
            };
            let first = if begin.1 > 0.0 {
                root(begin, (h, watches[k].value), value)?
            } else {
                ahead
            };
            let (state, mut there) = at(first)?;
            let (contact, at) = (before[k].contact, &state.state);
            if watches[k].kind == Watched::Gap && !self.world.is_there(contact, at.t, &at.q) {
                // Beyond the ends of its features a contact has no gap.
                ignored.push(k);
                continue;
            }
            // It is 0 here, whatever rounding makes of it.
            there[k].value = 0.0;
            events.retain(|&(j, _): &(usize, Watched)| there[j].value <= 0.0);
            events.push((k, kind));
            for &(j, _) in &events {
                there[j].value = 0.0;
            }
            if first >= h {
                break;
            }
            (h, taken, watches) = (first, state, there);
        }
        let mut events: Vec<(usize, Watched)> = (events.into_iter())
            .map(|(k, kind)| (before[k].contact, kind))
            .collect();
        let bearing: Vec<usize> = bearings.iter().map(|b| b.0).collect();
        let met = |to: &State| {
            let bearing = &bearing;
            self.world.met(Step { from, to, bearing })
        };
        let mut is_met = met(&taken.state);
        if is_met {
            let found = self.first_met(from, h, bearings, fastest, &met)?;
            // What would have happened later does not.
            events = found.1.into_iter().map(|c| (c, Watched::Gap)).collect();
            taken = found.0;
            is_met = true;
        }
        Some(Stepped {
            state: taken.state,
            events,
            met: is_met,
            next,
            open: taken.open,
            work: taken.work,
        })
    }

    /// Where a step first met something, and the contacts that closed there.
    ///
    /// Halving the step tells it as well as contacts are told by their spaces; then the function is looked for that vanishes there.
    fn first_met(
        &self,
        from: &State,
        h: f64,
        bearings: &Bearings,
        fastest: f64,
        met: &dyn Fn(&State) -> bool,
    ) -> Option<(Taken, Vec<usize>)> {
        let at = |h: f64| self.take(from, h, bearings, fastest);
        let bearing: Vec<usize> = bearings.iter().map(|b| b.0).collect();
        let (mut before, mut after) = (0.0, h);
        let mut ends: (Option<Taken>, Option<Taken>) = (None, None);
        let mut tries = QUICK.iter();
        let mut next = tries.next();
        while after - before > LOCATED * h {
            if next.is_some_and(|share| after - before <= share * h) {
                next = tries.next();
                let begin = ends.0.as_ref().map_or(from, |taken| &taken.state);
                if let Some(end) = &ends.1 {
                    let between = ((before, begin), (after, &end.state));
                    if let Some(found) = self.first_root(between, &bearing, &at, met) {
                        return Some(found);
                    }
                }
            }
            let middle = 0.5 * (before + after);
            if middle <= before || middle >= after {
                break;
            }
            match at(middle) {
                Some(to) if !met(&to.state) => {
                    before = middle;
                    ends.0 = Some(to);
                }
                found => {
                    after = middle;
                    ends.1 = found;
                }
            }
        }
        let end = match at(after) {
            Some(end) => end,
            None => at(before)?,
        };
        let last = at(before)?;
        let step = Step {
            from: &last.state,
            to: &end.state,
            bearing: &bearing,
        };
        let mut first: Option<(f64, Taken, Sought)> = None;
        for sought in self.world.sought(step, 0.0) {
            let value = |to: &Taken| self.world.value(sought, to.state.t, &to.state.q);
            if let Some((h, taken)) = self.last_root(after, &end, &at, &value)
                && first.as_ref().is_none_or(|f| h < f.0)
            {
                first = Some((h, taken, sought));
            }
        }
        Some(match first {
            Some((_, taken, Sought::Gap(contact))) => (taken, vec![contact]),
            Some((_, taken, Sought::End(..))) => (taken, Vec::new()),
            None => (end, Vec::new()),
        })
    }

    /// The first root of a function that is positive at the first of two times and negative at the second, if that is what is met
    /// between them.
    fn first_root(
        &self,
        ((before, begin), (after, end)): ((f64, &State), (f64, &State)),
        bearing: &[usize],
        at: &dyn Fn(f64) -> Option<Taken>,
        met: &dyn Fn(&State) -> bool,
    ) -> Option<(Taken, Vec<usize>)> {
        let world = self.world;
        let step = Step {
            from: begin,
            to: end,
            bearing,
        };
        let way = world.reach(&(&end.q - &begin.q));
        let mut first: Option<(f64, Sought)> = None;
        for sought in world.sought(step, way) {
            let value = |state: &State| world.value(sought, state.t, &state.q);
            let (a, b) = (value(begin), value(end));
            if !(a > 0.0 && b < 0.0) {
                continue;
            }
            let h = root((before, a), (after, b), |h| {
                at(h).map(|to| value(&to.state))
            })?;
            if first.is_none_or(|f| h < f.0) {
                first = Some((h, sought));
            }
        }
        let (h, sought) = first?;
        let taken = at(h)?;
        let there = &taken.state;
        let closed = match sought {
            Sought::Gap(contact) if !world.is_there(contact, there.t, &there.q) => return None,
            Sought::Gap(contact) => vec![contact],
            Sought::End(..) => Vec::new(),
        };
        // Nothing else was met before.
        let just = at(h - BEFORE * (after - before))?;
        (!met(&just.state)).then_some((taken, closed))
    }

    /// The last root before a time of a function that is negative then, or the first after it of one that is nearly 0, if it is near;
    /// just after it.
    fn last_root(
        &self,
        after: f64,
        end: &Taken,
        at: &dyn Fn(f64) -> Option<Taken>,
        value: &dyn Fn(&Taken) -> f64,
    ) -> Option<(f64, Taken)> {
        let (mut below, mut above, mut back) = (after, after, LOCATED * after);
        // Spaces tell contacts a little early.
        let mut early = value(end) >= 0.0;
        while early {
            below = after + back;
            back *= 2.0;
            let to = at(below)?;
            let moved = self.world.reach(&(&to.state.q - &end.state.q));
            if moved > EARLY * self.world.size() {
                return None;
            }
            early = value(&to) >= 0.0;
        }
        while below <= after {
            above = (above - back).max(0.0);
            back *= 2.0;
            let to = at(above)?;
            let moved = self.world.reach(&(&to.state.q - &end.state.q));
            if value(&to) >= 0.0 {
                break;
            }
            if above == 0.0 || moved > NEAR_EVENT * self.world.size() {
                return None;
            }
            below = above;
        }
        let of = |h: f64| at(h).map(|to| value(&to));
        let below = root((above, of(above)?), (below, of(below)?), of)?;
        Some((below, at(below)?))
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

//! Steps of the motion between events, and the events at their ends.

mod course;
mod dense;
mod met;
mod take;
mod watched;

use super::flow::Flow;
use super::world::{State, World};
use course::{Course, just_before};
pub(super) use take::{Span, Taken};
use watched::Watch;
pub(super) use watched::{Looked, Watched};

/// A function other than a gap that is smaller than this share of its value at the end of a step begins at 0.
const START: f64 = 1e-6;
/// Shortest share of the step at which such a function is evaluated.
const SHORTEST: f64 = 1e-12;
/// Number of times that a step is cut where one of its stages has a force that its mode does not allow, each to a fifth or less: what is left
/// begins with such a force.
const MOST_CUTS: usize = 6;
/// Share of the step before a closing gap at which other meetings are looked for: contacts nearer than this are closed
/// as well.
const JUST: f64 = 1e-12;

/// State and events at the end of a step.
#[derive(Debug, Clone)]
pub(super) struct Stepped {
    pub(super) state: State,
    /// Events that ended the step, if any: pairs of contact and function.
    pub(super) events: Vec<(usize, Watched)>,
    /// Whether the step met something beside these.
    pub(super) met: bool,
    /// Largest length of the next step.
    pub(super) next: f64,
    /// Largest gap or penetration of closed contacts and joints before they were projected.
    pub(super) open: f64,
    /// Work of drives and losses by friction during the step.
    pub(super) work: [f64; 2],
}

/// End of a step with the watched values there, and its length.
struct End {
    h: f64,
    taken: Taken,
    watches: Vec<Watch>,
}

impl<W: World + ?Sized> Flow<'_, W> {
    /// A step as long as its error allows, with its largest allowed length.
    fn longest(&self, span: Span<'_>, longest: f64) -> Option<(f64, Taken)> {
        let mut h = longest;
        let shortest = 1e-12 * longest.max(f64::MIN_POSITIVE);
        loop {
            // A step that fails may succeed with a shorter length.
            let Some(taken) = self.take(span, h) else {
                h *= 0.25;
                if h < shortest {
                    return None;
                }
                continue;
            };
            if taken.error <= 1.0 || h <= shortest {
                return Some((h, taken));
            }
            h *= (0.9 * taken.error.powf(-0.2)).clamp(0.1, 0.9);
        }
    }

    /// A step of at most a length, to the first event in it if there is one, with the gaps of some contacts looked at. `None` if the
    /// equations of the modes have no solution.
    pub(super) fn step(&self, span: Span<'_>, longest: f64, looked: &Looked) -> Option<Stepped> {
        let before = self.watches(span.from, span.bearings, looked)?;
        let (mut h, mut taken) = self.longest(span, longest)?;
        for _ in 0..MOST_CUTS {
            let Some(sooner) = self.forbidden(&taken, h, span.bearings, looked) else {
                break;
            };
            (h, taken) = (sooner, self.take(span, sooner)?);
        }
        let next = h * (0.9 * taken.error.max(1e-10).powf(-0.2)).clamp(0.2, 5.0);
        let course = Course::new(self, span, h, &taken);
        let watches = self.watches(&taken.state, span.bearings, looked)?;
        let mut end = End { h, taken, watches };
        self.graze(&course, &before, &mut end, looked)?;
        let mut events = self.fallen(&course, &before, &mut end, looked)?;
        let closes = (events.iter()).any(|e| matches!(e.1, Watched::Gap | Watched::Back));
        let met = if closes {
            course.met(&just_before(&end.taken.state, JUST * end.h))
        } else {
            course.met(&end.taken.state)
        };
        let mut taken = end.taken;
        if met {
            let found = course.first_met(end.h, taken.state.clone())?;
            // Later events are dropped.
            events = found.1.into_iter().map(|c| (c, Watched::Gap)).collect();
            taken = found.0;
        }
        Some(Stepped {
            state: taken.state,
            events,
            met,
            next,
            open: taken.open,
            work: taken.work,
        })
    }

    /// Ends a step where a gap that closes and opens again within it is least, if it is closed there.
    fn graze(
        &self,
        course: &Course<'_, '_, W>,
        before: &[Watch],
        end: &mut End,
        looked: &Looked,
    ) -> Option<()> {
        for (k, first) in before.iter().enumerate() {
            if first.kind != Watched::Gap || end.watches[k].value < 0.0 {
                continue;
            }
            let closing = |state: &State| {
                let touch = self.world.touch(first.contact, state.t, &state.q);
                Some(-touch.opening(&state.v))
            };
            let (begins, ends) = (closing(course.span.from)?, closing(&end.taken.state)?);
            if begins > 0.0 && ends < 0.0 {
                let (h, taken) = course.root((0.0, begins), (end.h, ends), &closing)?;
                let watches = self.watches(&taken.state, course.bearings(), looked)?;
                if watches[k].value < 0.0 {
                    *end = End { h, taken, watches };
                }
            }
        }
        Some(())
    }

    /// Ends a step at the first root of the functions that become negative in it; returns their contacts and kinds.
    fn fallen(
        &self,
        course: &Course<'_, '_, W>,
        before: &[Watch],
        end: &mut End,
        looked: &Looked,
    ) -> Option<Vec<(usize, Watched)>> {
        let bearings = course.bearings();
        let mut events: Vec<(usize, Watched)> = Vec::new();
        let mut ignored: Vec<usize> = Vec::new();
        // First the earliest function that falls below 0; then further ones that are below 0 there.
        while let Some(k) =
            (0..before.len()).find(|k| !ignored.contains(k) && before[*k].falls(&end.watches[*k]))
        {
            let (watch, last) = (&before[k], end.watches[k].value);
            // A gap that begins below 0 by rounding is closed there.
            let closed = match watch.kind {
                Watched::Gap => watch.value.min(0.0),
                _ => 0.0,
            };
            let last = last - closed;
            let value = |state: &State| Some(self.watched(watch, state, bearings)? - closed);
            // A function that begins at 0 and grows is positive somewhere in between.
            let mut begin = (0.0, watch.value - closed);
            let mut ahead = end.h;
            let nothing = match watch.kind {
                Watched::Gap => f64::EPSILON * self.world.size(),
                _ => START * last.abs(),
            };
            // The last time found at which it is neither.
            let mut still_nothing = None;
            while begin.1 <= nothing && ahead > SHORTEST * end.h {
                ahead *= 0.5;
                // The polynomial shows where the function may be positive, at an eighth of the cost or less.
                let about = value(&course.rough(ahead))?;
                if about <= nothing {
                    if about.abs() <= nothing && still_nothing.is_none() {
                        still_nothing = Some(ahead);
                    }
                    continue;
                }
                begin = (ahead, value(&course.at(ahead)?.state)?);
                if begin.1.abs() <= nothing && still_nothing.is_none() {
                    still_nothing = Some(ahead);
                }
            }
            let kind = match watch.kind {
                Watched::Gap if begin.1 <= nothing => Watched::Back,
                kind => kind,
            };
            let (h, taken) = if begin.1 > 0.0 {
                course.root(begin, (end.h, last), &value)?
            } else {
                let last = still_nothing.unwrap_or(ahead);
                (last, course.at(last)?)
            };
            let at = &taken.state;
            if watch.kind == Watched::Gap && !self.world.is_there(watch.contact, at.t, &at.q) {
                // Beyond the ends of its features a contact has no gap.
                ignored.push(k);
                continue;
            }
            let mut watches = self.watches(at, bearings, looked)?;
            // It is 0 here, whatever rounding makes of it.
            watches[k].value = 0.0;
            events.retain(|&(j, _)| watches[j].value <= 0.0);
            events.push((k, kind));
            for &(j, _) in &events {
                watches[j].value = 0.0;
            }
            if h >= end.h {
                // It is found: others may fall before.
                ignored.push(k);
                continue;
            }
            *end = End { h, taken, watches };
        }
        let told = events.into_iter();
        Some(told.map(|(k, kind)| (before[k].contact, kind)).collect())
    }
}

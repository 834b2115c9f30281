//! Location of the first meeting in a step that no watched function shows.

use super::super::world::{Sought, State, Step, World};
use super::course::{Course, just_before};
use super::take::Taken;
use crate::root::root;

/// Accuracy to which a meeting is located, as a share of the step.
const LOCATED: f64 = 1e-14;
/// A root between two times is looked for when they are within these shares of the step.
const QUICK: [f64; 3] = [0.125, 1e-3, 1e-6];
/// Largest number of earlier meetings examined before the last one.
const MOST_LOOKS: usize = 16;
/// Distance before a root, as a share of the interval, at which no meeting may occur.
const BEFORE: f64 = 1e-7;
/// A function is looked for whose root is not farther back than coordinates change by this, relative to the size.
const NEAR_EVENT: f64 = 1e-6;
/// A function that is below 0 by this on the polynomial, as a share of the size, is below 0: the polynomial of so short a part of a step is
/// right to less.
const SEEN: f64 = 1e-12;
/// Largest distance ahead at which a root counts: the error of contacts.
const EARLY: f64 = 4.0 * super::super::CLOSED;

/// Result of the search among functions that change sign between two times.
enum Shown {
    /// The first root, and the contacts that close there.
    Root(Taken, Vec<usize>),
    /// Something else is met up to this time before it.
    Earlier(f64, State),
    /// Nothing.
    Nothing,
}

impl<W: World + ?Sized> Course<'_, '_, W> {
    /// First meeting in a step of a length, to a state, and the contacts that close there.
    ///
    /// Nearly always it is the first root of a function that changes its sign. Otherwise bisection of the step locates
    /// it as accurately as contacts are known by their spaces; then the function that vanishes there is searched.
    pub(super) fn first_met(&self, h: f64, to: State) -> Option<(Taken, Vec<usize>)> {
        let (mut before, mut after) = (0.0, h);
        let mut ends: (Option<State>, Option<State>) = (None, Some(to));
        for _ in 0..MOST_LOOKS {
            let Some(end) = &ends.1 else {
                break;
            };
            match self.first_root((before, self.span.from), (after, end)) {
                Shown::Root(taken, closed) => return Some((taken, closed)),
                Shown::Earlier(time, state) => {
                    after = time;
                    ends.1 = Some(state);
                }
                Shown::Nothing => break,
            }
        }
        let mut tries = QUICK.iter();
        let mut next = tries.next();
        while after - before > LOCATED * h {
            if next.is_some_and(|share| after - before <= share * h) {
                next = tries.next();
                let begin = ends.0.as_ref().unwrap_or(self.span.from);
                if let Some(end) = &ends.1
                    && let Shown::Root(taken, closed) =
                        self.first_root((before, begin), (after, end))
                {
                    return Some((taken, closed));
                }
            }
            let middle = 0.5 * (before + after);
            if middle <= before || middle >= after {
                break;
            }
            match self.near(middle) {
                Some(to) if !self.met(&to) => {
                    before = middle;
                    ends.0 = Some(to);
                }
                found => {
                    after = middle;
                    ends.1 = found;
                }
            }
        }
        let end = match self.at(after) {
            Some(end) => end,
            None => self.at(before)?,
        };
        let last = self.at(before)?;
        let step = Step {
            from: &last.state,
            to: &end.state,
            bearing: &self.bearing,
        };
        let mut first: Option<(f64, Taken, Sought)> = None;
        for sought in self.world().sought(step, 0.0) {
            let value = |to: &State| self.world().value(sought, to.t, &to.q);
            if let Some((h, taken)) = self.last_root(after, &end.state, &value)
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

    /// First root of a function that is positive at the first of two times and negative at the second, if it is the
    /// meeting between them.
    fn first_root(&self, (before, begin): (f64, &State), (after, end): (f64, &State)) -> Shown {
        let world = self.world();
        let step = Step {
            from: begin,
            to: end,
            bearing: &self.bearing,
        };
        let way = world.reach(&(&end.q - &begin.q));
        let value = |sought: Sought, state: &State| world.value(sought, state.t, &state.q);
        let mut all: Vec<(f64, [f64; 2], Sought)> = Vec::new();
        for sought in world.sought(step, way) {
            let [a, b] = [begin, end].map(|state| value(sought, state));
            if !(a > 0.0 && b < 0.0) {
                continue;
            }
            let about = self.about((before, a), (after, b), &|s| Some(value(sought, s)));
            all.extend(about.map(|about| (about, [a, b], sought)));
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let first = all.into_iter().find_map(|(about, [a, b], sought)| {
            let of = |s: &State| Some(value(sought, s));
            let (h, taken) = self.exactly(about, (before, a), (after, b), &of)?;
            let there = &taken.state;
            // Beyond the ends of its features a contact has no gap.
            let is_there = match sought {
                Sought::Gap(contact) => world.is_there(contact, there.t, &there.q),
                Sought::End(..) => true,
            };
            is_there.then_some((h, taken, sought))
        });
        let Some((h, taken, sought)) = first else {
            return Shown::Nothing;
        };
        let closed = match sought {
            Sought::Gap(contact) => vec![contact],
            Sought::End(..) => Vec::new(),
        };
        // Nothing else was met before.
        let while_before = BEFORE * (after - before);
        let just = just_before(&taken.state, while_before);
        if self.met(&just) {
            Shown::Earlier(h - while_before, just)
        } else {
            Shown::Root(taken, closed)
        }
    }

    /// The last root before a time of a function that is negative then, or the first after it of one that is nearly 0, if it is near;
    /// just after it.
    fn last_root(
        &self,
        after: f64,
        end: &State,
        value: &dyn Fn(&State) -> f64,
    ) -> Option<(f64, Taken)> {
        let world = self.world();
        let far = |to: &State| world.reach(&(&to.q - &end.q));
        let (mut below, mut above, mut back) = (after, after, LOCATED * after);
        // Spaces report contacts a little early.
        let mut early = value(end) >= 0.0;
        while early {
            below = after + back;
            back *= 2.0;
            let to = self.at(below)?.state;
            if far(&to) > EARLY * world.size() {
                return None;
            }
            early = value(&to) >= 0.0;
        }
        while below <= after {
            above = (above - back).max(0.0);
            back *= 2.0;
            // The polynomial shows whether to look farther back.
            let about = self.rough(above);
            if above > 0.0
                && value(&about) < -SEEN * world.size()
                && far(&about) <= NEAR_EVENT * world.size()
            {
                below = above;
                continue;
            }
            let to = self.at(above)?.state;
            if value(&to) >= 0.0 {
                break;
            }
            if above == 0.0 || far(&to) > NEAR_EVENT * world.size() {
                return None;
            }
            below = above;
        }
        let of = |h: f64| self.at(h).map(|to| value(&to.state));
        let below = root((above, of(above)?), (below, of(below)?), of)?;
        Some((below, self.at(below)?))
    }
}

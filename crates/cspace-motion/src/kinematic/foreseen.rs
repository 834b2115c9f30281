//! Search for the event within a part of a step, by the functions that change their sign in it.
//!
//! ```text
//!   ----+------------------ r ----------------+---->  time
//!     before         r − δ | r + δ          after
//!   it goes on      it does, it does not      it does not
//! ```
//!
//! Closing contacts, features that come to their end, and contacts that are no longer pressed have functions whose
//! first root r is computed in some steps. A check just before and just after r confirms the event; if it fails, its
//! result shortens the part of the step that is searched.

use crate::contact::{Bound, ends, limits};
use crate::root::root;

use super::between::Between;
use super::check::{Obstacle, PULL};
use super::flow::Arrived;

/// Distance from a root at which the motion is checked, as a share of the step: more than the error of roots, and less
/// than the error of contacts.
const BESIDE: f64 = 1e-10;
/// Number of checks after a root, each farther by [`FARTHER`]: patches reach beyond the ends of features by the error
/// of contacts.
const TRIES: usize = 3;
const FARTHER: f64 = 100.0;
/// Contacts close within this multiple of a part's displacement: both parts may move in three coordinates each.
const NEAR: f64 = 6.0;

/// Largest number of obstacles examined, each of which is met before the last.
const MOST_LOOKS: usize = 16;
/// The rate of a function is that of the cubic over this share of the times between which its root is looked for.
const SLOPE: f64 = 1e-3;
/// Largest number of secant steps for a root of the cubic.
const MENDED: usize = 6;
/// A root is one that is right to this share of the times between which it is looked for.
const RIGHT: f64 = 1e-12;

/// Result of the search in a part of a step.
// There is one at a time.
#[allow(clippy::large_enum_variant)]
pub(super) enum Seen {
    /// The event happens at this time, for this bound if one closes.
    At(f64, What),
    /// The event happens between these times.
    Within([f64; 2]),
}

/// A function that is positive until something happens.
// There are a few at a time, most of them contacts.
#[allow(clippy::large_enum_variant)]
#[derive(Debug, Clone, Copy)]
pub(super) enum What {
    /// Closing of an open bound.
    Closes(Bound),
    /// End of a held bound, by its number, at an end of its features, by its number.
    Ends(usize, usize),
    /// Opening of a held bound, by its number: its pressure falls to 0.
    Opens(usize),
}

/// A time, with the configuration and velocity there.
type Place = (f64, Arrived);

impl Between<'_, '_> {
    /// Time at which the step cannot go on, given the obstacle met at its end.
    pub(super) fn seen(
        &self,
        mut met: Option<Obstacle>,
        h: f64,
        stops: &mut dyn FnMut(f64, &Arrived) -> Option<Obstacle>,
    ) -> Seen {
        let mut before = self.from.clone();
        let Some(mut after) = self.to.clone() else {
            return Seen::Within([before.0; 2]);
        };
        // An earlier obstacle belongs to another pair: each pair is examined once or twice.
        for _ in 0..MOST_LOOKS {
            let first = met.and_then(|met| self.first(met, [&before, &after]));
            let Some((what, at)) = first else {
                break;
            };
            let mut beside = BESIDE * h;
            if at - beside > before.0 {
                let Some(just) = self.at(at - beside) else {
                    break;
                };
                met = stops(at - beside, &just);
                if met.is_some() {
                    after = (at - beside, just);
                    continue;
                }
                before = (at - beside, just);
            }
            for _ in 0..TRIES {
                if at + beside >= after.0 {
                    return Seen::At(at, what);
                }
                match self.at(at + beside) {
                    Some(to) if stops(at + beside, &to).is_none() => before = (at + beside, to),
                    _ => return Seen::At(at, what),
                }
                beside *= FARTHER;
            }
            break;
        }
        Seen::Within([before.0, after.0])
    }

    /// Estimated time of the obstacle met at the end.
    pub(super) fn supposed(&self, met: Obstacle) -> Option<f64> {
        let found = self.first(met, [&self.from, self.to.as_ref()?])?;
        Some(found.1)
    }

    /// Function of the obstacle that first vanishes between two times, and the time.
    fn first(&self, met: Obstacle, ends: [&Place; 2]) -> Option<(What, f64)> {
        let mut all: Vec<(What, [f64; 2])> = Vec::new();
        self.functions(met, ends, &mut |what, values| {
            if values[0] > 0.0 && values[1] < 0.0 {
                all.push((what, values));
            }
        });
        let share = |[a, b]: [f64; 2]| a / (a - b);
        all.sort_by(|a, b| share(a.1).total_cmp(&share(b.1)));
        all.into_iter().find_map(|(what, values)| {
            let [begin, end] = [0, 1].map(|k| (ends[k].0, values[k]));
            let at = self.root(what, begin, end)?;
            self.is_there(what, at).then_some((what, at))
        })
    }

    /// Functions of the obstacle, with their values at two times.
    fn functions(
        &self,
        met: Obstacle,
        [before, after]: [&Place; 2],
        add: &mut dyn FnMut(What, [f64; 2]),
    ) {
        let flow = self.flow;
        let states = [&before.1, &after.1];
        let of_bound =
            |bound: &Bound| states.map(|at| bound.function(flow.system, flow.pairs, &at.q).value);
        let is_open = |bound: &Bound| flow.held.iter().all(|held| !bound.is_same(held));
        match met {
            Obstacle::Pull => {
                for i in (0..flow.held.len()).filter(|&i| !flow.held[i].is_brake()) {
                    add(What::Opens(i), states.map(|at| push(at, i)));
                }
            }
            Obstacle::Limit => {
                for (bound, _) in limits(flow.system, &after.1.q) {
                    if is_open(&bound) {
                        add(What::Closes(bound), of_bound(&bound));
                    }
                }
            }
            Obstacle::Pair(index) => {
                let pair = &flow.pairs.list()[index];
                let near = NEAR * flow.system.moved(&before.1.q, &after.1.q);
                let touches = pair.touches(index, flow.system, &after.1.q, near.max(pair.touch));
                for bound in touches.unwrap_or_default().into_iter().map(Bound::Contact) {
                    if is_open(&bound) {
                        add(What::Closes(bound), of_bound(&bound));
                    }
                }
                for (i, bound) in flow.held.iter().enumerate() {
                    if let Bound::Contact(touch) = bound
                        && touch.pair == index
                    {
                        let [a, b] = states.map(|at| ends(pair, touch, flow.system, &at.q));
                        for (k, (a, b)) in a.into_iter().zip(b).enumerate() {
                            add(What::Ends(i, k), [a, b]);
                        }
                    }
                }
            }
            Obstacle::Friction | Obstacle::Error => {}
        }
    }

    /// Time at which a function vanishes between two others: on the cubic approximately; where contacts hold, by
    /// secants.
    fn root(&self, what: What, begin: (f64, f64), end: (f64, f64)) -> Option<f64> {
        let rough = |h: f64| self.value(what, h, false);
        let exact = |h: f64| self.value(what, h, true);
        let mended = || {
            let about = root(begin, end, rough)?;
            let side = SLOPE * (end.0 - begin.0);
            let around = [(about - side).max(begin.0), (about + side).min(end.0)];
            let [a, b] = [rough(around[0])?, rough(around[1])?];
            let mut slope = (b - a) / (around[1] - around[0]);
            let (mut h, mut f) = (about, exact(about)?);
            for _ in 0..MENDED {
                let next = h - f / slope;
                if !(slope < 0.0 && next > begin.0 && next < end.0) {
                    return None;
                }
                if next == h {
                    break;
                }
                let g = exact(next)?;
                if g.abs() >= f.abs() {
                    break;
                }
                let secant = (g - f) / (next - h);
                if secant.is_finite() && secant < 0.0 {
                    slope = secant;
                }
                (h, f) = (next, g);
            }
            // It is over there, to rounding.
            let rest = f / slope;
            (rest.abs() <= RIGHT * (end.0 - begin.0)).then_some(h - rest.min(0.0))
        };
        mended().or_else(|| root(begin, end, exact))
    }

    /// The value of a function at a time, where contacts hold or on the cubic itself.
    fn value(&self, what: What, h: f64, held: bool) -> Option<f64> {
        let flow = self.flow;
        let q = match self.near(h) {
            Some(q) if !held => q,
            _ => match what {
                What::Opens(i) => return Some(push(&self.at(h)?, i)),
                _ => self.placed(h)?,
            },
        };
        match what {
            What::Closes(bound) => Some(bound.function(flow.system, flow.pairs, &q).value),
            What::Ends(i, k) => match flow.held.get(i)? {
                Bound::Contact(touch) => {
                    let pair = &flow.pairs.list()[touch.pair];
                    ends(pair, touch, flow.system, &q).get(k).copied()
                }
                Bound::Limit { .. } | Bound::Brake { .. } => None,
            },
            What::Opens(i) => Some(push(&flow.moving(h, q)?, i)),
        }
    }

    /// Whether a bound that closes is a contact there: contact functions vanish beyond the ends of features, too.
    fn is_there(&self, what: What, h: f64) -> bool {
        let flow = self.flow;
        let What::Closes(Bound::Contact(touch)) = what else {
            return true;
        };
        let pair = &flow.pairs.list()[touch.pair];
        self.placed(h).is_some_and(|q| {
            let touches = pair.touches(touch.pair, flow.system, &q, pair.touch);
            touches.is_ok_and(|all| all.iter().any(|t| t.features == touch.features))
        })
    }
}

/// Force on a bound, less the threshold of a pull.
fn push(at: &Arrived, bound: usize) -> f64 {
    let push = at.velocity.pushes.get(bound).copied();
    push.map_or(0.0, |push| push + PULL * at.velocity.speed)
}

//! Location of an event within a step.
//!
//! A meeting in a step is located by bisection, which is as accurate as contacts are in their spaces, some 1e-9 of the
//! parts' size. Then the function that vanishes there is searched for, a contact's or that of an end of a feature, and
//! its root is computed to rounding.

use crate::contact::{
    Bound, PAST_END, SAME_PLACE, Watch, ends, nearly_touching, pinched, touching,
};

use super::between::Between;
use super::check::{Obstacle, last_obstacle, obstacle};
use super::flow::{Arrived, Flow};
use super::foreseen::{Seen, What};

/// Events are located to this share of a step.
const LOCATED: f64 = 1e-13;
/// Between times within this share of a step of each other the motion is a cubic, to the fourth power of it.
const CLOSE: f64 = 1e-3;
/// Largest displacement before an event, relative to the size of the mechanism, within which the root of a function is
/// searched. Where edges join smoothly, contacts separate with the square of the displacement, and are distinguished
/// late.
const NEAR_EVENT: f64 = 1e-4;

/// Point at which a step has to stop.
#[derive(Debug)]
pub(crate) struct Stop {
    /// Time from the beginning of the step.
    pub(crate) after: f64,
    /// The configuration just after it.
    pub(crate) q: Vec<f64>,
    /// Bounds that touch there, or at which the step has to stop.
    pub(crate) bounds: Vec<Bound>,
}

/// The first event within a step of length `h` that met something.
pub(crate) fn first_event<'a>(flow: &Flow<'a>, h: f64, watch: &mut Watch<'a>) -> Stop {
    let last = |to: &Arrived, watch: &Watch<'a>| last_obstacle(watch, flow, to);
    let start = Arrived {
        q: flow.q.clone(),
        velocity: flow.velocity.clone(),
        error: 0.0,
    };
    let mut part = Between {
        flow,
        from: (0.0, start),
        to: flow.after(h).map(|to| (h, to)),
    };
    let met = (part.to.as_ref()).and_then(|(_, to)| last(to, watch));
    let mut stops = |h: f64, to: &Arrived| {
        if to.excess(flow.system) > 1.0 {
            Some(Obstacle::Error)
        } else {
            obstacle(watch, flow, h, to)
        }
    };
    let mut around = [0.0, h];
    let mut seen = Seen::Within(around);
    // Where contacts lead, the cubic is the motion: there the contacts hold.
    if part.is_led() {
        seen = part.seen(met, h, &mut stops);
    } else {
        // The cubic gives the approximate time; between two times as close as these another cubic is as good as the
        // motion.
        let near = 0.5 * CLOSE * h;
        let supposed = met.and_then(|met| part.supposed(met));
        let about = supposed.map(|at| [(at - near).max(0.0), (at + near).min(h)]);
        let mut close = about.and_then(|about| closely(flow, about, &mut stops));
        if close.is_none() {
            let about = part.halved(around, CLOSE * h, &mut |h, to| stops(h, to).is_none());
            close = closely(flow, about, &mut stops);
        }
        part.to = None;
        if let Some((closer, until, met)) = close {
            part = closer;
            around = [part.from.0, until];
            seen = part.seen(met, h, &mut stops);
        }
    }
    match seen {
        Seen::At(after, what) => {
            if let Some(stop) = stop_at(flow, after, what) {
                return stop;
            }
        }
        Seen::Within(narrower) if part.to.is_some() => around = narrower,
        Seen::Within(_) => {}
    }
    let [before, after] = part.halved(around, LOCATED * h, &mut |h, to| stops(h, to).is_none());
    // Held bounds are still closed, though a contact may have come to the end of its features: where a side comes to
    // lie on another, one corner of it was held, and now both corners are to be held.
    let mut bounds = flow.held.clone();
    if let Some(end) = flow.after(after) {
        add(&mut bounds, touching(flow.system, flow.pairs, &end.q));
        let mut found = root(&part, after, &end, &bounds);
        if found.is_none() {
            add(&mut bounds, pinched(flow.system, flow.pairs, &end.q));
            found = root(&part, after, &end, &bounds);
        }
        if found.is_none() {
            // On a steep wedge a contact closes by a multiple of what is seen along the other.
            let near = SAME_PLACE * flow.system.size();
            let closing = nearly_touching(flow.system, flow.pairs, &end.q, near);
            let reached = closing.into_iter().filter_map(|bound| {
                let (at, to) = root(&part, after, &end, &[bound])?;
                let there = touching(flow.system, flow.pairs, &to.q);
                there
                    .iter()
                    .any(|b| b.is_same(&bound))
                    .then_some((bound, at, to))
            });
            if let Some((bound, at, to)) = reached.min_by(|a, b| a.1.total_cmp(&b.1)) {
                add(&mut bounds, vec![bound]);
                found = Some((at, to));
            }
        }
        if let Some((after, to)) = found {
            let q = to.q;
            return Stop { after, q, bounds };
        }
    }
    // Where contacts cannot hold on, the configuration is the last at which they do.
    let to = flow.after(after).or_else(|| flow.after(before));
    let q = to.map_or_else(|| flow.q.clone(), |to| to.q);
    Stop { after, q, bounds }
}

/// Locates the event between two times, if the motion goes on at the first and does not at the second: the remaining
/// interval, and the obstacle.
fn closely<'f, 'a>(
    flow: &'f Flow<'a>,
    about: [f64; 2],
    stops: &mut dyn FnMut(f64, &Arrived) -> Option<Obstacle>,
) -> Option<(Between<'f, 'a>, f64, Option<Obstacle>)> {
    let [before, after] = about;
    let from = flow.after(before)?;
    if stops(before, &from).is_some() {
        return None;
    }
    let to = flow.after(after);
    let met = match &to {
        Some(to) => Some(stops(after, to)?),
        None => None,
    };
    let part = Between {
        flow,
        from: (before, from),
        to: to.map(|to| (after, to)),
    };
    Some((part, after, met))
}

/// The stop where a function comes to 0.
fn stop_at(flow: &Flow<'_>, after: f64, what: What) -> Option<Stop> {
    let (system, pairs) = (flow.system, flow.pairs);
    let q = flow.after(after)?.q;
    let mut bounds = flow.held.clone();
    add(&mut bounds, touching(system, pairs, &q));
    match what {
        What::Closes(bound) => add(&mut bounds, vec![bound]),
        What::Ends(..) => {}
        What::Opens(_) => add(&mut bounds, pinched(system, pairs, &q)),
    }
    Some(Stop { after, q, bounds })
}

/// Adds those that are not there.
pub(super) fn add(bounds: &mut Vec<Bound>, more: Vec<Bound>) {
    for bound in more {
        if bounds.iter().all(|other| !bound.is_same(other)) {
            bounds.push(bound);
        }
    }
}

/// The first root, near a time, of a function that is negative then.
fn root(
    part: &Between<'_, '_>,
    after: f64,
    end: &Arrived,
    bounds: &[Bound],
) -> Option<(f64, Arrived)> {
    let flow = part.flow;
    let closing = (bounds.iter())
        .filter(|b| flow.held.iter().all(|other| !b.is_same(other)))
        .map(|b| {
            let value = |q: &[f64]| b.function(flow.system, flow.pairs, q).value;
            root_of(part, after, end, value)
        });
    let held = flow.held.iter().filter_map(|b| match b {
        Bound::Contact(touch) => Some(touch),
        Bound::Limit { .. } | Bound::Brake { .. } => None,
    });
    let ending = held.flat_map(|touch| {
        let pair = &flow.pairs.list()[touch.pair];
        let all = ends(pair, touch, flow.system, &end.q);
        (0..all.len()).map(move |k| {
            // At the end to rounding all the time, as where sides lie on each other, is no coming to it.
            if all[k] > -PAST_END {
                return None;
            }
            let value = |q: &[f64]| ends(pair, touch, flow.system, q)[k];
            root_of(part, after, end, value)
        })
    });
    let first = closing.chain(ending).flatten().min_by(f64::total_cmp)?;
    Some((first, flow.after(first)?))
}

/// The last root before a time of a function that is negative then; just after it.
fn root_of(
    part: &Between<'_, '_>,
    after: f64,
    end: &Arrived,
    value: impl Fn(&[f64]) -> f64,
) -> Option<f64> {
    if value(&end.q) >= 0.0 {
        return None;
    }
    let system = part.flow.system;
    let reach = NEAR_EVENT * system.size();
    let (mut below, mut above, mut back) = ((after, value(&end.q)), after, LOCATED * after);
    let first = loop {
        above = (above - back).max(0.0);
        back *= 2.0;
        let to = part.at(above)?;
        let found = value(&to.q);
        if found >= 0.0 {
            break (above, found);
        }
        if above == 0.0 || system.moved(&to.q, &end.q) > reach {
            return None;
        }
        below = (above, found);
    };
    crate::root::root(first, below, |h| Some(value(&part.at(h)?.q)))
}

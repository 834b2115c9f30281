//! When something happens within a step.
//!
//! What a step met is found by halving it. That tells the event as well as contacts are told by their spaces, to some 1e-9 of
//! the parts' size. Then the function is looked for that vanishes there, a contact's or that of an end of a feature, and its
//! root is found to rounding.

use crate::contact::{Bound, PAST_END, Watch, ends, pinched, touching};

use super::check::goes_on;
use super::flow::{Arrived, Flow};

/// Events are located to this share of a step.
const LOCATED: f64 = 1e-13;
/// A function is looked for whose root is not farther back than parts move by this, relative to the size of the mechanism.
const NEAR_EVENT: f64 = 1e-6;

/// Where a step has to stop.
#[derive(Debug)]
pub(crate) struct Stop {
    /// How long it takes to get there.
    pub(crate) after: f64,
    /// The configuration just after it.
    pub(crate) q: Vec<f64>,
    /// What touches there, or where it was seen that the step has to stop.
    pub(crate) bounds: Vec<Bound>,
}

/// The first event within a step of length `h` that met something.
pub(crate) fn first_event<'a>(flow: &Flow<'a>, h: f64, watch: &mut Watch<'a>) -> Stop {
    let (mut before, mut after) = (0.0, h);
    let mut last = None;
    while after - before > LOCATED * h {
        let middle = 0.5 * (before + after);
        if middle <= before || middle >= after {
            break;
        }
        match flow.after(middle) {
            Some(to) if to.excess(flow.system) <= 1.0 && goes_on(watch, flow, middle, &to) => {
                before = middle;
            }
            found => {
                after = middle;
                last = found;
            }
        }
    }
    // What was held is closed still, though it may have come to the end of where it touches: where a side comes to lie on
    // another, one corner of it was held, and both are to be.
    let mut bounds = flow.held.clone();
    if let Some(end) = flow.after(after) {
        add(&mut bounds, touching(flow.system, flow.pairs, &end.q));
        let mut found = root(flow, after, &end, &bounds);
        if found.is_none() {
            add(&mut bounds, pinched(flow.system, flow.pairs, &end.q));
            found = root(flow, after, &end, &bounds);
        }
        if let Some((after, to)) = found {
            let q = to.q;
            return Stop { after, q, bounds };
        }
    }
    // Where contacts cannot hold on, the configuration is the last at which they do.
    let to = last
        .or_else(|| flow.after(after))
        .or_else(|| flow.after(before));
    let q = to.map_or_else(|| flow.q.clone(), |to| to.q);
    Stop { after, q, bounds }
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
fn root(flow: &Flow<'_>, after: f64, end: &Arrived, bounds: &[Bound]) -> Option<(f64, Arrived)> {
    let closing = (bounds.iter())
        .filter(|b| flow.held.iter().all(|other| !b.is_same(other)))
        .map(|b| {
            let value = |q: &[f64]| b.function(flow.system, flow.pairs, q).value;
            root_of(flow, after, end, value)
        });
    let held = flow.held.iter().filter_map(|b| match b {
        Bound::Contact(touch) => Some(touch),
        Bound::Limit { .. } => None,
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
            root_of(flow, after, end, value)
        })
    });
    closing
        .chain(ending)
        .flatten()
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The last root before a time of a function that is negative then; just after it.
fn root_of(
    flow: &Flow<'_>,
    after: f64,
    end: &Arrived,
    value: impl Fn(&[f64]) -> f64,
) -> Option<(f64, Arrived)> {
    if value(&end.q) >= 0.0 {
        return None;
    }
    let reach = NEAR_EVENT * flow.system.size();
    let at = |h: f64| flow.after(h).map(|to| (value(&to.q), to));
    let (mut below, mut above, mut back) = (after, after, LOCATED * after);
    loop {
        above = (above - back).max(0.0);
        back *= 2.0;
        let (found, to) = at(above)?;
        if found >= 0.0 {
            break;
        }
        if above == 0.0 || flow.system.moved(&to.q, &end.q) > reach {
            return None;
        }
        below = above;
    }
    while below - above > LOCATED * after {
        let middle = 0.5 * (above + below);
        if middle <= above || middle >= below {
            break;
        }
        if at(middle)?.0 >= 0.0 {
            above = middle;
        } else {
            below = middle;
        }
    }
    Some((below, at(below)?.1))
}

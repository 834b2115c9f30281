//! Events of contacts that close and open.

use crate::contact::{Bound, SAME_PLACE};
use crate::pairs::{Grip, Pairs};
use crate::record::{Event, EventKind};
use crate::system::System;

use super::flow::Flow;

/// Largest opening in a trial, relative to the size of the mechanism, with which an unloaded contact counts as closed:
/// rounding. A contact that opens with the square of the time opens by a hundred times that.
const STAYS: f64 = 1e-14;

/// Features slide if they do so by more than this share of the largest rate.
const SLIDES: f64 = 1e-9;

/// Contacts and limits reported as closed.
#[derive(Debug, Clone, Default)]
pub(crate) struct Told {
    list: Vec<Seen>,
}

/// A contact or limit, where it is, and whether its features slide against friction; `None` without friction.
type Seen = (Bound, Option<cspace::Point>, Option<bool>);

impl Told {
    /// Changes since the last call, where `bounds` are those that are reached and the motion goes on to `next` a very
    /// little while later.
    pub(crate) fn update(
        &mut self,
        pairs: &Pairs,
        bounds: &[Bound],
        flow: &Flow<'_>,
        next: &[f64],
    ) -> Vec<Event> {
        let (system, q) = (flow.system, &flow.q);
        let place = |bound: &Bound| bound.place(system, pairs, q);
        let opens = STAYS * system.size();
        let stays = |bound: &Bound| {
            let value = |q: &[f64]| bound.function(system, pairs, q).value;
            value(next) - value(q) <= opens
        };
        let holds = |bound: &Bound| flow.held.iter().any(|other| bound.is_same(other));
        let fastest = system.speed(&flow.velocity.rates);
        let slides = |bound: &Bound| match bound {
            Bound::Contact(touch) if touch.grip != Grip::Smooth => {
                let rate = pairs.list()[touch.pair].sliding(touch, system, q);
                Some(rate.rate(&flow.velocity.rates).abs() > SLIDES * fastest)
            }
            _ => None,
        };
        let now: Vec<Seen> = (flow.held.iter())
            .filter(|b| !b.is_brake())
            .chain(
                bounds
                    .iter()
                    .filter(|b| !b.is_brake() && !holds(b) && stays(b)),
            )
            .map(|b| (*b, place(b), slides(b)))
            .collect();
        let near = SAME_PLACE * system.size();
        let same = |a: &Seen, b: &Seen| {
            let (Bound::Contact(s), Bound::Contact(t)) = (a.0, b.0) else {
                return a.0 == b.0;
            };
            let close = |(p, q): (cspace::Point, cspace::Point)| p.distance(q) <= near;
            s.pair == t.pair && (s.features == t.features || a.1.zip(b.1).is_some_and(close))
        };
        // Earlier contacts are compared at their present positions.
        let before = self.list.iter().map(|(b, _, s)| (*b, place(b), *s));
        let before: Vec<Seen> = before.collect();
        let mut events = Vec::new();
        for old in before.iter().filter(|o| now.iter().all(|n| !same(o, n))) {
            events.push(event(system, pairs, flow.time, old, EventKind::Release));
        }
        let mut told: Vec<Seen> = Vec::new();
        for new in &now {
            if told.iter().any(|t| same(t, new)) {
                continue;
            }
            let old = before.iter().find(|o| same(o, new));
            let kind = match (old, new.0) {
                (None, Bound::Contact(_)) => Some(EventKind::Touch),
                (None, _) => Some(EventKind::Limit),
                (Some(old), _) => match (old.2, new.2) {
                    (Some(true), Some(false)) => Some(EventKind::Stick),
                    (Some(false), Some(true)) => Some(EventKind::Slip),
                    _ => None,
                },
            };
            if let Some(kind) = kind {
                events.push(event(system, pairs, flow.time, new, kind));
            }
            told.push(*new);
        }
        self.list = told;
        events
    }
}

fn event(system: &System, pairs: &Pairs, t: f64, (bound, at, _): &Seen, kind: EventKind) -> Event {
    let at = at.filter(|p| p.is_finite()).map(|p| [p.x, p.y]);
    let what = crate::contact::named(system, pairs, bound);
    Event::new(t, kind, what, at)
}

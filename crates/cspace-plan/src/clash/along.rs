//! Two parts over a motion.

use crate::legs::Coords;

use super::answer::{Clash, State};
use super::pair::Pair;

/// State of two parts over a motion: the worst over its samples and the intervals between them; none if they are clear
/// by `within` or more all along.
pub(super) fn along(
    pair: &Pair<'_>,
    way: impl Iterator<Item = (f64, [Coords; 2])>,
    within: f64,
) -> Option<Clash> {
    let mut worst: Option<Clash> = None;
    let mut limit = within;
    let mut before: Option<(f64, [Coords; 2], bool)> = None;
    let mut take = |found: Option<Clash>, limit: &mut f64| {
        let Some(found) = found else { return };
        if let Some(gap) = found.gap {
            *limit = limit.min(gap);
        }
        if worst.as_ref().is_none_or(|w| is_worse(&found, w)) {
            worst = Some(found);
        }
    };
    for (time, at) in way {
        let here = pair.there(at, limit);
        let is_met = here.as_ref().is_some_and(|c| c.state != State::Clear);
        take(
            here.map(|c| Clash {
                time: Some(time),
                ..c
            }),
            &mut limit,
        );
        // Where the parts touch or overlap at a sample, what is beside it is no nearer.
        if let Some((earlier, from, false)) = before
            && !is_met
        {
            take(
                on_the_way(pair, [from, at], [earlier, time], limit),
                &mut limit,
            );
        }
        before = Some((time, at, is_met));
    }
    worst
}

/// Where two parts first touch over a motion; none if they never do.
pub(super) fn first(
    pair: &Pair<'_>,
    way: impl Iterator<Item = (f64, [Coords; 2])>,
) -> Option<Clash> {
    let mut before: Option<(f64, [Coords; 2])> = None;
    for (time, at) in way {
        let met = (before)
            .and_then(|(earlier, from)| on_the_way(pair, [from, at], [earlier, time], pair.touch))
            .filter(|c| c.state == State::Meets);
        let here = || {
            pair.there(at, pair.touch).map(|c| Clash {
                time: Some(time),
                ..c
            })
        };
        if let Some(found) = met.or_else(here) {
            return Some(found);
        }
        before = Some((time, at));
    }
    None
}

/// State of two parts between two samples at which they are apart, if they come nearer than a limit.
fn on_the_way(
    pair: &Pair<'_>,
    [from, to]: [[Coords; 2]; 2],
    [earlier, later]: [f64; 2],
    limit: f64,
) -> Option<Clash> {
    let between = pair.between(from, to);
    let least = between.least_below(limit.max(pair.touch));
    if !least.distance.is_finite() {
        return None;
    }
    let is_met = least.distance <= pair.touch;
    let (features, points) = between.at(least.time).nearest().unzip();
    Some(Clash {
        gap: Some(if is_met { 0.0 } else { least.distance }),
        features,
        points,
        time: Some(earlier + (later - earlier) * least.time),
        ..pair.clash(if is_met { State::Meets } else { State::Clear })
    })
}

/// Whether one finding is worse than another, which was found before it.
fn is_worse(a: &Clash, b: &Clash) -> bool {
    let deeper = |c: &Clash| c.depth.map_or(f64::INFINITY, |d| d);
    match a.state.cmp(&b.state) {
        core::cmp::Ordering::Less => true,
        core::cmp::Ordering::Greater => false,
        core::cmp::Ordering::Equal => match a.state {
            State::Overlap => deeper(a) > deeper(b),
            _ => a.gap < b.gap,
        },
    }
}

//! Contacts that are one circle at every orientation, and when their curves lie on each other.

use core::f64::consts::TAU;

use crate::feature::Outline;
use crate::feature::tolerance::SAME_CARRIER;

use super::sheet::Sheet;
use super::sums::{SLIVER, equal_sums};

/// Two sheets whose curves are partly one, and from when to when (radians).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Doubled {
    pub(crate) first: u32,
    pub(crate) second: u32,
    pub(crate) lo: f64,
    pub(crate) hi: f64,
}

/// All of them, of sheets sorted by fixed and moving feature; `None` if there are too many to list.
///
/// Where one of the two ends before the other, the curve that continues it may lie behind the other, and no crossing tells.
pub(super) fn doubled(fixed: &Outline, moving: &Outline, sheets: &[Sheet]) -> Option<Vec<Doubled>> {
    let of = |fixed: u32, moving: u32| {
        let from = sheets.partition_point(|s| (s.fixed, s.moving) < (fixed, moving));
        (from as u32..)
            .zip(&sheets[from..])
            .take_while(move |(_, s)| (s.fixed, s.moving) == (fixed, moving))
    };
    let mut found = Vec::new();
    for sum in equal_sums(fixed, moving)? {
        for (first, f) in of(sum.fixed.0, sum.moving.0) {
            for (second, g) in of(sum.fixed.1, sum.moving.1) {
                if (f.radius - g.radius).abs() > SAME_CARRIER || !f.same_circle(g) {
                    continue;
                }
                found.extend(shared(f, g).map(|(lo, hi)| Doubled {
                    first,
                    second,
                    lo,
                    hi,
                }));
            }
        }
    }
    Some(found)
}

/// When arcs of one circle have more in common than an end.
///
/// Both ends of both turn with the moving part or not at all, so that each condition is linear.
fn shared<'a>(f: &'a Sheet, g: &'a Sheet) -> impl Iterator<Item = (f64, f64)> + 'a {
    let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
    let middle = 0.5 * (lo + hi);
    let ends = |s: &'a Sheet| {
        let (a, b) = (&s.start_angle, &s.end_angle);
        if a.at(middle) <= b.at(middle) {
            (a, b)
        } else {
            (b, a)
        }
    };
    let (f, g) = (ends(f), ends(g));
    let turns = ((f.0.at(middle) - g.0.at(middle)) / TAU).round();
    (-2..=2).filter_map(move |k| {
        let turned = TAU * (turns + f64::from(k));
        let f_before_end = |t: f64| g.1.at(t) + turned - f.0.at(t) - SLIVER;
        let g_before_end = |t: f64| f.1.at(t) - g.0.at(t) - turned - SLIVER;
        let range = positive((lo, hi), f_before_end)?;
        positive(range, g_before_end)
    })
}

/// Where in a range a linear function is positive.
fn positive((lo, hi): (f64, f64), value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    if lo >= hi {
        return None;
    }
    let (a, b) = (value(lo), value(hi));
    let zero = lo + (hi - lo) * (a / (a - b));
    match (a > 0.0, b > 0.0) {
        (true, true) => Some((lo, hi)),
        (true, false) => Some((lo, zero)),
        (false, true) => Some((zero, hi)),
        (false, false) => None,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;

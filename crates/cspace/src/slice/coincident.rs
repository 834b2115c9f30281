//! Contacts that are one circle at every orientation, and when their curves lie on each other.
//!
//! Where one of the two ends before the other, the curve that continues it may lie behind the other, and no crossing tells.

use core::f64::consts::TAU;

use crate::contact::{Geometry, Sheet};
use crate::feature::equal_sums;
use crate::feature::tolerance::{COMMON_NORMALS, SAME_CARRIER};

/// Two sheets whose curves are partly one, and from when to when (radians).
#[derive(Debug, Clone, Copy, PartialEq)]
struct Coincidence {
    first: u32,
    second: u32,
    lo: f64,
    hi: f64,
}

/// All of them; `None` if there are too many to list.
#[derive(Debug)]
pub(super) struct Coincidences(Option<Vec<Coincidence>>);

impl Coincidences {
    /// Of a pair, whose sheets are sorted by fixed and moving feature.
    pub(super) fn new(geometry: &Geometry) -> Self {
        let sheets = &geometry.contacts.sheets;
        let of = |fixed: u32, moving: u32| {
            let from = sheets.partition_point(|s| (s.fixed, s.moving) < (fixed, moving));
            (from as u32..)
                .zip(&sheets[from..])
                .take_while(move |(_, s)| (s.fixed, s.moving) == (fixed, moving))
        };
        let found = equal_sums(&geometry.fixed, &geometry.moving).map(|sums| {
            let mut found = Vec::new();
            for sum in sums {
                for (first, f) in of(sum.fixed.0, sum.moving.0) {
                    for (second, g) in of(sum.fixed.1, sum.moving.1) {
                        let apart = (f.locus.radius - g.locus.radius).abs() > SAME_CARRIER;
                        let (c, d) = (f.locus.through, g.locus.through);
                        let off = (c.u - d.u).length().max((c.w - d.w).length());
                        if apart || off > SAME_CARRIER {
                            continue;
                        }
                        found.extend(shared(f, g).map(|(lo, hi)| Coincidence {
                            first,
                            second,
                            lo,
                            hi,
                        }));
                    }
                }
            }
            found
        });
        Self(found)
    }

    /// Whether the curves of two sheets lie on each other at an orientation, both of which are open; or that is not known.
    pub(super) fn any(&self, theta: f64, open: impl Fn(u32) -> bool) -> bool {
        self.0.as_ref().is_none_or(|all| {
            all.iter()
                .any(|c| c.lo <= theta && theta <= c.hi && open(c.first) && open(c.second))
        })
    }
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
        let f_before_end = |t: f64| g.1.at(t) + turned - f.0.at(t) - COMMON_NORMALS;
        let g_before_end = |t: f64| f.1.at(t) - g.0.at(t) - turned - COMMON_NORMALS;
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

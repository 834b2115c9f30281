//! Straight lines between configurations of a pair.

use cspace::pair::PairCrossing;
use cspace::{Configuration, Coordinates, PatchId};

use crate::pairs::Touch;

/// Gap of a contact at a share of the straight line between two configurations; −∞ if it cannot be computed.
pub(super) fn straight_gap(touch: &Touch, ends: [Coordinates; 2], share: f64) -> f64 {
    let there = between(ends, share);
    let gap = there.and_then(|there| touch.contact().value(there).ok());
    gap.unwrap_or(f64::NEG_INFINITY)
}

/// Configuration at a share of the straight line between two.
pub(super) fn between([a, b]: [Coordinates; 2], share: f64) -> Option<Coordinates> {
    combined(a, b, |a, b| a + share * (b - a))
}

/// Control points of a cubic, from its two ends and its points at a third and two thirds.
pub(super) fn control_points(
    [a, b]: [Coordinates; 2],
    [p, r]: [Coordinates; 2],
) -> Option<[Coordinates; 4]> {
    let of = |a: Coordinates, p: Coordinates, r: Coordinates, b: Coordinates| {
        // (18 p − 5 a − 9 r + 2 b) / 6
        let ends = combined(a, b, |a, b| 2.0 * b - 5.0 * a)?;
        let inner = combined(p, r, |p, r| 18.0 * p - 9.0 * r)?;
        combined(ends, inner, |ends, inner| (ends + inner) / 6.0)
    };
    Some([a, of(a, p, r, b)?, of(b, r, p, a)?, b])
}

/// Rates of a straight motion that takes one second.
pub(super) fn difference(a: Coordinates, b: Coordinates) -> Option<Coordinates> {
    combined(a, b, |a, b| b - a)
}

/// Applies a function to each two corresponding coordinates; `None` if the coordinates are of different classes.
fn combined(a: Coordinates, b: Coordinates, of: impl Fn(f64, f64) -> f64) -> Option<Coordinates> {
    match (a, b) {
        (Coordinates::Planar(a), Coordinates::Planar(b)) => Some(Coordinates::Planar(
            Configuration::new(of(a.x, b.x), of(a.y, b.y), of(a.theta, b.theta)),
        )),
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: s, v: t }) => Some(Coordinates::Axes {
            u: of(u, s),
            v: of(v, t),
        }),
        _ => None,
    }
}

/// Midpoints of the blocked intervals of a straight motion, each with the patch through which the interval begins.
pub(super) fn middles(crossings: &[PairCrossing]) -> Vec<(PatchId, f64)> {
    let enters = crossings.iter().enumerate().filter(|(_, c)| c.enters);
    enters
        .map(|(k, crossing)| {
            let out = crossings[k..].iter().find(|c| !c.enters);
            let end = out.map_or(1.0, |c| c.time);
            (crossing.patch, 0.5 * (crossing.time + end))
        })
        .collect()
}

//! Finds pairs of concentric arcs of each part with equal sums of radii: one arc of the first pair touches one of the second along the same
//! circle as the other two touch, at every orientation. Example: a ring in a groove with equal clearance inside and outside.
//!
//! Where both contacts exist their curves lie on each other, and if one ends before the other, its continuation may go on behind the other
//! without ever crossing it. Growing parts evenly changes both sums equally.

use super::tolerance::SAME_CARRIER;
use super::types::{Feature, Outline};

/// Maximum number of equal sums that are listed.
const MOST: usize = 1 << 20;

/// Two round features of a part about one centre, by their index; the first has the smaller signed radius.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Concentric {
    lesser: u32,
    greater: u32,
    /// The difference of the radii.
    apart: f64,
}

/// Feature `fixed.0` touches `moving.0` along the same circle as `fixed.1` touches `moving.1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct EqualSum {
    /// Features of the fixed part, the smaller radius first.
    pub(super) fixed: (u32, u32),
    /// Features of the moving part, the larger radius first.
    pub(super) moving: (u32, u32),
}

/// All equal sums of arcs, for loops with at most one arc per centre and radius; normals are not compared, since a contact may continue on
/// the next arc. `None` if there are too many to list.
pub(super) fn equal_sums(fixed: &Outline, moving: &Outline) -> Option<Vec<EqualSum>> {
    let all = |outline: &Outline| {
        let mut round = round(outline);
        round.dedup_by(|b, a| {
            let (f, g) = (a.1, b.1);
            let one_loop = f.name.loop_index == g.name.loop_index;
            let one_radius = (f.radius() - g.radius()).abs() <= SAME_CARRIER;
            one_loop && one_radius && f.center().distance(g.center()) <= SAME_CARRIER
        });
        concentric(&round)
    };
    let of_fixed = all(fixed)?;
    if of_fixed.is_empty() {
        return Some(Vec::new());
    }
    equal(of_fixed, all(moving)?)
}

fn equal(of_fixed: Vec<Concentric>, mut of_moving: Vec<Concentric>) -> Option<Vec<EqualSum>> {
    of_moving.sort_by(|a, b| a.apart.total_cmp(&b.apart));
    let mut found = Vec::new();
    for f in of_fixed {
        let from = of_moving.partition_point(|m| m.apart < f.apart - SAME_CARRIER);
        let equal = of_moving[from..]
            .iter()
            .take_while(|m| m.apart <= f.apart + SAME_CARRIER);
        found.extend(equal.map(|m| EqualSum {
            fixed: (f.lesser, f.greater),
            moving: (m.greater, m.lesser),
        }));
        if found.len() > MOST {
            return None;
        }
    }
    Some(found)
}

/// Coordinate of the centre of a round feature along a direction: equal centres are next to each other along any direction, and along this
/// one few others are.
fn place(f: &Feature) -> f64 {
    0.8 * f.center().x + 0.6 * f.center().y
}

/// The round features, sorted by that coordinate.
fn round(outline: &Outline) -> Vec<(u32, &Feature)> {
    let mut round: Vec<(u32, &Feature)> = (0..)
        .zip(&outline.features)
        .filter(|(_, f)| !f.is_line() && f.near.is_none())
        .collect();
    round.sort_by(|a, b| place(a.1).total_cmp(&place(b.1)).then(a.0.cmp(&b.0)));
    round
}

fn concentric(round: &[(u32, &Feature)]) -> Option<Vec<Concentric>> {
    let mut found = Vec::new();
    for (n, &(i, f)) in round.iter().enumerate() {
        let end = place(f) + 2.0 * SAME_CARRIER;
        for &(j, g) in round[n + 1..].iter().take_while(|r| place(r.1) <= end) {
            let apart = g.radius() - f.radius();
            let one_center = f.center().distance(g.center()) <= SAME_CARRIER;
            if !one_center || apart.abs() <= SAME_CARRIER {
                continue;
            }
            let (lesser, greater) = if apart > 0.0 { (i, j) } else { (j, i) };
            found.push(Concentric {
                lesser,
                greater,
                apart: apart.abs(),
            });
            if found.len() > MOST {
                return None;
            }
        }
    }
    Some(found)
}

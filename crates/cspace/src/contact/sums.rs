//! Equal sums of radii: two arcs about one centre of each part, such that one and one touch along the same circle as the other
//! two do, at every orientation. A ring in a groove that leaves as much room inside as outside has them.
//!
//! Where both contacts exist their curves lie on each other, and if one ends before the other, what continues it may go on
//! behind the other without ever crossing it. Growing parts evenly changes both sums alike. If the arcs belong to
//! different loops, these are grown by a little more the greater the radius, and the sums differ; else the contacts are
//! known to be doubled (`doubled.rs`).

use crate::feature::tolerance::{GROWTH, LEVEL, MOVING_GROWTH, SAME_CARRIER};
use crate::feature::{Feature, Outline};

use super::curve::wrap;

/// Arcs have normals in common if more than this (radians): a joint belongs to two arcs.
pub(super) const SLIVER: f64 = 1e-9;

/// More equal sums than this are not listed.
const MOST: usize = 1 << 20;

/// Two round features of a part about one centre, with normals in common, by their index; the signed radius of the first is
/// less.
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
    /// The lesser radius first.
    pub(super) fixed: (u32, u32),
    /// The greater radius first.
    pub(super) moving: (u32, u32),
}

/// All equal sums of two parts; `None` if there are too many to list.
pub(super) fn equal_sums(fixed: &Outline, moving: &Outline) -> Option<Vec<EqualSum>> {
    let of_fixed = concentric(fixed)?;
    if of_fixed.is_empty() {
        return Some(Vec::new());
    }
    let mut of_moving = concentric(moving)?;
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

fn concentric(outline: &Outline) -> Option<Vec<Concentric>> {
    // Centres that are one are next to each other along any direction; along this one few others are.
    let place = |f: &Feature| 0.8 * f.center().x + 0.6 * f.center().y;
    let mut round: Vec<(f64, u32)> = (0..)
        .zip(&outline.features)
        .filter(|(_, f)| !f.is_line() && f.near.is_none())
        .map(|(i, f)| (place(f), i))
        .collect();
    round.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut found = Vec::new();
    for (n, &(at, i)) in round.iter().enumerate() {
        let f = &outline.features[i as usize];
        for &(_, j) in round[n + 1..]
            .iter()
            .take_while(|r| r.0 <= at + 2.0 * SAME_CARRIER)
        {
            let g = &outline.features[j as usize];
            let apart = g.radius() - f.radius();
            let one_center = f.center().distance(g.center()) <= SAME_CARRIER;
            if !one_center || apart.abs() <= SAME_CARRIER || !share_normals(f, g) {
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

/// Whether two features have outward normals in common, not of single directions only.
fn share_normals(f: &Feature, g: &Feature) -> bool {
    let halves = 0.5 * ((f.hi - f.lo) + (g.hi - g.lo));
    wrap(0.5 * (f.lo + f.hi) - 0.5 * (g.lo + g.hi)).abs() < halves - SLIVER
}

/// By how much each loop of a part is grown (length): evenly, but for loops with equal sums.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Growths {
    least: f64,
    levels: Vec<u8>,
}

impl Growths {
    /// For the fixed and for the moving part, as they are grown evenly.
    pub(crate) fn new(fixed: &Outline, moving: &Outline) -> (Self, Self) {
        let sums = equal_sums(fixed, moving).unwrap_or_default();
        let loop_of =
            |outline: &Outline, i: u32| outline.features[i as usize].name.loop_index as usize;
        let fixed_loops = |s: &EqualSum| (loop_of(fixed, s.fixed.0), loop_of(fixed, s.fixed.1));
        // What touches the greater radius of the fixed part has the lesser one; grown by more as well, it adds to the difference.
        let moving_loops =
            |s: &EqualSum| (loop_of(moving, s.moving.0), loop_of(moving, s.moving.1));
        (
            Self {
                least: GROWTH,
                levels: levels::<7>(sums.iter().map(fixed_loops)),
            },
            Self {
                least: MOVING_GROWTH,
                levels: levels::<5>(sums.iter().map(moving_loops)),
            },
        )
    }

    /// Whether all loops are grown alike.
    pub(crate) fn are_even(&self) -> bool {
        self.levels.iter().all(|&l| l == 0)
    }

    /// By how much a loop is grown.
    pub(crate) fn of(&self, loop_index: u32) -> f64 {
        let level = self.levels.get(loop_index as usize).copied();
        self.least + LEVEL * f64::from(level.unwrap_or(0))
    }

    /// By how much the loop is grown that is grown most.
    pub(crate) fn greatest(&self) -> f64 {
        let level = self.levels.iter().copied().max();
        self.least + LEVEL * f64::from(level.unwrap_or(0))
    }
}

/// For each loop how many are below it, up to a number of levels, of pairs of which the second is to be above the first.
fn levels<const LEVELS: u8>(above: impl Iterator<Item = (usize, usize)>) -> Vec<u8> {
    let mut above: Vec<(usize, usize)> = above.filter(|(a, b)| a != b).collect();
    above.sort_unstable();
    above.dedup();
    let count = above.iter().map(|&(a, b)| a.max(b) + 1).max().unwrap_or(0);
    let mut ranks = vec![0_usize; count];
    // So often only if loops are above each other, which no level tells apart.
    for _ in 0..=count {
        let mut same = true;
        for &(a, b) in &above {
            if ranks[b] <= ranks[a] {
                ranks[b] = ranks[a] + 1;
                same = false;
            }
        }
        if same {
            break;
        }
    }
    ranks
        .iter()
        .map(|r| (r % usize::from(LEVELS)) as u8)
        .collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;

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

/// All equal sums of arcs with normals in common; `None` if there are too many to list.
pub(super) fn equal_sums(fixed: &Outline, moving: &Outline) -> Option<Vec<EqualSum>> {
    let all = |outline: &Outline| concentric(&round(outline), share_normals);
    let of_fixed = all(fixed)?;
    if of_fixed.is_empty() {
        return Some(Vec::new());
    }
    equal(of_fixed, all(moving)?)
}

/// The same of arcs of which a loop has one only about each centre with each radius, whatever their normals: where one contact
/// ends another may begin.
fn equal_sums_of_loops(fixed: &Outline, moving: &Outline) -> Option<Vec<EqualSum>> {
    let all = |outline: &Outline| {
        let mut round = round(outline);
        round.dedup_by(|b, a| {
            let (f, g) = (a.1, b.1);
            let one_loop = f.name.loop_index == g.name.loop_index;
            let one_radius = (f.radius() - g.radius()).abs() <= SAME_CARRIER;
            one_loop && one_radius && f.center().distance(g.center()) <= SAME_CARRIER
        });
        concentric(&round, |_, _| true)
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

/// How far along a direction the centre of a round feature is: centres that are one are next to each other along any, and
/// along this one few others are.
fn place(f: &Feature) -> f64 {
    0.8 * f.center().x + 0.6 * f.center().y
}

/// The round features, by where their centres are.
fn round(outline: &Outline) -> Vec<(u32, &Feature)> {
    let mut round: Vec<(u32, &Feature)> = (0..)
        .zip(&outline.features)
        .filter(|(_, f)| !f.is_line() && f.near.is_none())
        .collect();
    round.sort_by(|a, b| place(a.1).total_cmp(&place(b.1)).then(a.0.cmp(&b.0)));
    round
}

fn concentric(
    round: &[(u32, &Feature)],
    together: impl Fn(&Feature, &Feature) -> bool,
) -> Option<Vec<Concentric>> {
    let mut found = Vec::new();
    for (n, &(i, f)) in round.iter().enumerate() {
        let end = place(f) + 2.0 * SAME_CARRIER;
        for &(j, g) in round[n + 1..].iter().take_while(|r| place(r.1) <= end) {
            let apart = g.radius() - f.radius();
            let one_center = f.center().distance(g.center()) <= SAME_CARRIER;
            if !one_center || apart.abs() <= SAME_CARRIER || !together(f, g) {
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
    /// From one level to the next.
    step: f64,
    /// Of each loop.
    levels: Vec<u8>,
}

impl Growths {
    /// For the fixed and for the moving part, as they are grown evenly.
    ///
    /// All levels of the fixed part together are less than one of the moving part, so that they do not cancel out.
    pub(crate) fn new(fixed: &Outline, moving: &Outline) -> (Self, Self) {
        let sums = equal_sums_of_loops(fixed, moving).unwrap_or_default();
        let alike = (Alike::new(fixed), Alike::new(moving));
        let of_fixed = |s: &EqualSum| alike.0.of_features(fixed, s.fixed);
        let of_moving = |s: &EqualSum| alike.1.of_features(moving, s.moving);
        // What the fixed part does not tell apart is left to the moving one.
        let left = sums.iter().filter(|s| {
            let (a, b) = of_fixed(s);
            a == b
        });
        (
            Self {
                least: GROWTH,
                step: LEVEL,
                levels: alike.0.levels(sums.iter().map(of_fixed), FIXED_LEVELS),
            },
            Self {
                least: MOVING_GROWTH,
                step: LEVEL * f64::from(FIXED_LEVELS),
                levels: alike.1.levels(left.map(of_moving), MOVING_LEVELS),
            },
        )
    }

    /// By how much a loop is grown.
    pub(crate) fn of(&self, loop_index: u32) -> f64 {
        let level = self.levels.get(loop_index as usize).copied();
        self.least + self.step * f64::from(level.unwrap_or(0))
    }

    /// By how much the loop is grown that is grown most.
    pub(crate) fn greatest(&self) -> f64 {
        let level = self.levels.iter().copied().max();
        self.least + self.step * f64::from(level.unwrap_or(0))
    }
}

const FIXED_LEVELS: u8 = 4;
const MOVING_LEVELS: u8 = 3;

/// Loops of one length: copies of each other by a symmetry are among them, and are to be grown alike.
struct Alike {
    /// For each loop, counted in order of length.
    class: Vec<usize>,
    count: usize,
}

impl Alike {
    fn new(outline: &Outline) -> Self {
        /// Loops are of one length if they differ by less (length).
        const ONE_LENGTH: f64 = 1e-9;
        let mut lengths: Vec<(f64, usize)> = Vec::new();
        for f in &outline.features {
            let i = f.name.loop_index as usize;
            if lengths.len() <= i {
                lengths.resize(i + 1, (0.0, 0));
            }
            lengths[i].1 = i;
            lengths[i].0 += if f.is_line() {
                outline.start(f).point.distance(outline.end(f).point)
            } else {
                f.radius().abs() * (f.hi - f.lo)
            };
        }
        let mut class = vec![0; lengths.len()];
        lengths.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut count = 0;
        for (n, l) in lengths.iter().enumerate() {
            count += usize::from(n > 0 && l.0 - lengths[n - 1].0 > ONE_LENGTH);
            class[l.1] = count;
        }
        Self {
            class,
            count: count + 1,
        }
    }

    fn of_features(&self, outline: &Outline, (f, g): (u32, u32)) -> (usize, usize) {
        let class = |i: u32| self.class[outline.features[i as usize].name.loop_index as usize];
        (class(f), class(g))
    }

    /// Levels of the loops, different for such as are listed together as far as there are so many.
    fn levels(&self, together: impl Iterator<Item = (usize, usize)>, levels: u8) -> Vec<u8> {
        let mut together: Vec<(usize, usize)> = together
            .filter(|(a, b)| a != b)
            .map(|(a, b)| (a.max(b), a.min(b)))
            .collect();
        together.sort_unstable();
        together.dedup();
        let mut level = vec![0; self.count];
        for of_class in together.chunk_by(|a, b| a.0 == b.0) {
            let is_free = |l: &u8| of_class.iter().all(|&(_, other)| level[other] != *l);
            let class = of_class[0].0;
            level[class] = (0..levels)
                .find(is_free)
                .unwrap_or((class % usize::from(levels)) as u8);
        }
        self.class.iter().map(|&c| level[c]).collect()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;

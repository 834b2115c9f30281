//! Growth of each loop of a part.
//!
//! All loops of a part are grown by the same length, unless arcs of two of them touch the other part along one circle at every orientation
//! (see `concentric.rs`): growing them evenly does not change that. Those loops are put on levels, each grown by a little more than the
//! level below. Arcs of one loop are grown alike.

use super::concentric::{EqualSum, equal_sums};
use super::tolerance::{GROWTH, LEVEL, MOVING_GROWTH, ONE_LENGTH};
use super::types::Outline;

/// Length by which each loop of a part is grown: the same for all, except for loops with equal sums.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Growths {
    least: f64,
    /// Difference between one level and the next.
    step: f64,
    /// Level of each loop.
    levels: Vec<u8>,
}

impl Growths {
    /// Growths of the fixed and the moving part if they have one loop each, which need no levels.
    pub(crate) fn alike() -> (Self, Self) {
        let least = |least| Self {
            least,
            step: 0.0,
            levels: Vec::new(),
        };
        (least(GROWTH), least(MOVING_GROWTH))
    }

    /// Growths of the fixed and of the moving part, given their outlines as grown evenly.
    ///
    /// All levels of the fixed part together are less than one of the moving part, so that they do not cancel.
    pub(crate) fn new(fixed: &Outline, moving: &Outline) -> (Self, Self) {
        let sums = equal_sums(fixed, moving).unwrap_or_default();
        let alike = (Alike::new(fixed), Alike::new(moving));
        let of_fixed = |s: &EqualSum| alike.0.of_features(fixed, s.fixed);
        let of_moving = |s: &EqualSum| alike.1.of_features(moving, s.moving);
        // Equal sums that levels of the fixed part do not separate are left to the moving part.
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

    /// The growths with every loop grown by less.
    pub(crate) fn less(self, by: f64) -> Self {
        Self {
            least: self.least - by,
            ..self
        }
    }

    /// Growth of a loop.
    pub(crate) fn of(&self, loop_index: u32) -> f64 {
        let level = self.levels.get(loop_index as usize).copied();
        self.least + self.step * f64::from(level.unwrap_or(0))
    }

    /// Largest growth of a loop.
    pub(crate) fn greatest(&self) -> f64 {
        let level = self.levels.iter().copied().max();
        self.least + self.step * f64::from(level.unwrap_or(0))
    }
}

const FIXED_LEVELS: u8 = 4;
const MOVING_LEVELS: u8 = 3;

/// Classes of loops of equal length: copies of each other by a symmetry are among these, and must be grown alike.
struct Alike {
    /// Class of each loop, numbered in order of length.
    class: Vec<usize>,
    count: usize,
}

impl Alike {
    fn new(outline: &Outline) -> Self {
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

    /// Levels of the loops, different for loops that are listed together, as far as there are enough levels.
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

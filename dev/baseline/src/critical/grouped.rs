//! Orientations, those that are the same once.

use core::f64::consts::{PI, TAU};

use super::tolerance::SAME;

/// Realised orientations in [−π, π), sorted.
#[derive(Debug, Clone, Default)]
pub(super) struct Grouped {
    sorted: Vec<f64>,
}

/// Equal orientation in [−π, π).
pub(super) fn reduced(theta: f64) -> f64 {
    let turned = theta - TAU * ((theta + PI) / TAU).floor();
    if turned >= PI { turned - TAU } else { turned }
}

impl Grouped {
    /// Whether a found orientation is within the tolerance of a reduced one, around the turn.
    pub(super) fn has(&self, theta: f64) -> bool {
        let at = self.sorted.partition_point(|&t| t < theta);
        let off = |i: usize| {
            self.sorted.get(i).is_some_and(|t| {
                let off = (t - theta).abs();
                off.min(TAU - off) <= SAME
            })
        };
        let last = self.sorted.len().wrapping_sub(1);
        off(at) || off(at.wrapping_sub(1)) || off(0) || off(last)
    }

    /// Adds orientations that are not there yet.
    pub(super) fn add(&mut self, found: impl Iterator<Item = f64>) {
        let before = self.sorted.len();
        self.sorted.extend(found);
        if self.sorted.len() > before {
            self.sorted.sort_by(f64::total_cmp);
        }
    }

    /// First orientation of each group whose members are each within the tolerance of the next.
    pub(super) fn finish(mut self) -> Vec<f64> {
        let (first, last) = (self.sorted.first().copied(), self.sorted.last().copied());
        let mut before = f64::NEG_INFINITY;
        self.sorted.retain(|&t| {
            let new = t - before > SAME;
            before = t;
            new
        });
        // A group around ±π.
        if let (Some(first), Some(last)) = (first, last)
            && self.sorted.len() > 1
            && first + TAU - last <= SAME
        {
            self.sorted.remove(0);
        }
        self.sorted
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orientations_within_the_tolerance_are_one_around_the_turn_too() {
        let mut grouped = Grouped::default();
        let near = 0.3 * SAME;
        grouped.add([0.5, PI - near, -PI + near, 0.5 + near, 1.0].into_iter());
        assert!(grouped.has(reduced(PI)) && grouped.has(1.0 - near));
        assert!(!grouped.has(0.5 - 2.0 * SAME));
        assert_eq!(grouped.finish(), [0.5, 1.0, PI - near]);
    }
}

//! Fewer legs.

use crate::legs::Scene;
use crate::route::along;

use super::legs::Legs;

/// A leg that replaces others keeps this share of their clearance,
pub(super) const KEPT: f64 = 0.5;
/// or this where clearance is preferred.
const MOST_KEPT: f64 = 0.9;
/// Legs are divided and replaced again so often at most, while that makes the way shorter by a share.
const ROUNDS: usize = 8;
const SHORTER: f64 = 1e-3;

impl<'a> Legs<'a> {
    /// The path with few legs, each with most of the clearance of those that it replaces, and at least a given clearance.
    pub(crate) fn clear(&self, clearance: f64) -> Legs<'a> {
        self.shortened(clearance, MOST_KEPT)
    }

    /// The path made short, with at least a given clearance.
    pub(crate) fn short(&self, clearance: f64) -> Legs<'a> {
        let mut best = self.shortened(clearance, 0.0);
        for _ in 0..ROUNDS {
            let quarters = best
                .places
                .windows(2)
                .flat_map(|leg| [0.25, 0.5, 0.75, 1.0].map(|s| along(leg[0], leg[1], s)));
            let places = best.places.first().copied().into_iter().chain(quarters);
            let next = Legs::new(self.scene, places.collect()).shortened(clearance, 0.0);
            if next.length() >= best.length() * (1.0 - SHORTER) {
                break;
            }
            best = next;
        }
        best
    }

    /// This path, or another that is shorter.
    pub(crate) fn or_shorter(self, other: Self) -> Self {
        if other.length() < self.length() {
            other
        } else {
            self
        }
    }

    /// This path, or another with at least as much clearance.
    pub(crate) fn or_wider(self, other: Self) -> Self {
        let clearance = |legs: &Self| legs.narrowest().map_or(0.0, |n| n.1.distance);
        if clearance(&other) >= clearance(&self) {
            other
        } else {
            self
        }
    }

    /// How far the parts move along the path, where a radian counts as far as the moving part reaches.
    pub(super) fn length(&self) -> f64 {
        (self.places.windows(2))
            .map(|leg| self.scene.long(leg[0], leg[1]))
            .sum()
    }

    /// The path with as few legs between its places as can be, each with at least a share of the clearance of those that it replaces, and
    /// at least a given clearance.
    pub(super) fn shortened(&self, clearance: f64, share: f64) -> Legs<'a> {
        let scene: &'a Scene = self.scene;
        let last = self.places.len() - 1;
        let mut kept = vec![self.places[0]];
        let mut here = 0;
        while here < last {
            let reaches = |to: usize| {
                let least = self.narrowest[here..to]
                    .iter()
                    .map(|n| n.distance)
                    .fold(f64::INFINITY, f64::min);
                scene.is_clearly_apart(
                    self.places[here],
                    self.places[to],
                    (share * least).max(clearance),
                )
            };
            let next = farthest(here, last, reaches);
            kept.push(self.places[next]);
            here = next;
        }
        Legs::new(scene, kept)
    }
}

/// The farthest place that a leg reaches: the last if it does, or one found by steps that double and halve.
fn farthest(here: usize, last: usize, reaches: impl Fn(usize) -> bool) -> usize {
    if here + 1 == last || reaches(last) {
        return last;
    }
    let (mut good, mut bad) = (here + 1, last);
    let mut step = 1;
    while good + step < bad {
        if reaches(good + step) {
            good += step;
            step *= 2;
        } else {
            bad = good + step;
        }
    }
    while bad - good > 1 {
        let middle = good.midpoint(bad);
        if reaches(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    good
}

//! Fewer legs.

use crate::legs::Scene;

use super::legs::Legs;

/// A leg that replaces others keeps this share of their clearance.
const KEPT: f64 = 0.5;

impl<'a> Legs<'a> {
    /// The path with as few legs between its places as can be, each with at least half the clearance of those that it
    /// replaces, and at least a given clearance.
    pub(crate) fn shortened(&self, clearance: f64) -> Legs<'a> {
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
                    (KEPT * least).max(clearance),
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

//! Turns that a path need not make.

use core::f64::consts::TAU;

use super::legs::Legs;
use super::shorten::KEPT;

impl Legs<'_> {
    /// The path without whole turns in its legs, where a leg without them has most of the clearance, and at least a given one: an orientation
    /// is the same whole turns away, and a way that winds far from the other part may come with any number of them.
    pub(crate) fn unwound(mut self, clearance: f64) -> Self {
        if self.scene.motions().is_some() {
            return self;
        }
        let mut is_wound = false;
        for k in 1..self.places.len() {
            let (from, to) = (self.places[k - 1], self.places[k]);
            let turns = TAU * ((to[2] - from[2]) / TAU).round();
            let less = [to[0], to[1], to[2] - turns];
            let kept = (KEPT * self.narrowest[k - 1].distance).max(clearance);
            if turns != 0.0
                && self.scene.within_limits(less) == less
                && self.scene.is_clearly_apart(from, less, kept)
            {
                is_wound = true;
                self.places[k..].iter_mut().for_each(|at| at[2] -= turns);
            }
        }
        match is_wound {
            true => Self::new(self.scene, self.places),
            false => self,
        }
    }
}

//! More clearance where a path is narrow.

use crate::legs::{Coords, Near};
use crate::push::rise;
use crate::route::along;

use super::legs::Legs;

/// Distances up to so many times the least are looked at: what is farther is not in the way of a step.
const LOOK: f64 = 3.0;
/// Steps are made shorter so often before none is found.
const TRIES: u32 = 14;
/// A place this near to the end of a leg, as a share of it, is its end.
const AT_END: f64 = 1e-3;

impl Legs<'_> {
    /// Moves the path where it is narrowest, across its direction, until no place that is the narrowest of its leg can be moved for
    /// a share `gain` more, or so many places were moved.
    pub(crate) fn raise(&mut self, rounds: usize, gain: f64) {
        let mut done = vec![false; self.narrowest.len()];
        let mut reach = self.scene.size();
        for _ in 0..rounds {
            let open = (0..self.narrowest.len()).filter(|&leg| !done[leg]);
            let narrowest = |&leg: &usize| self.narrowest[leg].distance;
            let Some(leg) = open.min_by(|a, b| narrowest(a).total_cmp(&narrowest(b))) else {
                return;
            };
            let time = self.narrowest[leg].time;
            let last = self.places.len() - 1;
            let place = if time <= AT_END {
                leg
            } else if time >= 1.0 - AT_END {
                leg + 1
            } else {
                let at = along(self.places[leg], self.places[leg + 1], time);
                self.insert(leg + 1, at);
                done.insert(leg, false);
                leg + 1
            };
            if place == 0 || place == last && time >= 1.0 - AT_END {
                // No path from there has more.
                done[leg] = true;
                continue;
            }
            if self.push(place, &mut reach, gain) {
                done[place - 1] = false;
                done[place] = false;
            } else {
                done[place - 1] = true;
                done[place] = true;
            }
        }
    }

    fn insert(&mut self, place: usize, at: Coords) {
        self.places.insert(place, at);
        let before = self.scene.least(self.places[place - 1], at);
        let after = self.scene.least(at, self.places[place + 1]);
        self.narrowest[place - 1] = before;
        self.narrowest.insert(place, after);
    }

    /// Moves a place so that both of its legs have more clearance.
    fn push(&mut self, place: usize, reach: &mut f64, gain: f64) -> bool {
        let scene = self.scene;
        let levers = scene.levers();
        let (before, at, after) = (
            self.places[place - 1],
            self.places[place],
            self.places[place + 1],
        );
        let tangent: Coords = core::array::from_fn(|k| after[k] - before[k]);
        let had = self.narrowest[place - 1]
            .distance
            .min(self.narrowest[place].distance);
        let near: Vec<Near> = scene.near(at, LOOK * scene.clearance(at).max(had));
        *reach = (4.0 * *reach).min(scene.size());
        for _ in 0..TRIES {
            if let Some(step) = rise(&near, levers, Some(tangent), *reach) {
                let to = scene.within_limits(core::array::from_fn(|k| at[k] + step[k]));
                let wanted = had * (1.0 + gain);
                if scene.clearance(to) > wanted
                    && scene.is_apart(before, to, wanted)
                    && scene.is_apart(to, after, wanted)
                {
                    self.places[place] = to;
                    self.narrowest[place - 1] = scene.least(before, to);
                    self.narrowest[place] = scene.least(to, after);
                    return true;
                }
            }
            *reach *= 0.25;
        }
        false
    }
}

//! More clearance along a path.

use crate::legs::Coords;
use crate::push::Climb;
use crate::route::along;

use super::legs::Legs;

/// A leg keeps this share of the clearance at its ends while places are moved.
const KEPT: f64 = 0.25;
/// A leg that has less than this share is divided.
const DIVIDED: f64 = 0.75;
/// A first step is at most this share of the parts' size.
const FIRST: f64 = 0.1;
/// Clearance of more than this share of the parts' size is enough, if both ends of the path have no more.
pub(super) const ENOUGH: f64 = 0.1;
/// A path is divided into no more places.
const MOST: usize = 256;

/// A place of a path that is moved.
#[derive(Debug, Clone, Copy)]
struct Place {
    climb: Climb,
    /// Whether it, or one beside it, was moved since it was looked at.
    open: bool,
}

impl Legs<'_> {
    /// Moves all places across the path, towards more clearance, so many times or until none gains a share `gain`; legs that
    /// come nearer than their ends are divided.
    pub(crate) fn raise(&mut self, rounds: usize, gain: f64) {
        let scene = self.scene;
        let place = |at: Coords| Place {
            climb: Climb {
                at,
                clearance: scene.clearance(at),
                reach: FIRST * scene.size(),
            },
            open: true,
        };
        let mut places: Vec<Place> = self.places.iter().copied().map(place).collect();
        let ends = [places.first(), places.last()].map(|p| p.map_or(0.0, |p| p.climb.clearance));
        let enough = (ENOUGH * scene.size()).max(ends[0].min(ends[1]));
        for _ in 0..rounds {
            let mut moved = false;
            for i in 1..places.len().saturating_sub(1) {
                if places[i].open && places[i].climb.clearance < enough {
                    moved |= self.push(&mut places, i, gain);
                }
            }
            let mut divided = Vec::with_capacity(places.len());
            let mut room = MOST.saturating_sub(places.len());
            for pair in places.windows(2) {
                divided.push(pair[0]);
                let [a, b] = [pair[0].climb, pair[1].climb];
                let least = DIVIDED * a.clearance.min(b.clearance).min(enough);
                if room > 0
                    && (pair[0].open || pair[1].open)
                    && !scene.is_clearly_apart(a.at, b.at, least)
                {
                    let mut between = place(along(a.at, b.at, 0.5));
                    let reach = a.reach.min(b.reach).max(between.climb.clearance);
                    between.climb.reach = reach;
                    divided.push(between);
                    room -= 1;
                    moved = true;
                }
            }
            divided.extend(places.last());
            places = divided;
            if !moved {
                break;
            }
        }
        *self = Self::new(scene, places.into_iter().map(|p| p.climb.at).collect());
    }

    /// Moves one place.
    fn push(&self, places: &mut [Place], i: usize, gain: f64) -> bool {
        let scene = self.scene;
        let [before, here, after] = [i - 1, i, i + 1].map(|i| places[i].climb);
        let tangent: Coords = core::array::from_fn(|k| after.at[k] - before.at[k]);
        let free = |to: Coords, clearance: f64| {
            [before, after].iter().all(|beside| {
                let kept = KEPT * clearance.min(beside.clearance);
                scene.is_clearly_apart(beside.at, to, kept)
            })
        };
        let mut climb = here;
        if climb.step(scene, scene.levers(), Some(tangent), gain, free) {
            places[i].climb = climb;
            places[i - 1].open = true;
            places[i + 1].open = true;
            return true;
        }
        places[i].open = false;
        places[i].climb.reach = here.clearance;
        false
    }
}

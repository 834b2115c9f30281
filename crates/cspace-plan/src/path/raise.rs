//! More clearance along a path.

use crate::legs::{Coords, Near};
use crate::push::rise;
use crate::route::along;

use super::legs::Legs;

/// A leg keeps this share of the clearance at its ends while places are moved.
const KEPT: f64 = 0.25;
/// A leg that has less than this share is divided.
const DIVIDED: f64 = 0.75;
/// Steps are made longer by this after one that was taken, and shorter after one that was not.
const LONGER: f64 = 4.0;
const SHORTER: f64 = 0.25;
/// So many lengths of a step are tried at once.
const TRIED: usize = 8;
/// A first step is at most this share of the parts' size.
const FIRST: f64 = 0.1;
/// Clearance of more than this share of the parts' size is enough, if both ends of the path have no more.
pub(super) const ENOUGH: f64 = 0.1;
/// A path is divided into no more places.
const MOST: usize = 256;

/// A place of a path that is moved.
#[derive(Debug, Clone, Copy)]
struct Place {
    at: Coords,
    clearance: f64,
    /// How far it is moved at most.
    reach: f64,
    /// Whether it, or one beside it, was moved since it was looked at.
    open: bool,
}

impl Legs<'_> {
    /// Moves all places across the path, towards more clearance, so many times or until none gains a share `gain`; legs that
    /// come nearer than their ends are divided.
    pub(crate) fn raise(&mut self, rounds: usize, gain: f64) {
        let scene = self.scene;
        let place = |at: Coords| Place {
            at,
            clearance: scene.clearance(at),
            reach: FIRST * scene.size(),
            open: true,
        };
        let mut places: Vec<Place> = self.places.iter().copied().map(place).collect();
        let ends = [places.first(), places.last()].map(|p| p.map_or(0.0, |p| p.clearance));
        let enough = (ENOUGH * scene.size()).max(ends[0].min(ends[1]));
        for _ in 0..rounds {
            let mut moved = false;
            for i in 1..places.len().saturating_sub(1) {
                if places[i].open && places[i].clearance < enough {
                    moved |= self.push(&mut places, i, gain);
                }
            }
            let mut divided = Vec::with_capacity(places.len());
            let mut room = MOST.saturating_sub(places.len());
            for pair in places.windows(2) {
                divided.push(pair[0]);
                let least = DIVIDED * pair[0].clearance.min(pair[1].clearance).min(enough);
                if room > 0
                    && (pair[0].open || pair[1].open)
                    && !scene.is_clearly_apart(pair[0].at, pair[1].at, least)
                {
                    let mut between = place(along(pair[0].at, pair[1].at, 0.5));
                    between.reach = pair[0].reach.min(pair[1].reach).max(between.clearance);
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
        *self = Self::new(scene, places.into_iter().map(|p| p.at).collect());
    }

    /// Moves one place.
    fn push(&self, places: &mut [Place], i: usize, gain: f64) -> bool {
        let scene = self.scene;
        let (before, here, after) = (places[i - 1], places[i], places[i + 1]);
        let tangent: Coords = core::array::from_fn(|k| after.at[k] - before.at[k]);
        let mut reach = here.reach;
        for _ in 0..TRIED {
            // A step changes distances by its length at most: what is farther does not become the nearest.
            let near: Vec<Near> = scene.near(here.at, here.clearance + 2.0 * reach);
            let Some(step) = rise(&near, scene.levers(), Some(tangent), reach) else {
                break;
            };
            let to = scene.within_limits(core::array::from_fn(|k| here.at[k] + step[k]));
            let clearance = scene.clearance(to);
            let free = |beside: &Place| {
                scene.is_clearly_apart(beside.at, to, KEPT * clearance.min(beside.clearance))
            };
            if clearance > here.clearance * (1.0 + gain) && free(&before) && free(&after) {
                places[i].at = to;
                places[i].clearance = clearance;
                places[i].reach = reach * LONGER;
                places[i - 1].open = true;
                places[i + 1].open = true;
                return true;
            }
            reach *= SHORTER;
        }
        places[i].open = false;
        places[i].reach = here.clearance;
        false
    }
}

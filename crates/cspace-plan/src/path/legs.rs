//! A path with the clearance of its legs.

use crate::answer::Narrow;
use crate::legs::{Coords, Nearest, Scene};
use crate::route::along;

/// A path with where each of its legs is narrowest, to a hundredth.
#[derive(Debug, Clone)]
pub(crate) struct Legs<'a> {
    pub(super) scene: &'a Scene,
    pub(super) places: Vec<Coords>,
    pub(super) narrowest: Vec<Nearest>,
}

impl<'a> Legs<'a> {
    pub(crate) fn new(scene: &'a Scene, places: Vec<Coords>) -> Self {
        let narrowest = (places.windows(2))
            .map(|leg| scene.least_roughly(leg[0], leg[1]))
            .collect();
        Self {
            scene,
            places,
            narrowest,
        }
    }

    /// Where the path is narrowest: the configuration, and what is nearest there, as [`Scene::least`]. Of a path of one place, that.
    pub(crate) fn narrowest(&self) -> Option<(Coords, Nearest)> {
        let mut legs: Vec<usize> = (0..self.narrowest.len()).collect();
        let roughly = |&leg: &usize| self.narrowest[leg].distance;
        legs.sort_by(|a, b| roughly(a).total_cmp(&roughly(b)));
        let Some((&first, others)) = legs.split_first() else {
            return self.places.first().map(|&at| (at, self.scene.nearest(at)));
        };
        let ends = |leg: usize| (self.places[leg], self.places[leg + 1]);
        let (from, to) = ends(first);
        let mut least = (first, self.scene.least(from, to));
        for &leg in others {
            let (from, to) = ends(leg);
            let found = self.scene.least_below(from, to, least.1.distance);
            if found.distance < least.1.distance {
                least = (leg, found);
            }
        }
        let (from, to) = ends(least.0);
        Some((along(from, to, least.1.time), least.1))
    }

    /// Where the path is narrowest, as answers have it.
    pub(crate) fn narrow(&self) -> Narrow {
        let at = |c: Coords| self.scene.coordinates(c);
        match self.narrowest() {
            Some((c, found)) => Narrow {
                clearance: found.distance,
                at: at(c),
                features: found.features,
            },
            None => Narrow {
                clearance: f64::INFINITY,
                at: at([0.0; 3]),
                features: None,
            },
        }
    }

    pub(crate) fn places(&self) -> &[Coords] {
        &self.places
    }
}

//! A path with the clearance of its legs.

use crate::legs::{Coords, Nearest, Scene};
use crate::route::along;

/// A path with where each of its legs is narrowest.
#[derive(Debug, Clone)]
pub(crate) struct Legs<'a> {
    pub(super) scene: &'a Scene,
    pub(super) places: Vec<Coords>,
    pub(super) narrowest: Vec<Nearest>,
}

impl<'a> Legs<'a> {
    pub(crate) fn new(scene: &'a Scene, places: Vec<Coords>) -> Self {
        let narrowest = (places.windows(2))
            .map(|leg| scene.least(leg[0], leg[1]))
            .collect();
        Self {
            scene,
            places,
            narrowest,
        }
    }

    /// Where the path is narrowest: the configuration, and what is nearest there. Of a path of one place, that.
    pub(crate) fn narrowest(&self) -> Option<(Coords, Nearest)> {
        let least = (self.narrowest.iter().enumerate())
            .min_by(|a, b| a.1.distance.total_cmp(&b.1.distance));
        match least {
            Some((leg, found)) => {
                let at = along(self.places[leg], self.places[leg + 1], found.time);
                Some((at, *found))
            }
            None => self.places.first().map(|&at| (at, self.scene.nearest(at))),
        }
    }

    pub(crate) fn places(&self) -> &[Coords] {
        &self.places
    }
}

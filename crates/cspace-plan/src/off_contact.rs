//! Off a contact, into free space.

use cspace::{Coordinates, PairSpace, QueryError};

use crate::legs::{Coords, Near, Scene};
use crate::push::{Climb, norm, rise};

/// Steps are at most this share of the parts' size.
const LONGEST: f64 = 0.25;
/// And are halved at most so often: below lies what rounding does to contacts.
const HALVINGS: u32 = 44;
/// The best step is found to (2/3)⁶⁴ of its length.
const REFINED: u32 = 64;
/// Contacts within so many resolutions are left together.
const TOUCHING: f64 = 8.0;
/// The leg is tested from this share of it on; before, it goes where all contact functions grow.
const FIRST: f64 = 1e-3;
/// A leg that leaves a contact for good, and does not go along it, has at least this sine with it.
const STEEP: f64 = 0.5;
/// The end of a leg is moved to more clearance at most so often, each time by this share or more.
const MOVES: usize = 64;
const GAIN: f64 = 1e-4;
/// Clearance of more than this share of the parts' size is enough to begin with.
const ENOUGH: f64 = 0.1;

/// The contacts of a configuration, and the legs that leave them.
#[derive(Debug, Clone)]
pub(crate) struct Contacts<'a> {
    scene: &'a Scene,
    at: Coords,
    /// All begin at no distance: their gradients determine where they lead.
    touching: Vec<Near>,
    resolution: f64,
}

impl<'a> Contacts<'a> {
    /// The contacts of a configuration.
    pub(crate) fn of(
        space: &PairSpace,
        scene: &'a Scene,
        at: Coordinates,
    ) -> Result<Self, QueryError> {
        let resolution = space.resolution();
        let numbers = scene.numbers(at)?;
        let mut touching = Vec::new();
        for (patch, _) in space.contacts(at, TOUCHING * resolution)? {
            let patch = space.patch(patch)?;
            let value = patch.contact()?.evaluate(at)?;
            let (fixed, moving) = patch.features()?;
            let gradient = scene.by_numbers(value.gradient, numbers);
            touching.push(Near::growing(gradient, (fixed.name, moving.name)));
        }
        Ok(Self {
            scene,
            at: numbers,
            touching,
            resolution,
        })
    }

    /// A free configuration, with the leg to it free but for its start: the one of those tried with the most clearance, or with enough.
    /// `None` if there is none nearby: the contacts leave no room, to the resolution.
    pub(crate) fn off(&self, enough: f64) -> Option<Coords> {
        let [x, y, turn] = self.scene.levers();
        let enough = enough.max(ENOUGH * self.scene.size());
        let off = |levers: Coords| {
            let direction = rise(&self.touching, levers, None, 1.0)?;
            let first = LONGEST * self.scene.size();
            let ahead = |step: f64| self.ahead(direction, step);
            let passes = |to: Coords, clearance: f64| self.is_left(to, clearance, 0.0);
            let (clearance, at) = widest(self.scene, first, ahead, passes)?;
            let mut climb = Climb {
                at,
                clearance,
                reach: first,
            };
            let steeper = |to: Coords, clearance: f64| {
                self.is_left(to, clearance, STEEP) && !self.scene.overlaps(to)
            };
            for _ in 0..MOVES {
                if climb.clearance >= enough || !climb.step(self.scene, levers, None, GAIN, steeper)
                {
                    break;
                }
                climb.reach = climb.reach.min(first);
            }
            Some(climb.at)
        };
        // Without a turn where that leaves all contacts.
        off([x, y, 0.0]).or_else(|| off([x, y, turn]))
    }

    /// Whether a leg goes away from the contacts, and has a clearance as soon as they alone let it.
    pub(crate) fn leaves_with(&self, to: Coords, clearance: f64) -> bool {
        let there = self.scene.clearance(to);
        let by = core::array::from_fn(|k| to[k] - self.at[k]);
        let share = clearance / (STEEP * norm(by, self.scene.levers()));
        there > clearance
            && share < 1.0
            && self.is_left(to, there, STEEP)
            && self.scene.is_apart(self.ahead(by, share), to, clearance)
            && !self.scene.overlaps(to)
    }

    /// Whether a leg to a configuration with a clearance is free but for its start, and goes away from all contacts with at least a sine.
    fn is_left(&self, to: Coords, clearance: f64, sine: f64) -> bool {
        let by: Coords = core::array::from_fn(|k| to[k] - self.at[k]);
        let long = norm(by, self.scene.levers());
        let grows = |near: &Near| {
            let rate: f64 = (0..3).map(|k| near.gradient[k] * by[k]).sum();
            rate > sine * long
        };
        clearance > 2.0 * TOUCHING * self.resolution
            && self.touching.iter().all(grows)
            && (self.scene).is_apart(self.ahead(by, FIRST), to, 0.1 * FIRST * clearance)
    }

    fn ahead(&self, direction: Coords, step: f64) -> Coords {
        let ahead = core::array::from_fn(|k| self.at[k] + direction[k] * step);
        self.scene.within_limits(ahead)
    }
}

/// Among the ends of legs with a first step, and that halved again and again, and of those about as long as the best of these, the one
/// with the most clearance, with that; only free ones that pass.
fn widest(
    scene: &Scene,
    first: f64,
    ahead: impl Fn(f64) -> Coords,
    passes: impl Fn(Coords, f64) -> bool,
) -> Option<(f64, Coords)> {
    type Best = Option<(f64, Coords, f64)>;
    let look = |best: &mut Best, step: f64| {
        let to = ahead(step);
        let clearance = scene.clearance(to);
        if best.is_none_or(|b| clearance > b.0) && passes(to, clearance) && !scene.overlaps(to) {
            *best = Some((clearance, to, step));
        }
        clearance
    };
    let (mut best, mut step) = (None, first);
    for _ in 0..HALVINGS {
        look(&mut best, step);
        step *= 0.5;
    }
    // Between the best and its neighbours, by trisection.
    let (_, _, step) = best?;
    let (mut lo, mut hi) = (0.5 * step, (2.0 * step).min(first));
    for _ in 0..REFINED {
        let third = (hi - lo) / 3.0;
        if look(&mut best, lo + third) < look(&mut best, hi - third) {
            lo += third;
        } else {
            hi -= third;
        }
    }
    best.map(|b| (b.0, b.1))
}

/// Clearance of less than this share of the parts' size is little.
const LITTLE: f64 = 1e-3;

/// From a free configuration with little clearance the end of a free leg to one with more, if there is one nearby; else itself.
pub(crate) fn off_near(scene: &Scene, at: Coords) -> Coords {
    let clearance = scene.clearance(at);
    let little = LITTLE * scene.size();
    if clearance > little {
        return at;
    }
    let near = scene.near(at, clearance + little);
    let Some(direction) = rise(&near, scene.levers(), None, 1.0) else {
        return at;
    };
    let length = norm(direction, scene.levers());
    let ahead = |step: f64| -> Coords {
        scene.within_limits(core::array::from_fn(|k| at[k] + direction[k] * step))
    };
    let first = LONGEST * scene.size() / length;
    let best = widest(scene, first, ahead, |to, there| {
        there > clearance && scene.is_apart(at, to, 0.5 * clearance)
    });
    best.map_or(at, |b| b.1)
}

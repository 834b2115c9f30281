//! Off a contact, into free space.

use cspace::{Coordinates, PairSpace, QueryError};

use crate::legs::{Coords, Near, Scene};
use crate::push::rise;

/// Steps are at most this share of the parts' size.
const LONGEST: f64 = 0.25;
/// And are halved at most so often: below lies what rounding does to contacts.
const HALVINGS: u32 = 44;
/// Contacts within so many resolutions are left together.
const TOUCHING: f64 = 8.0;
/// The leg is tested from this share of it on; before, it goes where all contact functions grow.
const FIRST: f64 = 1e-3;

/// A free configuration near one in contact, with the leg between them free but for its start. `None` if there is none nearby:
/// the contacts leave no room, to the resolution.
pub(crate) fn off_contact(
    space: &PairSpace,
    scene: &Scene,
    at: Coordinates,
) -> Result<Option<Coords>, QueryError> {
    let resolution = space.resolution();
    let numbers = scene.numbers(at)?;
    let mut touching = Vec::new();
    for (patch, _) in space.contacts(at, TOUCHING * resolution)? {
        let patch = space.patch(patch)?;
        let value = patch.contact()?.evaluate(at)?;
        let (fixed, moving) = patch.features()?;
        // All begin at no distance: where they lead is a matter of their gradients.
        let gradient = scene.by_numbers(value.gradient, numbers);
        touching.push(Near::growing(gradient, (fixed.name, moving.name)));
    }
    // Without a turn where that leaves all contacts.
    let [x, y, turn] = scene.levers();
    let off = |levers: Coords| {
        let direction = rise(&touching, levers, None, 1.0)?;
        leg_off((scene, resolution), numbers, direction)
    };
    Ok(off([x, y, 0.0]).or_else(|| off([x, y, turn])))
}

/// The end of a free leg in a direction in which all contacts are left, with the most clearance of those tried.
fn leg_off(
    (scene, resolution): (&Scene, f64),
    numbers: Coords,
    direction: Coords,
) -> Option<Coords> {
    let ahead = |step: f64, share: f64| -> Coords {
        scene.within_limits(core::array::from_fn(|k| {
            numbers[k] + direction[k] * step * share
        }))
    };
    let first = LONGEST * scene.size();
    let best = widest(
        scene,
        first,
        |step| ahead(step, 1.0),
        |step, to, clearance| {
            clearance > 2.0 * TOUCHING * resolution
                && scene.is_apart(ahead(step, FIRST), to, 0.1 * FIRST * clearance)
        },
    );
    best.map(|b| b.1)
}

/// Among the ends of legs with a first step, and that halved again and again, the one with the most clearance, with that; only free
/// ones that pass.
fn widest(
    scene: &Scene,
    first: f64,
    ahead: impl Fn(f64) -> Coords,
    passes: impl Fn(f64, Coords, f64) -> bool,
) -> Option<(f64, Coords)> {
    let mut step = first;
    let mut best: Option<(f64, Coords)> = None;
    for _ in 0..HALVINGS {
        let to = ahead(step);
        let clearance = scene.clearance(to);
        if best.is_none_or(|b| clearance > b.0)
            && passes(step, to, clearance)
            && !scene.overlaps(to)
        {
            best = Some((clearance, to));
        }
        step *= 0.5;
    }
    best
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
    let length = (0..3)
        .map(|k| (direction[k] * scene.levers()[k]).powi(2))
        .sum::<f64>()
        .sqrt();
    let ahead = |step: f64| -> Coords {
        scene.within_limits(core::array::from_fn(|k| at[k] + direction[k] * step))
    };
    let first = LONGEST * scene.size() / length;
    let best = widest(scene, first, ahead, |_, to, there| {
        there > clearance && scene.is_apart(at, to, 0.5 * clearance)
    });
    best.map_or(at, |b| b.1)
}

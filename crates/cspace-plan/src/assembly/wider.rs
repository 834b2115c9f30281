//! Room is made wide: what lets others out by a hair is moved on, to where they have a simpler way or one with more clearance.

use crate::legs::{Coords, Scene};

use super::answer::Step;
use super::aside::Moved;
use super::error::AssemblyError;
use super::travel::Travel;
use super::units::{Set, Units};
use super::way_out::told;

/// A unit stops before a contact or the end of its range by this share of its way there, if others leave then as well.
const MARGIN: f64 = 0.05;
/// Clearance is larger if it is so many times the other: less is not worth a longer way.
const LARGER: f64 = 1.01;

/// How good a place is for what leaves.
#[derive(Debug, Clone, Copy)]
struct Score {
    /// Whether the unit is nearer to its stop than the margin.
    at_stop: bool,
    /// The legs of the way out.
    legs: usize,
    /// Between the unit and the way out: others that made room have their turn.
    clearance: f64,
}

impl Score {
    fn is_better(self, than: Self) -> bool {
        let (here, there) = ((self.at_stop, self.legs), (than.at_stop, than.legs));
        here < there || here == there && self.clearance > LARGER * than.clearance
    }
}

/// How a group leaves once others have moved, in the direction of a step that is known if it can.
type Asked<'a> = dyn FnMut(&Moved, &Step) -> Result<Option<Step>, AssemblyError> + 'a;

/// The best of places of the units that have made room, one after the other: where they are, and farther on.
pub(super) fn wider(
    units: &Units,
    set: Set,
    moving: Set,
    (mut moved, mut step): (Moved, Step),
    leaves: &mut Asked<'_>,
) -> Result<(Moved, Step), AssemblyError> {
    for k in 0..moved.went.len() {
        let (travel, found) = moved.went[k].clone();
        let mut best = score(&moved, moving, &step, &travel, found)?;
        for to in farther(&travel, found) {
            let mut places = moved.went.clone();
            places[k].1 = to;
            let Some(next) = again(units, set, &places)? else {
                continue;
            };
            let Some(way) = leaves(&next, &step)? else {
                continue;
            };
            let score = score(&next, moving, &way, &travel, to)?;
            if score.is_better(best) {
                (moved, step, best) = (next, way, score);
            }
        }
    }
    Ok((moved, step))
}

/// Where a unit stops on the side to which it has moved.
fn stop(travel: &Travel, to: f64) -> f64 {
    match to < travel.from {
        true => travel.free.0,
        false => travel.free.1,
    }
}

/// Places to try: with the margin to the stop, and halfway to there; of what has gone farther, halfway to the stop.
fn farther(travel: &Travel, found: f64) -> Vec<f64> {
    let stop = stop(travel, found);
    let last = travel.from + (1.0 - MARGIN) * (stop - travel.from);
    let is_beyond = (found - travel.from).abs() > (last - travel.from).abs();
    let is_new = |to: &f64| travel.moves(*to) && travel.differ(*to, found);
    let halfway = 0.5 * (found + if is_beyond { stop } else { last });
    let places = [halfway, last];
    places.into_iter().filter(is_new).collect()
}

/// Units moved to other places on the same ways; none if one does not get there.
fn again(
    units: &Units,
    set: Set,
    places: &[(Travel, f64)],
) -> Result<Option<Moved>, AssemblyError> {
    let mut moved = Moved::none(units);
    for (travel, to) in places {
        match travel.again(&moved.units, set)? {
            Some(travel) if (travel.free.0..=travel.free.1).contains(to) => {
                moved = moved.then(set, travel, *to)?;
            }
            _ => return Ok(None),
        }
    }
    Ok(Some(moved))
}

fn score(
    moved: &Moved,
    moving: Set,
    step: &Step,
    travel: &Travel,
    to: f64,
) -> Result<Score, AssemblyError> {
    let (unit, mover) = (
        moved.units.together(1 << travel.unit)?,
        moved.units.together(moving)?,
    );
    let scene = Scene::new(&unit, &mover, None).with_about(step.path.about);
    let places: Vec<Coords> = (step.path.configurations.iter())
        .filter_map(|&at| scene.numbers(at).ok())
        .collect();
    let end = stop(travel, to);
    Ok(Score {
        // Half of the margin tells one that is kept from one that is not.
        at_stop: (end - to).abs() < 0.5 * MARGIN * (end - travel.from).abs(),
        legs: places.len().saturating_sub(1),
        clearance: told(&scene, places).narrowest.clearance,
    })
}

//! Parts that fit exactly: nominal on nominal, as a key in its slot, a pin in its hole or the pieces of a jigsaw are drawn first.
//!
//! They touch and do not overlap, and their contact space has no room there: a configuration of the exact fit alone is free. What a part can
//! do from there is answered for a part that is smaller by a gap.

use cspace::{Coordinates, Location, PairError, PairSpace, Part, Progress, QueryError};

use crate::assembly::{GAP, inset};
use crate::clash::TOUCHING;
use crate::legs::Scene;
use crate::widest::with_moving;

/// Whether the parts of a pair touch at a configuration at which its space has no room, and overlap by no more than rounding: they fit
/// exactly. `false` of a lower pair.
///
/// ```
/// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};
/// let slot = [(-9.0, -9.0), (9.0, -9.0), (9.0, 0.0), (5.0, 0.0), (5.0, -5.0), (-5.0, -5.0), (-5.0, 0.0), (-9.0, 0.0)];
/// let slot = Part::polygon("slot", &slot)?;
/// let key = Part::rectangle("key", (0.0, 0.0), 10.0, 10.0)?;
/// let space = PairSpace::compute(&slot, &key, Relation::Planar, &Options::default())?;
/// let at = |y| Coordinates::Planar(Configuration::new(0.0, y, 0.0));
/// assert!(cspace_plan::fits_exactly(&space, at(0.0))?);
/// assert!(!cspace_plan::fits_exactly(&space, at(-0.001))?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the coordinates are not those of the pair's class, or not finite.
pub fn fits_exactly(space: &PairSpace, at: Coordinates) -> Result<bool, QueryError> {
    if matches!(space, PairSpace::Lower(_)) || space.locate(at)? != Location::Blocked {
        return Ok(false);
    }
    let scene = Scene::of(space)?;
    let touch = touching_distance(space.fixed(), space.moving());
    // A contact beside free space is none of an exact fit.
    Ok(scene.touches(scene.numbers(at)?, touch) && space.contacts(at, touch)?.is_empty())
}

/// The distance within which two parts touch, in the model's unit of length: a little more than contacts are known to.
pub fn touching_distance(fixed: &Part, moving: &Part) -> f64 {
    TOUCHING * fixed.size().max(moving.size())
}

/// A part that fits exactly into another, smaller by a gap all around, and the gap, in the model's unit of length: a millionth of the size
/// of the larger. `None` if an edge is too small for it.
pub fn with_gap(fixed: &Part, moving: &Part) -> Option<(Part, f64)> {
    with_share_of_gap(fixed, moving, 1.0)
}

fn with_share_of_gap(fixed: &Part, moving: &Part, share: f64) -> Option<(Part, f64)> {
    let gap = share * GAP * fixed.size().max(moving.size());
    let smaller = inset(moving, gap).ok().flatten()?;
    Some((smaller, gap))
}

/// The spaces of a pair with a moving part that is smaller by a gap, and by half of it, and the gap, where the parts fit exactly at a
/// configuration; `None` where they do not, and where an edge is too small for it. What the two differ by is what the gap does.
///
/// # Errors
/// If the space cannot be computed, or the progress ends that.
pub fn with_room(
    space: &PairSpace,
    at: Coordinates,
    progress: &dyn Progress,
) -> Result<Option<([PairSpace; 2], f64)>, PairError> {
    if !fits_exactly(space, at).unwrap_or(false) {
        return Ok(None);
    }
    let smaller = |share| with_share_of_gap(space.fixed(), space.moving(), share);
    let (Some((whole, gap)), Some((half, _))) = (smaller(1.0), smaller(0.5)) else {
        return Ok(None);
    };
    let roomy = [&whole, &half].map(|part| with_moving(space, part, progress));
    Ok(match roomy {
        [Ok(Some(whole)), Ok(Some(half))] => Some(([whole, half], gap)),
        [Err(error), _] | [_, Err(error)] => return Err(error),
        _ => None,
    })
}

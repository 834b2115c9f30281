//! The largest clearance of a way, by growing the moving part.

use cspace::{Options, PairError, PairSpace, Progress, Relation};

use crate::legs::{Coords, Scene};
use crate::path::Legs;

use super::grow::grown;

/// A clearance is known to this share of the parts' size.
const RESOLUTION: f64 = 1e-10;
/// Clearances are tried at least this share away from those known.
const APART: f64 = 0.1;
/// The part is grown so often at most.
const MOST: usize = 128;

/// When a way is wide enough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Until {
    /// It has half the clearance that is possible.
    Half,
    /// It has a clearance, or none has.
    AtLeast(f64),
    /// None has more.
    Widest,
}

/// What is known of the ways between two configurations.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wider {
    /// The places of the way with the most clearance that was found.
    pub(crate) places: Vec<Coords>,
    /// Its clearance.
    pub(crate) clearance: f64,
    /// No way has more than this.
    pub(crate) most: f64,
}

impl Wider {
    /// A way of which no more is known than its clearance and that at its ends.
    pub(crate) fn of(scene: &Scene, places: Vec<Coords>) -> Self {
        let ends = [places.first(), places.last()]
            .map(|at| at.map_or(f64::INFINITY, |&at| scene.clearance(at)));
        let clearance = if places.is_empty() {
            0.0
        } else {
            clearance(scene, &places)
        };
        Self {
            clearance,
            places,
            most: ends[0].min(ends[1]),
        }
    }
}

/// Ways with more clearance than a given one. `between` finds a way in the space of the grown part, or that there is none.
///
/// # Errors
/// Of the computation of a grown pair; and what `progress` returns.
pub(crate) fn widen(
    space: &PairSpace,
    scene: &Scene,
    first: Vec<Coords>,
    until: Until,
    progress: &dyn Progress,
    between: impl Fn(&PairSpace) -> Option<Vec<Coords>>,
) -> Result<Wider, PairError> {
    let mut known = Wider::of(scene, first);
    let exact = RESOLUTION * scene.size();
    // Legs that pass with a radius have it for their clearance but for rounding.
    let mut passes = known.clearance;
    let mut tries = 0;
    while known.most - passes > exact && tries < MOST {
        let (lo, hi) = (passes, known.most);
        let radius = match until {
            Until::Half if 2.0 * lo >= hi => break,
            Until::Half => 2.0 * lo,
            Until::AtLeast(least) if lo >= least || hi < least => break,
            Until::AtLeast(least) => least,
            // Just more than is known, which often is all there is; just less than the most there could be; and the middle.
            Until::Widest => match tries % 4 {
                0 => lo + exact.max(4.0 * f64::EPSILON * hi),
                1 if tries == 1 => hi - exact,
                _ if lo < APART * hi => (lo.max(exact) * hi).sqrt(),
                _ => 0.5 * (lo + hi),
            },
        };
        tries += 1;
        let Some(wide) = wider(space, radius, progress)? else {
            known.most = radius;
            continue;
        };
        match between(&wide) {
            Some(places) => {
                known.clearance = clearance(scene, &places);
                known.places = places;
                passes = known.clearance.max(radius);
            }
            None => known.most = radius,
        }
    }
    Ok(known)
}

/// The pair with the moving part grown. `None` if it is so large that it is no part.
fn wider(
    space: &PairSpace,
    radius: f64,
    progress: &dyn Progress,
) -> Result<Option<PairSpace>, PairError> {
    let Ok(moving) = grown(space.moving(), radius) else {
        return Ok(None);
    };
    let (relation, options) = match space {
        PairSpace::Planar(space) => {
            let window = space.window();
            let options = Options {
                window: (!window.full_turn).then_some((window.lo, window.hi)),
                ..Options::default()
            };
            (Relation::Planar, options)
        }
        PairSpace::FixedAxes(space) => {
            let (fixed, moving) = space.axes();
            (Relation::Axes { fixed, moving }, Options::default())
        }
        PairSpace::Lower(_) => return Ok(None),
    };
    PairSpace::compute_with(space.fixed(), &moving, relation, &options, progress).map(Some)
}

fn clearance(scene: &Scene, places: &[Coords]) -> f64 {
    Legs::new(scene, places.to_vec())
        .narrowest()
        .map_or(0.0, |n| n.1.distance)
}

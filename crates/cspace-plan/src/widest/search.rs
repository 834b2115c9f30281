//! The largest clearance of a way, by growing the moving part.

use cspace::{Options, PairError, PairSpace, Part, Progress, Relation};

use crate::legs::{Coords, Scene};
use crate::path::Legs;

use super::grow::grown;

/// A clearance is known to this share of the parts' size.
const RESOLUTION: f64 = 1e-10;
/// A way that has more clearance than a bound by this share, of both the clearance and the parts' size, refutes it. Distances along
/// legs are right to it.
const ROUNDING: f64 = 1e-6;
/// Clearances are tried at least this share away from those known.
const APART: f64 = 0.1;
/// The part is grown so often at most.
const MOST: usize = 128;
/// And no more after so many ways that are there, but that rounding hides.
const MOST_HIDDEN: usize = 3;

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

/// Paths known between two configurations, with bounds of their clearance.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wider {
    /// The places of the way with the most clearance that was found; none if none was.
    pub(crate) places: Vec<Coords>,
    /// Its clearance, or 0.
    pub(crate) clearance: f64,
    /// No way has more than this.
    pub(crate) most: f64,
    /// Some way has this, found or not.
    passes: f64,
    /// The clearance at the ends, which no way has more of.
    at_ends: f64,
}

/// Result of a search for a path in the space of the grown part.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Between {
    /// A way.
    Way(Vec<Coords>),
    /// There is none: start and goal are not in one free region.
    None,
    /// There is one by the space, but its legs were not found. It bounds nothing.
    Hidden,
}

impl Wider {
    /// Two configurations of which no more is known than the clearance there.
    pub(crate) fn unknown(scene: &Scene, [first, last]: [Coords; 2]) -> Self {
        let at_ends = scene.clearance(first).min(scene.clearance(last));
        Self {
            places: Vec::new(),
            clearance: 0.0,
            most: at_ends,
            passes: 0.0,
            at_ends,
        }
    }

    /// With a way, if it is the first or has more clearance. A bound that it refutes is one no more.
    pub(crate) fn with(mut self, scene: &Scene, places: Vec<Coords>) -> Self {
        let found = clearance(scene, &places);
        if self.places.is_empty() || found > self.clearance {
            self.clearance = found;
            self.places = places;
        }
        if found > self.most * (1.0 + ROUNDING) + ROUNDING * scene.size() {
            self.most = self.at_ends;
        }
        self.most = self.most.max(found);
        self.passes = self.passes.max(found);
        self
    }
}

/// Ways between two configurations with more clearance than is known. `between` finds a way in the space of the grown part, or that
/// there is none.
///
/// # Errors
/// If a grown pair cannot be computed; and errors that `progress` returns.
pub(crate) fn widen(
    space: &PairSpace,
    scene: &Scene,
    mut known: Wider,
    until: Until,
    progress: &dyn Progress,
    between: impl Fn(&PairSpace) -> Between,
) -> Result<Wider, PairError> {
    let exact = RESOLUTION * scene.size();
    // Larger radii are not tried: no way has them, or the grown part is none.
    let mut ceiling = known.most;
    let (mut tries, mut hidden) = (0, 0);
    while ceiling - known.passes > exact && tries < MOST && hidden < MOST_HIDDEN {
        let (lo, hi) = (known.passes, ceiling);
        let radius = match until {
            Until::Half if 2.0 * lo >= hi => break,
            Until::Half => (2.0 * lo).max(exact),
            Until::AtLeast(least) if lo >= least || hi <= least => break,
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
            ceiling = radius;
            continue;
        };
        match between(&wide) {
            Between::Way(places) => {
                let most = known.most;
                known = known.with(scene, places);
                // Legs that pass with a radius have it for their clearance but for rounding.
                known.passes = known.passes.max(radius);
                if known.most > most {
                    ceiling = known.most;
                }
            }
            Between::None => {
                known.most = radius.max(known.clearance);
                ceiling = radius;
            }
            Between::Hidden => {
                known.passes = radius;
                hidden += 1;
            }
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
    with_moving(space, &moving, progress)
}

/// The space of a pair with a moving part in place of its own; `None` of a lower pair.
pub(crate) fn with_moving(
    space: &PairSpace,
    moving: &Part,
    progress: &dyn Progress,
) -> Result<Option<PairSpace>, PairError> {
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
    PairSpace::compute_with(space.fixed(), moving, relation, &options, progress).map(Some)
}

fn clearance(scene: &Scene, places: &[Coords]) -> f64 {
    Legs::new(scene, places.to_vec())
        .narrowest()
        .map_or(0.0, |n| n.1.distance)
}

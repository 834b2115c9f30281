//! The most room that a part has in some position: the largest clearance of a configuration within a box of positions and orientations.
//!
//! There is a configuration with a clearance of more than r if and only if the moving part, grown by r, is free somewhere in the box. That
//! is decided by a contact space: of the grown part, and a disc on it in a frame, which hold it in the box. So the room is enclosed
//! between a configuration that is found and a radius for which there is none; nothing is sampled to decide it. Below 0, where the part is
//! free nowhere, it is the part shrunk by r.
//!
//! ```
//! use cspace::{Configuration, Options, PairSpace, Part, Relation, Silent};
//! use cspace_plan::fits::fits;
//! // A square of 2 in a square hole of 2.2, drawn off its middle: in the middle it has 0.1 all around.
//! let hole = vec![cspace::part::polygon_loop(&[(-1.1, -1.1), (1.1, -1.1), (1.1, 1.1), (-1.1, 1.1)])];
//! let plate = vec![cspace::part::polygon_loop(&[(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)])];
//! let plate = Part::new("plate", plate.into_iter().chain(hole).collect())?;
//! let peg = Part::rectangle("peg", (0.0, 0.0), 2.0, 2.0)?;
//! let space = PairSpace::compute(&plate, &peg, Relation::Planar, &Options::default())?;
//! let off = Configuration::new(0.05, 0.08, 0.02);
//! let found = fits(&space, off, [0.2, 0.2, 0.1], &Silent)?.ok_or("it is planar")?;
//! assert!((found.clearance - 0.1).abs() < 1e-7 && (found.most - 0.1).abs() < 1e-7);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod held;

use core::f64::consts::{PI, TAU};

use cspace::{Configuration, FeatureName, PairSpace, Part, PartError, Progress, Window};

use crate::legs::{Coords, Scene};
use crate::push::Climb;
use crate::widest::{grown, shrunk};

pub use error::FitError;

use held::Held;

/// The room is enclosed to this share of the parts' size: grown outlines are right to a tenth of it.
const EXACT: f64 = 1e-9;
/// So many spaces are computed at most: a bisection from the size of the parts takes 30.
const MOST_SPACES: usize = 64;
/// The first share of the size by which a part is shrunk that is free nowhere, and how much more each time.
const FIRST: f64 = 1e-4;
const MORE: f64 = 8.0;
/// An outline that cannot be grown by a distance can be by one that is this share of the size more, times 1, 2, 3.
const NEXT: f64 = 1e-10;
/// Steps towards more clearance from one configuration, each of which gains at least a share.
const STEPS: usize = 200;
const GAIN: f64 = 1e-12;

/// The most room in a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// The clearance at the configuration, in the model's unit of length; where the part is free nowhere, less than 0: shrunk by more it is
    /// free there.
    pub clearance: f64,
    /// Some configuration in the box has as much for certain,
    pub least: f64,
    /// and none has more than this.
    pub most: f64,
    /// The configuration.
    pub at: Configuration,
    /// The features that are nearest there, of the fixed and of the moving part.
    pub features: Option<[FeatureName; 2]>,
}

/// The largest clearance of a planar pair at a configuration that is no farther from one than `within`, in x, y and θ: each not negative;
/// `None` of another pair.
///
/// # Errors
/// If a space cannot be computed, or the progress ends that.
pub fn fits(
    space: &PairSpace,
    around: Configuration,
    within: [f64; 3],
    progress: &dyn Progress,
) -> Result<Option<Fit>, FitError> {
    let (PairSpace::Planar(planar), Ok(scene)) = (space, Scene::of(space)) else {
        return Ok(None);
    };
    let parts = [planar.fixed(), planar.moving()];
    let size = scene.size();
    // A box of no extent in a coordinate has no free space in it: what is this little farther has the same room but for as little.
    let least = [EXACT * size, EXACT * size, EXACT];
    let (from, to) = orientations(planar.window(), around.theta, within[2])?;
    let middle = [around.x, around.y, 0.5 * (from + to)];
    let within = [within[0], within[1], 0.5 * (to - from)];
    let half: Coords = core::array::from_fn(|k| within[k].max(least[k]));
    let search = Search {
        held: Held {
            parts,
            middle,
            half,
        },
        limits: core::array::from_fn(|k| (middle[k] - half[k], middle[k] + half[k])),
        size,
        progress,
    };
    search.most(&scene.with_limits(search.limits)).map(Some)
}

/// The orientations that are no farther from one than `within`, and in the window of a space.
fn orientations(window: Window, theta: f64, within: f64) -> Result<(f64, f64), FitError> {
    let within = within.min(PI);
    let (lo, hi) = (theta - within, theta + within);
    if window.full_turn {
        return Ok((lo, hi));
    }
    let turns = TAU * ((0.5 * (window.lo + window.hi) - theta) / TAU).round();
    let (lo, hi) = (lo.max(window.lo - turns), hi.min(window.hi - turns));
    match lo <= hi {
        true => Ok((lo, hi)),
        false => Err(FitError::Outside),
    }
}

struct Search<'a> {
    held: Held<'a>,
    limits: [(f64, f64); 3],
    size: f64,
    progress: &'a dyn Progress,
}

impl Search<'_> {
    /// The most room, with a scene that is limited to the box.
    fn most(&self, scene: &Scene) -> Result<Fit, FitError> {
        let exact = EXACT * self.size;
        let Held { middle, half, .. } = self.held;
        let levers = scene.levers();
        let across = half[0].hypot(half[1]) + levers[2] * half[2];
        // A point of the part goes no farther than across the box, and what is more the part has where it begins.
        let begins = (!scene.overlaps(middle)).then(|| scene.clearance(middle));
        let (mut at, mut lo, mut hi) = (middle, f64::NEG_INFINITY, begins.unwrap_or(0.0) + across);
        if begins.is_some() {
            (lo, at) = climbed(scene, middle);
        } else {
            match self.free(0.0)? {
                (_, Some(place)) => (lo, at) = climbed(scene, place),
                (_, None) => {
                    hi = 0.0;
                    let mut by = -FIRST * self.size;
                    while lo.is_infinite() {
                        match self.free(by)? {
                            (used, Some(place)) => (lo, at) = (used, place),
                            (used, None) => (hi, by) = (used, MORE * by),
                        }
                    }
                }
            }
        }
        let mut guess = match lo < 0.0 {
            true => self.guess(lo, at).unwrap_or(lo),
            false => lo,
        };
        for tried in 0..MOST_SPACES {
            if hi - lo <= exact {
                break;
            }
            let middle = 0.5 * (lo + hi);
            // Just more than is known to be there, which often is all there is; then what halves the rest.
            let by = match tried % 3 {
                0 => guess + 0.75 * exact,
                1 if guess > lo => guess - 0.125 * exact,
                _ => middle,
            };
            let by = if lo < by && by < hi { by } else { middle };
            match self.free(by)? {
                (used, None) => hi = hi.min(used),
                (used, Some(place)) if used < 0.0 => {
                    (lo, at) = (lo.max(used), place);
                    guess = self.guess(lo, at).unwrap_or(lo);
                }
                (used, Some(place)) => {
                    let (clearance, there) = climbed(scene, place);
                    // The grown part is free there, so that this is more than the radius but for rounding.
                    (lo, at) = (lo.max(used).max(clearance), there);
                    guess = lo;
                }
            }
        }
        let features = (lo >= 0.0).then(|| scene.nearest_places(at)).flatten();
        Ok(Fit {
            clearance: guess.clamp(lo, hi.max(lo)),
            least: lo,
            most: hi.max(lo),
            at: Configuration::new(at[0], at[1], at[2]),
            features: features.map(|((fixed, moving), _)| [fixed, moving]),
        })
    }

    /// Where in the box the moving part is free that is grown by a distance, or shrunk by one below 0; and the distance that was taken.
    fn free(&self, by: f64) -> Result<(f64, Option<Coords>), FitError> {
        let mut failure = None;
        for more in 0..4 {
            let by = by + f64::from(more) * NEXT * self.size;
            match changed(self.held.parts[1], by) {
                Ok(Some(part)) => return Ok((by, self.held.free(&part, self.progress)?)),
                // A part of which nothing is left is free anywhere.
                Ok(None) => return Ok((by, Some(self.held.middle))),
                Err(error) => failure = Some(error),
            }
        }
        match failure {
            Some(error) => Err(error.into()),
            None => Ok((by, None)),
        }
    }

    /// Likely room where a part shrunk by a distance is free at a configuration: more by the clearance that it finds from there.
    fn guess(&self, by: f64, at: Coords) -> Option<f64> {
        let part = changed(self.held.parts[1], by).ok()??;
        let scene = Scene::new(self.held.parts[0], &part, None).with_limits(self.limits);
        (!scene.overlaps(at)).then(|| by + climbed(&scene, at).0)
    }
}

/// A part grown by a distance, or shrunk by one below 0; none if nothing is left.
fn changed(part: &Part, by: f64) -> Result<Option<Part>, PartError> {
    if by > 0.0 {
        grown(part, by).map(Some)
    } else if by < 0.0 {
        shrunk(part, -by)
    } else {
        Ok(Some(part.clone()))
    }
}

/// More clearance from a configuration on, and where.
fn climbed(scene: &Scene, from: Coords) -> (f64, Coords) {
    let at = scene.within_limits(from);
    let mut climb = Climb {
        at,
        clearance: scene.clearance(at),
        reach: 0.25 * scene.size(),
    };
    if scene.overlaps(at) {
        // A place in contact, to rounding.
        return (0.0, at);
    }
    let accepts = |to: Coords, _: f64| !scene.overlaps(to);
    for _ in 0..STEPS {
        if !climb.step(scene, scene.levers(), None, GAIN, accepts) {
            break;
        }
    }
    (climb.clearance, climb.at)
}

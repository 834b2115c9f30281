//! Whether one set of units can be taken out of another, by their contact space.

use std::collections::BTreeSet;

use cspace::{
    Configuration, Coordinates, Location, Options, PairSpace, Part, Progress, RegionId, Relation,
    Vector,
};

use crate::answer::{Path, Verdict};
use crate::planner::{Clearance, Planner, Wishes};

use super::answer::{Enclosure, Step};
use super::error::AssemblyError;
use super::straight::straight;
use super::units::{Set, Units};

/// Whether one set can be taken out of another.
#[derive(Debug, Clone)]
pub(super) enum Leaves {
    /// By this step.
    By(Box<Step>),
    /// It is enclosed.
    Not(Box<Enclosure>),
    /// It is not known.
    Unsure,
}

/// Discs around the parts are this much farther apart than they need be, as a share of their radii.
const APART: f64 = 0.1;

/// Asks the contact space of the staying and the moving units: they leave if and only if they are drawn in the region that goes on
/// without limit.
pub(super) fn leaves(
    units: &Units,
    (moving, staying): (Set, Set),
    progress: &dyn Progress,
) -> Result<Leaves, AssemblyError> {
    let (fixed, mover) = (units.together(staying)?, units.together(moving)?);
    let options = Options::default();
    let space = PairSpace::compute_with(&fixed, &mover, Relation::Planar, &options, progress)?;
    let drawn = Coordinates::Planar(Configuration::default());
    let Location::Free(region) = space.locate(drawn)? else {
        return Ok(Leaves::Unsure);
    };
    let sets = (moving, staying);
    if !(space.regions().get(region.index())).is_some_and(|r| r.unbounded) {
        return Ok(Leaves::Not(Box::new(enclosure(
            units, sets, &space, region,
        )?)));
    }
    let away = Away::new(&fixed, &mover);
    if let Some(path) = straight((&fixed, &mover), |d| away.distance(d)) {
        return Ok(Leaves::By(Box::new(step(units, sets, path))));
    }
    let planner = Planner::new(&space)?;
    let wishes = Wishes {
        clearance: Clearance::Quick,
        ..Wishes::default()
    };
    let far = Coordinates::Planar(away.farthest());
    let answer = planner.plan_with(drawn, far, &wishes, progress)?;
    Ok(match answer.verdict {
        Verdict::Path(path) => Leaves::By(Box::new(step(units, sets, path))),
        _ => Leaves::Unsure,
    })
}

fn step(units: &Units, (moving, staying): (Set, Set), path: Path) -> Step {
    Step {
        moving: units.parts_of(moving),
        staying: units.parts_of(staying),
        path,
    }
}

/// Discs around two parts.
struct Away {
    /// From the middle of the fixed part to that of the moving one.
    between: Vector,
    /// How far the middles have to be apart.
    apart: f64,
}

impl Away {
    fn new(fixed: &Part, moving: &Part) -> Self {
        let disc = |part: &Part| (part.bounds().center(), 0.5 * part.bounds().diagonal());
        let ((from, r), (at, s)) = (disc(fixed), disc(moving));
        Self {
            between: at - from,
            apart: (r + s) * (1.0 + APART),
        }
    }

    /// How far it is in a unit direction until the discs are apart.
    fn distance(&self, direction: Vector) -> f64 {
        let along = self.between.dot(direction);
        let across = self.between.cross(direction);
        let root = (self.apart * self.apart - across * across).max(0.0).sqrt();
        (root - along).max(0.0)
    }

    /// Where they are apart, in the direction in which the one lies from the other.
    fn farthest(&self) -> Configuration {
        let direction = if self.between.length() > 1e-3 * self.apart {
            self.between.unit()
        } else {
            Vector::new(0.0, 1.0)
        };
        let to = direction * self.distance(direction);
        Configuration::new(to.x, to.y, 0.0)
    }
}

fn enclosure(
    units: &Units,
    (moving, staying): (Set, Set),
    space: &PairSpace,
    region: RegionId,
) -> Result<Enclosure, AssemblyError> {
    let mut features = BTreeSet::new();
    let mut patches = 0;
    for patch in space.patches() {
        if patch.region()? == Some(region) {
            patches += 1;
            let (fixed, mover) = patch.features()?;
            features.insert((
                units.drawn(staying, fixed.name),
                units.drawn(moving, mover.name),
            ));
        }
    }
    Ok(Enclosure {
        moving: units.parts_of(moving),
        staying: units.parts_of(staying),
        patches,
        features: features.into_iter().collect(),
        doubtful: match space {
            PairSpace::Planar(space) => space.doubtful_orientations().to_vec(),
            _ => Vec::new(),
        },
    })
}

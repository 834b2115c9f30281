//! Whether one set of units can be taken out of another, by their contact space.

use std::collections::BTreeSet;

use cspace::{
    Configuration, Coordinates, Location, Options, PairSpace, Progress, RegionId, Relation,
};

use crate::answer::{Path, Verdict};
use crate::planner::{Clearance, Planner, Wishes};

use super::answer::{Enclosure, Step};
use super::error::AssemblyError;
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
    let planner = Planner::new(&space)?;
    let wishes = Wishes {
        clearance: Clearance::Quick,
        ..Wishes::default()
    };
    let (_, answer) = planner.plan_out(drawn, &wishes, progress)?;
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

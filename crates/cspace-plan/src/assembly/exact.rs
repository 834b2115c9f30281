//! Whether one set of units can be taken out of another, by their contact space.

use std::collections::BTreeSet;

use cspace::{
    Configuration, Coordinates, Location, Options, PairSpace, Part, Progress, RegionId, Relation,
    Vector,
};

use crate::answer::{Path, Verdict};
use crate::path::Prefer;
use crate::planner::{Clearance, Planner, Wishes};

use super::answer::{Enclosure, Kind, Step};
use super::error::AssemblyError;
use super::units::{Set, Units};
use super::way_out::{path, straight, until_out};

/// Whether one set can be taken out of another.
#[derive(Debug)]
pub(super) enum Leaves {
    /// It can.
    By(Box<Way>),
    /// It is enclosed.
    Not(Box<Enclosure>),
    /// It is not known.
    Unsure,
}

/// Proof that there is a path.
#[derive(Debug)]
pub(super) struct Way {
    sets: (Set, Set),
    parts: (Part, Part),
    space: PairSpace,
}

/// Asks the contact space of the staying and the moving units: they leave if and only if they are in the region that goes on without
/// limit.
pub(super) fn leaves(
    units: &Units,
    sets: (Set, Set),
    progress: &dyn Progress,
) -> Result<Leaves, AssemblyError> {
    let (moving, staying) = sets;
    let parts = (units.together(staying)?, units.together(moving)?);
    let options = Options::default();
    let space = PairSpace::compute_with(&parts.0, &parts.1, Relation::Planar, &options, progress)?;
    let Location::Free(region) = space.locate(HERE)? else {
        return Ok(Leaves::Unsure);
    };
    if (space.regions().get(region.index())).is_some_and(|r| r.unbounded) {
        return Ok(Leaves::By(Box::new(Way { sets, parts, space })));
    }
    let why = enclosure(units, sets, &space, region)?;
    Ok(Leaves::Not(Box::new(why)))
}

/// Where units are before they move.
const HERE: Coordinates = Coordinates::Planar(Configuration::new(0.0, 0.0, 0.0));

impl Way {
    /// The step; none if rounding hides the way.
    pub(super) fn step(
        &self,
        units: &Units,
        progress: &dyn Progress,
    ) -> Result<Option<Step>, AssemblyError> {
        let planner = Planner::new(&self.space)?;
        let wishes = Wishes {
            clearance: Clearance::Quick,
            prefer: Prefer::Legs,
            ..Wishes::default()
        };
        let (_, answer) = planner.plan_out(HERE, &wishes, progress)?;
        let Verdict::Path(path) = answer.verdict else {
            return Ok(None);
        };
        let path = until_out(&self.parts.0, &self.parts.1, path);
        Ok(Some(leaving(units, self.sets, path)))
    }
}

/// The step by which units leave others on a straight way, if there is one.
pub(super) fn leaves_straight(
    units: &Units,
    (moving, staying): (Set, Set),
) -> Result<Option<Step>, AssemblyError> {
    let (fixed, mover) = (units.together(staying)?, units.together(moving)?);
    let exit = straight(&fixed, &mover).next();
    Ok(exit.map(|exit| leaving(units, (moving, staying), path(&fixed, &mover, exit))))
}

/// As [`leaves_straight`], in the direction of another straight step where that is a way.
pub(super) fn leaves_straight_like(
    units: &Units,
    (moving, staying): (Set, Set),
    like: &Step,
) -> Result<Option<Step>, AssemblyError> {
    /// Directions are the same within this sine of an angle.
    const SAME: f64 = 1e-9;
    let along = match like.path.configurations[..] {
        [Coordinates::Planar(a), Coordinates::Planar(b)] if a.theta == b.theta => {
            (b.position() - a.position()).unit()
        }
        _ => return leaves_straight(units, (moving, staying)),
    };
    let (fixed, mover) = (units.together(staying)?, units.together(moving)?);
    let is_same = |d: Vector| d.dot(along) > 0.0 && d.cross(along).abs() < SAME;
    let exit = straight(&fixed, &mover).find(|exit| is_same(exit.direction));
    match exit {
        Some(exit) => {
            let path = path(&fixed, &mover, exit);
            Ok(Some(leaving(units, (moving, staying), path)))
        }
        None => leaves_straight(units, (moving, staying)),
    }
}

fn leaving(units: &Units, (moving, staying): (Set, Set), path: Path) -> Step {
    Step {
        kind: Kind::Leaves,
        moving: units.parts_of(moving),
        staying: units.parts_of(staying),
        path,
        onward: Vector::ZERO,
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

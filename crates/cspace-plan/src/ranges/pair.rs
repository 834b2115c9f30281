//! Two parts on axes, and what they are to each other over their ranges.

use cspace::{
    Axis, Coordinates, FixedAxesSpace, Options, PairError, PairSpace, Part, RegionId, Relation,
};
use cspace_model::{Compute, PartEntry};

use crate::exact_fit::{fits_exactly, with_gap};
use crate::legs::Scene;

use super::answer::{Held, Verdict};
use super::descent::coords;
use super::gap::smallest;
use super::mesh::{Mesh, mesh, turn_not_alone};
use super::reach::{reach, stops, touching};
use super::region::{bounding, is_bounded, regions};

/// Two parts on axes and where they are.
#[derive(Debug, Clone, Copy)]
pub struct Pair<'a> {
    parts: [&'a Part; 2],
    axes: [Axis; 2],
    place: [f64; 2],
}

impl<'a> Pair<'a> {
    /// The fixed and the moving part at motions u and v of them; none if one has no axis. A motion outside of a part's range is that of the
    /// nearer end of it.
    pub fn new(parts: [&'a PartEntry; 2], place: [f64; 2]) -> Option<Self> {
        let axes = [parts[0].axis?, parts[1].axis?];
        let held = |k: usize| match axes[k].range {
            Some((lo, hi)) if lo <= hi => place[k].clamp(lo, hi),
            _ => place[k],
        };
        Some(Self {
            parts: parts.map(|entry| &entry.part),
            axes,
            place: [held(0), held(1)],
        })
    }

    /// Where the parts are.
    pub fn place(&self) -> [f64; 2] {
        self.place
    }

    /// Finds what the parts, which do not overlap where they are, are to each other over all motions that their ranges allow; spaces come
    /// from `compute`. A smallest gap of `within` or more is not looked for.
    ///
    /// # Errors
    /// Errors of `compute`.
    pub fn over_ranges(&self, within: f64, compute: &Compute<'_>) -> Result<Verdict, PairError> {
        let [fixed, moving] = self.axes;
        let relation = Relation::Axes { fixed, moving };
        let with = |part: &Part| compute(self.parts[0], part, relation, &Options::default());
        let drawn = with(self.parts[1])?;
        let [u, v] = self.place;
        let at = Coordinates::Axes { u, v };
        // Parts that fit exactly have no room: what a part can do is that of one that is smaller by a gap.
        let roomy = match fits_exactly(&drawn, at).unwrap_or(false) {
            true => match with_gap(self.parts[0], self.parts[1]) {
                Some((smaller, gap)) => Some((with(&smaller)?, gap)),
                None => None,
            },
            false => None,
        };
        let room = roomy.as_ref().map(|r| r.1);
        let PairSpace::FixedAxes(space) = roomy.as_ref().map_or(&drawn, |r| &r.0) else {
            return Ok(Verdict::Undecided("their motions are not on axes"));
        };
        if space.statistics().conflicts > 0 {
            return Ok(Verdict::Undecided(
                "some of their features lie closer than can be told apart",
            ));
        }
        let regions = regions(space, self.place);
        if regions.is_empty() {
            return Ok(Verdict::Undecided(
                "where they are is in no free region that could be found",
            ));
        }
        if room.is_none() && !is_bounded(space, &regions) {
            return smallest(space, self.place, within, &with);
        }
        self.held(space, &regions, room, compute)
            .map(Verdict::Touches)
    }

    fn held(
        &self,
        space: &FixedAxesSpace,
        regions: &[RegionId],
        room: Option<f64>,
        compute: &Compute<'_>,
    ) -> Result<Held, PairError> {
        let reach = reach(space, regions, self.place);
        let stopped = stops(space, regions, reach, self.place);
        let mesh = match turn_not_alone(space, self.place) {
            true => self.meshed(space, compute)?,
            false => None,
        };
        let place = (self.place[0], self.place[1]);
        let nearest = || space.nearest_contact(place.0, place.1).map(|n| n.at);
        let at = match stopped.first() {
            Some(stop) => Some(stop.at),
            None if room.is_some() => Some(place),
            None => nearest().or_else(|| Some(bounding(space, regions).next()?.start)),
        };
        let scene = || Scene::new(self.parts[0], self.parts[1], Some(space.axes()));
        let points = at.and_then(|(u, v)| Some(scene().nearest_places(coords([u, v]))?.1));
        Ok(Held {
            room,
            points: points.map(|(p, q)| [p, q]),
            reach,
            ratio: mesh.as_ref().map(|m| m.ratio),
            backlash: mesh.and_then(|m| m.backlash),
            features: at.map_or(Vec::new(), |at| touching(space, at, regions)),
            at,
            stopped,
        })
    }

    /// How the parts of a space turn together: as they do without their ranges, in which nothing but the play differs.
    fn meshed(
        &self,
        space: &FixedAxesSpace,
        compute: &Compute<'_>,
    ) -> Result<Option<Mesh>, PairError> {
        let [fixed, moving] = self.axes.map(|axis| Axis {
            range: None,
            ..axis
        });
        if self.axes == [fixed, moving] {
            return Ok(mesh(space, self.place, None)?);
        }
        let relation = Relation::Axes { fixed, moving };
        let endless = compute(space.fixed(), space.moving(), relation, &Options::default())?;
        Ok(match endless {
            PairSpace::FixedAxes(endless) => mesh(&endless, self.place, self.axes[0].range)?,
            _ => None,
        })
    }
}

//! The free regions in which two parts on axes are drawn, and what is asked of them.

use cspace::{Axis, Coordinates, Options, PairError, PairSpace, Part, RegionId, Relation};
use cspace_model::Compute;

use crate::exact_fit::{fits_exactly, with_gap};

use super::answer::{Contact, Limits, Stop, Verdict};
use super::gap::smallest;
use super::kept::Kept;
use super::mesh::{Mesh, mesh, turn_not_alone};
use super::pair::Pair;
use super::reach::{reach, stops, touching};
use super::region::{bounding, is_bounded, regions};

/// The free regions in which two parts are drawn.
#[derive(Debug)]
pub struct Free<'a> {
    pub(super) pair: Pair<'a>,
    pub(super) space: Kept<'a>,
    pub(super) regions: Vec<RegionId>,
    pub(super) room: Option<f64>,
}

impl<'a> Free<'a> {
    /// The free regions in which the parts of a space, which do not overlap, are at motions u and v of them; or why they are not known. Other
    /// spaces come from `compute`.
    ///
    /// # Errors
    /// Errors of `compute`.
    pub fn of(
        drawn: &'a PairSpace,
        place: [f64; 2],
        compute: &Compute<'_>,
    ) -> Result<Result<Self, &'static str>, PairError> {
        let PairSpace::FixedAxes(space) = drawn else {
            return Ok(Err("their motions are not on axes"));
        };
        let pair = Pair::of(space, place);
        let [fixed, moving] = pair.axes;
        let [u, v] = pair.place;
        let at = Coordinates::Axes { u, v };
        let (mut space, mut room) = (Kept::Known(space), None);
        // Parts that fit exactly have no room: what a part can do is that of one that is smaller by a gap.
        if fits_exactly(drawn, at).unwrap_or(false)
            && let Some((smaller, gap)) = with_gap(pair.parts[0], pair.parts[1])
        {
            let relation = Relation::Axes { fixed, moving };
            let roomy = compute(pair.parts[0], &smaller, relation, &Options::default())?;
            if let PairSpace::FixedAxes(roomy) = roomy {
                (space, room) = (Kept::Computed(roomy), Some(gap));
            }
        }
        if space.statistics().conflicts > 0 {
            return Ok(Err(
                "some of their features lie closer than can be told apart",
            ));
        }
        let regions = regions(&space, pair.place);
        Ok(match regions.is_empty() {
            true => Err("where they are is in no free region that could be found"),
            false => Ok(Self {
                pair,
                space,
                regions,
                room,
            }),
        })
    }

    /// Whether contact bounds them: otherwise they are all that the ranges allow.
    pub fn is_bounded(&self) -> bool {
        self.room.is_some() || is_bounded(&self.space, &self.regions)
    }

    /// The gap by which the moving part is smaller all around, where the parts fit exactly and had no room to move (the model's unit of
    /// length).
    pub fn room(&self) -> Option<f64> {
        self.room
    }

    /// The smallest gap of parts that never touch, if it is less than `within`; spaces come from `compute`.
    ///
    /// # Errors
    /// Errors of `compute`.
    pub fn smallest(&self, within: f64, compute: &Compute<'_>) -> Result<Verdict, PairError> {
        let [fixed, moving] = self.pair.axes;
        let relation = Relation::Axes { fixed, moving };
        let with = |part: &Part| compute(self.pair.parts[0], part, relation, &Options::default());
        smallest(&self.space, self.pair.place, within, &with)
    }

    /// How far both parts go, u and v.
    pub fn reach(&self) -> [Limits; 2] {
        reach(&self.space, &self.regions, self.pair.place)
    }

    /// Contacts that keep parts from the ends of their ranges, or from a whole turn.
    pub fn stops(&self) -> Vec<Stop> {
        stops(&self.space, &self.regions, self.reach(), self.pair.place)
    }

    /// A contact on their boundary, and the features that touch there; none if there is none.
    pub fn contact(&self) -> Option<Contact> {
        let at = bounding(&self.space, &self.regions).next()?.start;
        let features = touching(&self.space, at, &self.regions);
        Some(Contact { at, features })
    }

    /// How the parts turn together, if neither can turn without the other. Without their ranges, that is: in these nothing but the play
    /// differs.
    ///
    /// # Errors
    /// Errors of `compute`.
    pub fn mesh(&self, compute: &Compute<'_>) -> Result<Option<Mesh<'_>>, PairError> {
        let Pair { axes, place, .. } = self.pair;
        if !turn_not_alone(&self.space, place) {
            return Ok(None);
        }
        let [fixed, moving] = axes.map(|axis| Axis {
            range: None,
            ..axis
        });
        if axes == [fixed, moving] {
            return Ok(mesh(Kept::Known(&self.space), place, None));
        }
        let (a, b) = (self.space.fixed(), self.space.moving());
        let relation = Relation::Axes { fixed, moving };
        Ok(match compute(a, b, relation, &Options::default())? {
            PairSpace::FixedAxes(endless) => mesh(Kept::Computed(endless), place, axes[0].range),
            _ => None,
        })
    }
}

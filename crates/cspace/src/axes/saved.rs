//! A fixed-axes space as plain data.

use serde::{Deserialize, Serialize};

use crate::feature::FeatureName;

use super::arrange::Cell;
use super::bands::{Band, Bands, Gap, Region};
use super::condition::{Carriers, Condition};
use super::domain::Extent;
use super::motion::Motions;
use super::patch::{AxesBranch, AxesPatch};
use super::piece::{Pair, Piece};
use super::space::{AxesStatistics, FixedAxesSpace, Map};

/// The version of the format that this library writes, and the only one it reads.
pub const SAVED_AXES_VERSION: u32 = 1;

/// A [`FixedAxesSpace`] as plain data, to be written in any format `serde` knows and read again.
///
/// ```
/// use cspace::axes::SavedAxesSpace;
/// use cspace::{Axis, FixedAxesSpace, Part, Point, Vector, Vertex};
/// let disc = |x: f64| vec![Vertex::new(x + 1.0, 0.0, 1.0), Vertex::new(x - 1.0, 0.0, 1.0)];
/// let (a, b) = (Part::new("a", vec![disc(0.5)])?, Part::new("b", vec![disc(4.0)])?);
/// let turning = Axis::revolute(Point::new(0.0, 0.0));
/// let space = FixedAxesSpace::compute(&a, turning, &b, Axis::prismatic(Vector::new(1.0, 0.0)))?;
/// let again = FixedAxesSpace::try_from(SavedAxesSpace::from(&space))?;
/// assert_eq!(again.patches(), space.patches());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SavedAxesSpace {
    /// The version of the format.
    pub version: u32,
    map: Map,
    motions: Motions,
    x: Extent,
    y: Extent,
    first_names: Vec<FeatureName>,
    second_names: Vec<FeatureName>,
    pairs: Vec<(u32, u32, Carriers)>,
    pieces: Vec<Piece>,
    cells: Vec<Cell>,
    free: Vec<bool>,
    bands: Vec<Band>,
    gaps: Vec<Gap>,
    regions: Vec<Region>,
    patches: Vec<AxesPatch>,
    branches: Vec<AxesBranch>,
    statistics: AxesStatistics,
}

/// Why saved data are not a fixed-axes space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SavedAxesError {
    /// Written by another version.
    #[error(
        "the format's version is {found}, this program reads version {SAVED_AXES_VERSION}; compute the space again"
    )]
    Version {
        /// The version found.
        found: u32,
    },
    /// The data refer to what is not there.
    #[error(
        "the saved space is damaged: {what} refer to what is not there; compute the space again"
    )]
    Damaged {
        /// What is wrong.
        what: &'static str,
    },
}

impl From<&FixedAxesSpace> for SavedAxesSpace {
    fn from(s: &FixedAxesSpace) -> Self {
        Self {
            version: SAVED_AXES_VERSION,
            map: s.map,
            motions: s.motions,
            x: s.x,
            y: s.y,
            first_names: s.names.0.clone(),
            second_names: s.names.1.clone(),
            pairs: s
                .pairs
                .iter()
                .map(|p| (p.first, p.second, p.condition.carriers))
                .collect(),
            pieces: s.pieces.clone(),
            cells: s.cells.clone(),
            free: s.free.clone(),
            bands: s.bands.bands.clone(),
            gaps: s.bands.gaps.clone(),
            regions: s.bands.regions.clone(),
            patches: s.patches.clone(),
            branches: s.branches.clone(),
            statistics: s.statistics,
        }
    }
}

impl TryFrom<SavedAxesSpace> for FixedAxesSpace {
    type Error = SavedAxesError;

    fn try_from(s: SavedAxesSpace) -> Result<Self, SavedAxesError> {
        s.check()?;
        let motions = s.motions;
        let pairs = s.pairs.into_iter().map(|(first, second, carriers)| Pair {
            first,
            second,
            condition: Condition::new(carriers, motions),
        });
        let mut space = Self {
            map: s.map,
            motions,
            x: s.x,
            y: s.y,
            names: (s.first_names, s.second_names),
            pairs: pairs.collect(),
            pieces: s.pieces,
            cells: s.cells,
            free: s.free,
            bands: Bands {
                bands: s.bands,
                gaps: s.gaps,
                regions: s.regions,
                conflicts: 0,
                tests: 0,
            },
            slots: Vec::new(),
            patches: s.patches,
            branches: s.branches,
            statistics: s.statistics,
        };
        space.slots = space.near_slots();
        Ok(space)
    }
}

impl SavedAxesSpace {
    /// Whether everything that is referred to is there.
    fn check(&self) -> Result<(), SavedAxesError> {
        if self.version != SAVED_AXES_VERSION {
            return Err(SavedAxesError::Version {
                found: self.version,
            });
        }
        let sound = |ok: bool, what| {
            if ok {
                Ok(())
            } else {
                Err(SavedAxesError::Damaged { what })
            }
        };
        let within = |i: u32, n: usize| (i as usize) < n;
        let range = |r: &core::ops::Range<u32>, n: usize| r.start <= r.end && r.end as usize <= n;
        let optional = |i: Option<u32>, n: usize| i.is_none_or(|i| within(i, n));
        let (first, second) = (self.first_names.len(), self.second_names.len());
        let mut pairs = self.pairs.iter();
        sound(
            pairs.all(|p| within(p.0, first) && within(p.1, second)),
            "pairs",
        )?;
        let mut pieces = self.pieces.iter();
        sound(pieces.all(|p| within(p.pair, self.pairs.len())), "pieces")?;
        let mut cells = self.cells.iter();
        let cells_sound = cells.all(|c| within(c.piece, self.pieces.len()));
        sound(cells_sound && self.free.len() == self.cells.len(), "cells")?;
        let n = self.cells.len();
        let mut gaps = self.gaps.iter();
        sound(
            gaps.all(|g| {
                optional(g.lower, n) && optional(g.upper, n) && within(g.region, self.regions.len())
            }),
            "gaps",
        )?;
        let mut bands = self.bands.iter();
        sound(
            !self.bands.is_empty() && bands.all(|b| range(&b.gaps, self.gaps.len())),
            "bands",
        )?;
        let mut branches = self.branches.iter();
        sound(
            branches.all(|b| within(b.cell(), n) && within(b.patch, self.patches.len())),
            "branches",
        )?;
        let mut patches = self.patches.iter();
        sound(
            patches.all(|p| {
                range(&p.branches, self.branches.len())
                    && optional(p.previous, self.patches.len())
                    && optional(p.next, self.patches.len())
                    && optional(p.region, self.regions.len())
            }),
            "patches",
        )
    }
}

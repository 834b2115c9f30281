//! A fixed-axes space as plain data.

use crate::feature::FeatureName;
use crate::part::Part;

use super::adjust::Aside;
use super::arrange::Cell;
use super::axis::{AxesError, Axis};
use super::bands::{Band, Bands, Gap, Region};
use super::build::carriers;
use super::condition::Carriers;
use super::condition::Condition;
use super::domain::Extent;
use super::motion::Motions;
use super::patch::{AxesBranch, AxesPatch};
use super::piece::{Pair, Piece};
use super::region::AxesRegion;
use super::setup::{Map, Setting};
use super::space::{AxesStatistics, FixedAxesSpace};

/// The version of the format that this library writes, and the only one it reads.
pub const SAVED_AXES_VERSION: u32 = 1;

const FORMAT: &str = "fixed-axes-space";

/// A [`FixedAxesSpace`] as plain data, to be written in any format `serde` knows and read again.
///
/// ```
/// use cspace::fixed_axes::SavedAxesSpace;
/// use cspace::{Axis, FixedAxesSpace, Part, Point, Vector, Vertex};
/// let disc = |x: f64| vec![Vertex::new(x + 1.0, 0.0, 1.0), Vertex::new(x - 1.0, 0.0, 1.0)];
/// let (a, b) = (Part::new("a", vec![disc(0.5)])?, Part::new("b", vec![disc(4.0)])?);
/// let turning = Axis::revolute(Point::new(0.0, 0.0));
/// let space = FixedAxesSpace::compute(&a, turning, &b, Axis::prismatic(Vector::new(1.0, 0.0)))?;
/// let again = FixedAxesSpace::try_from(SavedAxesSpace::from(&space))?;
/// assert_eq!(again.patches(), space.patches());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
// What follows from parts and axes is there to be written, and is not read back.
#[cfg_attr(not(feature = "serde"), allow(dead_code))]
pub struct SavedAxesSpace {
    /// Always `fixed-axes-space`.
    pub format: String,
    /// The version of the format.
    pub version: u32,
    /// The part called fixed, whose motion is u.
    pub fixed: Part,
    /// The moving part, whose motion is v.
    pub moving: Part,
    /// The fixed part's axis.
    pub fixed_axis: Axis,
    /// The moving part's axis.
    pub moving_axis: Axis,
    /// The contact curves.
    pub patches: Vec<AxesPatch>,
    /// Their branches.
    pub branches: Vec<AxesBranch>,
    /// Connected components of free space.
    pub free_regions: Vec<AxesRegion>,
    /// Counts of the computation.
    pub statistics: AxesStatistics,
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Aside::is_none")
    )]
    aside: Aside,
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
}

/// Why saved data are not a fixed-axes space.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SavedAxesError {
    /// Not such a space at all.
    #[error("the format is {found:?}, not {FORMAT:?}")]
    Format {
        /// What it says.
        found: String,
    },
    /// An axis is none.
    #[error(transparent)]
    Axes(#[from] AxesError),
    /// Written by another version.
    #[error(
        "the format's version is {found}, this program reads version {SAVED_AXES_VERSION}; compute the space again"
    )]
    Version {
        /// The version found.
        found: u32,
    },
    /// The data refer to what is not there, or numbers are out of order.
    #[error(
        "the saved space is damaged: its {what} refer to what is not there, or are out of order; compute the space again"
    )]
    Damaged {
        /// What is wrong.
        what: &'static str,
    },
}

impl FixedAxesSpace {
    /// The space as plain data.
    pub fn to_saved(&self) -> SavedAxesSpace {
        self.into()
    }

    /// The space that plain data describe. The partition is not computed again; what follows at once from the parts and
    /// their axes (motions, names of features, contact conditions) is, and is not read.
    ///
    /// # Errors
    /// If the data are of another format or version, describe no parts or axes, refer to what is not there, or have numbers
    /// out of order.
    pub fn from_saved(saved: SavedAxesSpace) -> Result<Self, SavedAxesError> {
        saved.try_into()
    }
}

impl From<&FixedAxesSpace> for SavedAxesSpace {
    fn from(s: &FixedAxesSpace) -> Self {
        Self {
            format: FORMAT.to_owned(),
            version: SAVED_AXES_VERSION,
            fixed: s.fixed.clone(),
            moving: s.moving.clone(),
            fixed_axis: s.axes.0,
            moving_axis: s.axes.1,
            free_regions: s.regions(),
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
            aside: s.aside,
        }
    }
}

impl TryFrom<SavedAxesSpace> for FixedAxesSpace {
    type Error = SavedAxesError;

    fn try_from(s: SavedAxesSpace) -> Result<Self, SavedAxesError> {
        s.check()?;
        let (fixed, moving) = (s.fixed, s.moving);
        let setting = Setting::new(&fixed, s.fixed_axis, &moving, s.moving_axis, s.aside)?;
        let scene = &setting.scene;
        let features = |side: &super::scene::Side| side.outline.features.len() as u32;
        let (first, second) = (features(&scene.first), features(&scene.second));
        let pair = |(a, b, _): (u32, u32, Carriers)| {
            let there = a < first && b < second;
            let carriers = there.then(|| carriers(scene, a, b)).flatten()?;
            Some(Pair {
                first: a,
                second: b,
                condition: Condition::new(carriers, scene.motions),
            })
        };
        let pairs: Option<Vec<Pair>> = s.pairs.into_iter().map(pair).collect();
        let pairs = pairs.ok_or(SavedAxesError::Damaged { what: "pairs" })?;
        let mut space = Self {
            fixed,
            moving,
            axes: (s.fixed_axis, s.moving_axis),
            map: setting.map,
            motions: scene.motions,
            x: scene.x,
            y: scene.y,
            names: setting.names,
            pairs,
            pieces: s.pieces,
            cells: s.cells,
            free: s.free,
            bands: Bands {
                bands: s.bands,
                gaps: s.gaps,
                regions: s.regions,
            },
            deviation: setting.deviation,
            grown: setting.grown,
            aside: s.aside,
            bodies: setting.bodies,
            slots: Vec::new(),
            patches: s.patches,
            branches: s.branches,
            statistics: s.statistics,
        };
        space.slots = space.near_slots();
        Ok(space)
    }
}

/// Motions are lengths of the pair's frame, in which the parts have size 1, or radians: they are far below this.
const FARTHEST: f64 = 1e12;

impl SavedAxesSpace {
    /// Whether everything that is referred to is there.
    fn check(&self) -> Result<(), SavedAxesError> {
        if self.format != FORMAT {
            return Err(SavedAxesError::Format {
                found: self.format.clone(),
            });
        }
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
        let near = |x: f64| x.abs() <= FARTHEST;
        let ordered = |(lo, hi): (f64, f64)| near(lo) && near(hi) && lo <= hi;
        let mut pieces = self.pieces.iter();
        let level = |p: &Piece| near(p.start.y()) && near(p.end.y());
        sound(
            pieces.all(|p| within(p.pair, self.pairs.len()) && ordered(p.x_range()) && level(p)),
            "pieces",
        )?;
        let mut cells = self.cells.iter();
        let cells_sound =
            cells.all(|c| within(c.piece, self.pieces.len()) && ordered((c.from, c.to)));
        sound(cells_sound && self.free.len() == self.cells.len(), "cells")?;
        let n = self.cells.len();
        let mut gaps = self.gaps.iter();
        sound(
            gaps.all(|g| {
                optional(g.lower, n) && optional(g.upper, n) && within(g.region, self.regions.len())
            }),
            "gaps",
        )?;
        let mut regions = self.regions.iter();
        let placed = |r: &Region| {
            let numbers = [r.sample, r.x, r.y];
            numbers.iter().all(|&(a, b)| near(a) && near(b))
        };
        sound(regions.all(placed), "regions")?;
        let mut bands = self.bands.iter();
        sound(
            !self.bands.is_empty()
                && bands.all(|b| range(&b.gaps, self.gaps.len()) && ordered((b.lo, b.hi))),
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

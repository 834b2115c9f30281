//! A fixed-axes space as plain data, and a check of their consistency.

use crate::feature::FeatureName;
use crate::part::Part;

use super::arrange::Cell;
use super::axis::{AxesError, Axis};
use super::carriers::Carriers;
use super::displacement::Displacement;
use super::motion::{Extent, Motions};
use super::patches::{AxesBranch, AxesPatch};
use super::piece::Piece;
use super::region::{AxesRegion, Region};
use super::setup::Map;
use super::sweep::{Band, Gap};

/// The version of the format that this library writes, and the only one it reads.
pub const SAVED_AXES_VERSION: u32 = 1;

pub(super) const FORMAT: &str = "fixed-axes-space";

/// A [`FixedAxesSpace`](super::FixedAxesSpace) as plain data, which can be written in any format of `serde` and read again.
///
/// Everything from `map` to the names of features, and the carriers of the pairs, follows from the parts and their axes. These are written
/// for other readers, and ignored on reading.
///
/// ```
/// use cspace::{Axis, FixedAxesSpace, Part, Point, Vector, Vertex};
/// let disc = |x: f64| vec![Vertex::new(x + 1.0, 0.0, 1.0), Vertex::new(x - 1.0, 0.0, 1.0)];
/// let (a, b) = (Part::new("a", vec![disc(0.5)])?, Part::new("b", vec![disc(4.0)])?);
/// let turning = Axis::revolute(Point::new(0.0, 0.0));
/// let space = FixedAxesSpace::compute(&a, turning, &b, Axis::prismatic(Vector::new(1.0, 0.0)))?;
/// let again = FixedAxesSpace::from_data(space.data().clone())?;
/// assert_eq!(again.patches(), space.patches());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(not(feature = "serde"), allow(dead_code))]
pub struct AxesData {
    /// Always `fixed-axes-space`.
    pub format: String,
    /// The version of the format.
    pub version: u32,
    /// The part called fixed; its motion is u.
    pub fixed: Part,
    /// The moving part; its motion is v.
    pub moving: Part,
    /// The fixed part's axis.
    pub fixed_axis: Axis,
    /// The moving part's axis.
    pub moving_axis: Axis,
    /// The contact curves.
    pub patches: Vec<AxesPatch>,
    /// The branches of the contact curves.
    pub branches: Vec<AxesBranch>,
    /// Connected components of free space.
    pub free_regions: Vec<AxesRegion>,
    /// Counts of the computation.
    pub statistics: AxesStatistics,
    #[cfg_attr(
        feature = "serde",
        serde(
            rename = "aside",
            default,
            skip_serializing_if = "Displacement::is_none"
        )
    )]
    pub(super) displacement: Displacement,
    pub(super) map: Map,
    pub(super) motions: Motions,
    pub(super) x: Extent,
    pub(super) y: Extent,
    pub(super) first_names: Vec<FeatureName>,
    pub(super) second_names: Vec<FeatureName>,
    pub(super) pairs: Vec<(u32, u32, Carriers)>,
    pub(super) pieces: Vec<Piece>,
    pub(super) cells: Vec<Cell>,
    pub(super) free: Vec<bool>,
    pub(super) bands: Vec<Band>,
    pub(super) gaps: Vec<Gap>,
    pub(super) regions: Vec<Region>,
}

/// Counts of a computation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesStatistics {
    /// Pairs of features that touch somewhere.
    pub pairs: usize,
    /// Monotone pieces of their contact curves.
    pub pieces: usize,
    /// Crossings of pieces.
    pub crossings: usize,
    /// Tests of overlap. A part that is symmetric about its pivot is tested in one period only.
    pub tests: usize,
    /// Conflicts that remained in every attempt: places at which tests and structure contradict each other, or the structure contradicts
    /// itself; 0 unless features lie closer than the resolution. If there are any, configurations are classified by intersecting the placed
    /// parts, and regions and patches are unreliable.
    pub conflicts: usize,
}

/// Reasons for which saved data are rejected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AxesDataError {
    /// The data are not a fixed-axes space.
    #[error("the format is {found:?}, not {FORMAT:?}")]
    Format {
        /// Format name found in the data.
        found: String,
    },
    /// An axis is invalid.
    #[error(transparent)]
    Axes(#[from] AxesError),
    /// The data were written by another version.
    #[error(
        "the format's version is {found}, this program reads version {SAVED_AXES_VERSION}; compute the space again"
    )]
    Version {
        /// The version found.
        found: u32,
    },
    /// The data refer to entries that do not exist, or numbers are out of order.
    #[error(
        "the saved space is damaged: its {what} refer to what is not there, or are out of order; compute the space again"
    )]
    Damaged {
        /// Reason for the rejection.
        what: &'static str,
    },
}

/// Bound on motions: they are lengths of the pair's frame, in which the parts have size 1, or radians.
const FARTHEST: f64 = 1e12;

impl AxesData {
    /// Checks the format, the version and all references.
    pub(super) fn check(&self) -> Result<(), AxesDataError> {
        if self.format != FORMAT {
            return Err(AxesDataError::Format {
                found: self.format.clone(),
            });
        }
        if self.version != SAVED_AXES_VERSION {
            return Err(AxesDataError::Version {
                found: self.version,
            });
        }
        let within = |i: u32, n: usize| (i as usize) < n;
        let range = |r: &core::ops::Range<u32>, n: usize| r.start <= r.end && r.end as usize <= n;
        let optional = |i: Option<u32>, n: usize| i.is_none_or(|i| within(i, n));
        let near = |x: f64| x.abs() <= FARTHEST;
        let ordered = |(lo, hi): (f64, f64)| near(lo) && near(hi) && lo <= hi;
        let level = |p: &Piece| near(p.start.y()) && near(p.end.y());
        let placed = |r: &Region| {
            [r.sample, r.x, r.y]
                .iter()
                .all(|&(a, b)| near(a) && near(b))
        };
        let (pairs, pieces, cells) = (self.pairs.len(), self.pieces.len(), self.cells.len());
        let (gaps, regions) = (self.gaps.len(), self.regions.len());
        let (patches, branches) = (self.patches.len(), self.branches.len());
        let sound = [
            (
                "pieces",
                (self.pieces.iter())
                    .all(|p| within(p.pair, pairs) && ordered(p.x_range()) && level(p)),
            ),
            (
                "cells",
                (self.cells.iter()).all(|c| within(c.piece, pieces) && ordered((c.from, c.to)))
                    && self.free.len() == cells,
            ),
            (
                "gaps",
                (self.gaps.iter()).all(|g| {
                    optional(g.lower, cells)
                        && optional(g.upper, cells)
                        && within(g.region, regions)
                }),
            ),
            ("regions", self.regions.iter().all(placed)),
            (
                "bands",
                !self.bands.is_empty()
                    && (self.bands.iter()).all(|b| range(&b.gaps, gaps) && ordered((b.lo, b.hi))),
            ),
            (
                "branches",
                (self.branches.iter()).all(|b| within(b.cell, cells) && within(b.patch.0, patches)),
            ),
            (
                "patches",
                (self.patches.iter()).all(|p| {
                    range(&p.branches, branches)
                        && [p.previous, p.next]
                            .iter()
                            .all(|&i| optional(i.map(|p| p.0), patches))
                        && optional(p.region.map(|r| r.0), regions)
                }),
            ),
        ];
        match sound.into_iter().find(|(_, sound)| !sound) {
            Some((what, _)) => Err(AxesDataError::Damaged { what }),
            None => Ok(()),
        }
    }
}

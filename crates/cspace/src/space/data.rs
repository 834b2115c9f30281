//! A contact space as plain data: everything that was computed, nothing that follows from it.

use crate::feature::{Outline, PairFrame};
use crate::geometry::Configuration;
use crate::ids::PatchId;
use crate::part::Part;
use crate::slice::CurveGeometry;

use super::options::Window;
use super::patch::Patch;
use super::stats::Statistics;
use super::symmetry::PairSymmetry;

/// The version of the format that this library writes, and the only one it reads.
pub const SAVED_VERSION: u32 = 1;

pub(crate) const FORMAT: &str = "contact-space";

/// A contact space as plain data: everything that was computed, nothing that follows from it.
///
/// Written as JSON with `serde_json`, it is what `cspace export -o OUT.json` writes. The schema
/// `docs/contact-space.schema.json` in the project's repository describes every field and its unit.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, PatchId};
/// let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
/// let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0)?;
/// let space = ContactSpace::compute(&table, &block, &Options::default())?;
/// let mut data = space.data().clone();
/// assert_eq!(ContactSpace::from_data(data.clone())?.data(), space.data());
/// data.side_links[0].after = PatchId(1_000_000);
/// let error = ContactSpace::from_data(data).unwrap_err();
/// assert_eq!(error.to_string(), "side link 0 is damaged: there is no such patch");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SpaceData {
    /// Always `contact-space`.
    pub format: String,
    /// Version of the format.
    pub version: u32,
    /// The fixed part.
    pub fixed: Part,
    /// The moving part.
    pub moving: Part,
    /// Orientations covered.
    pub window: Window,
    /// The frame of the patches.
    pub frame: PairFrame,
    /// Numbers of features.
    pub features: FeatureCounts,
    /// Orientations at which the structure of the slice changes.
    pub critical_orientations: Vec<f64>,
    /// The patches.
    pub patches: Vec<Patch>,
    /// Neighbours within bands.
    pub side_links: Vec<SideLink>,
    /// Neighbours across critical orientations.
    pub vertical_links: Vec<VerticalLink>,
    /// Connected components of free space; the unbounded one first.
    pub free_regions: Vec<FreeRegion>,
    /// The symmetry of the parts, and the number of periods in a turn.
    #[cfg_attr(feature = "serde", serde(default))]
    pub symmetry: PairSymmetry,
    /// Number of bands computed; 0 if unknown.
    #[cfg_attr(feature = "serde", serde(default))]
    pub computed_bands: u32,
    /// Intervals of orientation in which the parts are tested as well as the patches.
    #[cfg_attr(feature = "serde", serde(default))]
    pub doubtful_orientations: Vec<(f64, f64)>,
    /// Counts and times of the computation.
    pub statistics: Statistics,
}

/// Two patches that follow each other along the boundary of free space, within bands.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SideLink {
    /// The patch that comes first in the direction of travel; its right boundary is the curve of the link.
    pub before: PatchId,
    /// The patch that comes second; its left boundary is the curve of the link.
    pub after: PatchId,
    /// First orientation at which they are neighbours.
    pub lo: f64,
    /// Last orientation.
    pub hi: f64,
}

/// Two patches that continue each other in orientation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VerticalLink {
    /// The patch that ends at the orientation.
    pub lower: PatchId,
    /// The patch that begins there.
    pub upper: PatchId,
    /// The critical orientation, radians.
    pub theta: f64,
    /// The curve that their top and bottom share.
    pub overlap: CurveGeometry,
}

/// A connected component of free space over all orientations of the window.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FreeRegion {
    /// Whether it reaches arbitrarily far positions. Exactly one region does.
    pub unbounded: bool,
    /// A configuration inside, away from contact.
    pub sample: Configuration,
    /// Number of patches on its boundary.
    pub patches: u32,
}

/// Lines, arcs and vertices that are not smooth joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FeatureCounts {
    /// Number of features of the fixed part.
    pub fixed: u32,
    /// Number of features of the moving part.
    pub moving: u32,
}

impl FeatureCounts {
    /// Counts the features of two parts.
    pub fn of(fixed: &Part, moving: &Part) -> Self {
        let frame = PairFrame::new(fixed, moving);
        let count =
            |part, center| Outline::new(part, center, frame.scale, (0.0, 0.0)).feature_count as u32;
        Self {
            fixed: count(fixed, frame.fixed_center),
            moving: count(moving, frame.moving_center),
        }
    }
}

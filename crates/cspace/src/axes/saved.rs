//! Configuration spaces of pairs with fixed axes as plain data, to be written and read.

use serde::{Deserialize, Serialize};

use crate::feature::FeatureName;
use crate::space::{SAVED_VERSION, SavedError, SavedPart};

use super::arrange::Cell;
use super::axis::Axis;
use super::bands::Bands;
use super::domain::Extent;
use super::motion::Motions;
use super::patch::{AxesBranch, AxesPatch};
use super::piece::{Pair, Piece};
use super::space::{AxesRegion, AxesStatistics, FixedAxesSpace, Map};

const FORMAT: &str = "fixed-axes-space";

/// A configuration space as plain data: everything that was computed.
///
/// Written as JSON with `serde_json`, it is what `cspace export -o OUT.json` writes. The schema
/// `docs/fixed-axes-space.schema.json` in the project's repository describes the fields for readers; what is in `partition`
/// belongs to the version of the format.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SavedAxes {
    /// Always `fixed-axes-space`.
    pub format: String,
    /// Version of the format.
    pub version: u32,
    /// The part called fixed, whose motion is u.
    pub fixed: SavedPart,
    /// The moving part, whose motion is v.
    pub moving: SavedPart,
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
    /// The planar partition, in the frame it was computed in.
    partition: Partition,
    /// Counts of the computation.
    pub statistics: AxesStatistics,
}

/// What answers questions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Partition {
    map: Map,
    motions: Motions,
    x: Extent,
    y: Extent,
    first_features: Vec<FeatureName>,
    second_features: Vec<FeatureName>,
    pairs: Vec<Pair>,
    pieces: Vec<Piece>,
    cells: Vec<Cell>,
    free: Vec<bool>,
    bands: Bands,
}

impl FixedAxesSpace {
    /// The space as plain data.
    pub fn to_saved(&self) -> SavedAxes {
        SavedAxes {
            format: FORMAT.to_owned(),
            version: SAVED_VERSION,
            fixed: SavedPart::of(&self.fixed),
            moving: SavedPart::of(&self.moving),
            fixed_axis: self.axes.0,
            moving_axis: self.axes.1,
            patches: self.patches.clone(),
            branches: self.branches.clone(),
            free_regions: self.regions(),
            partition: Partition {
                map: self.map,
                motions: self.motions,
                x: self.x,
                y: self.y,
                first_features: self.names.0.clone(),
                second_features: self.names.1.clone(),
                pairs: self.pairs.clone(),
                pieces: self.pieces.clone(),
                cells: self.cells.clone(),
                free: self.free.clone(),
                bands: self.bands.clone(),
            },
            statistics: self.statistics,
        }
    }

    /// The space that plain data describe; nothing is computed again.
    ///
    /// # Errors
    /// If the data are of another format or version, or refer to what is not there.
    pub fn from_saved(saved: SavedAxes) -> Result<Self, SavedError> {
        if saved.format != FORMAT {
            return Err(SavedError::Format {
                found: saved.format,
                wanted: FORMAT,
            });
        }
        if saved.version != SAVED_VERSION {
            return Err(SavedError::Version {
                found: saved.version,
            });
        }
        let (fixed, moving) = (saved.fixed.part()?, saved.moving.part()?);
        check(&saved)?;
        let p = saved.partition;
        let mut space = Self {
            fixed,
            moving,
            axes: (saved.fixed_axis, saved.moving_axis),
            map: p.map,
            motions: p.motions,
            x: p.x,
            y: p.y,
            names: (p.first_features, p.second_features),
            pairs: p.pairs,
            pieces: p.pieces,
            cells: p.cells,
            free: p.free,
            bands: p.bands,
            slots: Vec::new(),
            patches: saved.patches,
            branches: saved.branches,
            statistics: saved.statistics,
        };
        space.slots = space.near_slots();
        Ok(space)
    }
}

/// That everything referred to is there, and in order.
fn check(saved: &SavedAxes) -> Result<(), SavedError> {
    let p = &saved.partition;
    let whole = |what, ok: bool, why| {
        if ok {
            Ok(())
        } else {
            Err(SavedError::Whole { what, why })
        }
    };
    let ordered = |e: &Extent| e.lo.is_finite() && e.hi.is_finite() && e.lo < e.hi;
    whole(
        "the extent",
        ordered(&p.x) && ordered(&p.y),
        "it is no interval",
    )?;
    whole(
        "the frame",
        p.map.is_sound(),
        "its scale is no positive number",
    )?;
    whole(
        "the list `free`",
        p.free.len() == p.cells.len(),
        "it has not an entry for each cell",
    )?;
    whole(
        "the list of bands",
        !p.bands.bands.is_empty(),
        "it is empty",
    )?;
    let missing = "there is no such entry";
    let below = |i: u32, n: usize| (i as usize) < n;
    let maybe = |i: Option<u32>, n: usize| i.is_none_or(|i| below(i, n));
    let (firsts, seconds) = (p.first_features.len(), p.second_features.len());
    each(
        "pair",
        (p.pairs.iter()).map(|q| below(q.first, firsts) && below(q.second, seconds)),
        missing,
    )?;
    each(
        "piece",
        p.pieces.iter().map(|q| below(q.pair, p.pairs.len())),
        missing,
    )?;
    each(
        "cell",
        p.cells.iter().map(|c| below(c.piece, p.pieces.len())),
        missing,
    )?;
    each(
        "cell",
        (p.cells.iter()).map(|c| c.from.is_finite() && c.to.is_finite() && c.from <= c.to),
        "it is no interval",
    )?;
    let gaps = p.bands.gaps.len();
    each(
        "band",
        (p.bands.bands.iter()).map(|b| {
            b.gaps.start <= b.gaps.end
                && b.gaps.end as usize <= gaps
                && b.lo.is_finite()
                && b.hi.is_finite()
        }),
        missing,
    )?;
    each(
        "gap",
        (p.bands.gaps.iter()).map(|g| {
            maybe(g.lower, p.cells.len())
                && maybe(g.upper, p.cells.len())
                && below(g.region, p.bands.regions.len())
        }),
        missing,
    )?;
    let patches = saved.patches.len();
    each(
        "patch",
        (saved.patches.iter()).map(|q| {
            q.branches.start < q.branches.end
                && q.branches.end as usize <= saved.branches.len()
                && maybe(q.previous, patches)
                && maybe(q.next, patches)
                && maybe(q.region, p.bands.regions.len())
        }),
        missing,
    )?;
    each(
        "branch",
        (saved.branches.iter()).map(|b| below(b.patch, patches) && below(b.cell, p.cells.len())),
        missing,
    )
}

/// That all entries of a list are sound.
fn each(
    what: &'static str,
    mut sound: impl Iterator<Item = bool>,
    why: &'static str,
) -> Result<(), SavedError> {
    match sound.position(|ok| !ok) {
        None => Ok(()),
        Some(index) => Err(SavedError::Damaged { what, index, why }),
    }
}

//! Contact spaces as plain data, to be written and read.

use serde::{Deserialize, Serialize};

use crate::feature::PairFrame;
use crate::geometry::Point;
use crate::part::{Part, PartError, Vertex};

use super::graph::{ContactSpace, FeatureCounts, FreeRegion, SideLink, VerticalLink, Walk, Window};
use super::patch::Patch;
use super::stats::Statistics;

/// The version of the format that this library writes, and the only one it reads.
pub const SAVED_VERSION: u32 = 1;

/// A part as it was given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SavedPart {
    /// Its name.
    pub name: String,
    /// Its loops.
    pub loops: Vec<Vec<Vertex>>,
}

/// The frame in which patches are written: position p of the moving part is at scale · (p − `fixed_center` + `R_θ` `moving_center`).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SavedFrame {
    /// Centre of the fixed part, in its own frame.
    pub fixed_center: Point,
    /// Centre of the moving part, in its own frame.
    pub moving_center: Point,
    /// A power of two.
    pub scale: f64,
}

/// A contact space as plain data: everything that was computed, nothing that follows from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SavedSpace {
    /// Always `contact-space`.
    pub format: String,
    /// Version of the format.
    pub version: u32,
    /// The fixed part.
    pub fixed: SavedPart,
    /// The moving part.
    pub moving: SavedPart,
    /// Orientations covered.
    pub window: Window,
    /// The frame of the patches.
    pub frame: SavedFrame,
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
    /// Connected components of free space.
    pub free_regions: Vec<FreeRegion>,
    /// Counts and times of the computation.
    pub statistics: Statistics,
}

/// Why saved data are no contact space.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SavedError {
    /// Not a contact space at all.
    #[error("the format is {found:?}, not \"contact-space\"")]
    Format {
        /// What it says.
        found: String,
    },
    /// Written by another version.
    #[error(
        "the format's version is {found}, this program reads version {SAVED_VERSION}; compute the space again"
    )]
    Version {
        /// What it says.
        found: u32,
    },
    /// A part is none.
    #[error("part {name:?}: {error}")]
    Part {
        /// Its name.
        name: String,
        /// What is wrong with it.
        error: PartError,
    },
    /// A link or patch refers to something that does not exist, or a number is not finite.
    #[error("{what} {index} is damaged: {why}")]
    Damaged {
        /// Which list.
        what: &'static str,
        /// Which entry.
        index: usize,
        /// What is wrong.
        why: &'static str,
    },
}

const FORMAT: &str = "contact-space";

impl ContactSpace {
    /// The space as plain data.
    pub fn to_saved(&self) -> SavedSpace {
        let part = |p: &Part| SavedPart {
            name: p.name().to_owned(),
            loops: p.loops().iter().map(|l| l.vertices().to_vec()).collect(),
        };
        SavedSpace {
            format: FORMAT.to_owned(),
            version: SAVED_VERSION,
            fixed: part(&self.fixed),
            moving: part(&self.moving),
            window: self.window,
            frame: SavedFrame {
                fixed_center: self.frame.fixed_center,
                moving_center: self.frame.moving_center,
                scale: self.frame.scale,
            },
            features: self.features,
            critical_orientations: self.critical_orientations.clone(),
            patches: self.patches.clone(),
            side_links: self.side_links.clone(),
            vertical_links: self.vertical_links.clone(),
            free_regions: self.regions.clone(),
            statistics: self.statistics,
        }
    }

    /// The space that plain data describe; nothing is computed again.
    ///
    /// # Errors
    /// If the data are of another format or version, or refer to what is not there.
    pub fn from_saved(saved: SavedSpace) -> Result<Self, SavedError> {
        if saved.format != FORMAT {
            return Err(SavedError::Format {
                found: saved.format,
            });
        }
        if saved.version != SAVED_VERSION {
            return Err(SavedError::Version {
                found: saved.version,
            });
        }
        check(&saved)?;
        let part = |p: SavedPart| {
            let name = p.name.clone();
            Part::new(p.name, p.loops).map_err(|error| SavedError::Part { name, error })
        };
        let walk = Walk::new(saved.patches.len(), &saved.side_links);
        Ok(Self {
            fixed: part(saved.fixed)?,
            moving: part(saved.moving)?,
            window: saved.window,
            frame: PairFrame {
                fixed_center: saved.frame.fixed_center,
                moving_center: saved.frame.moving_center,
                scale: saved.frame.scale,
            },
            critical_orientations: saved.critical_orientations,
            patches: saved.patches,
            side_links: saved.side_links,
            vertical_links: saved.vertical_links,
            regions: saved.free_regions,
            features: saved.features,
            statistics: saved.statistics,
            walk,
        })
    }
}

fn check(saved: &SavedSpace) -> Result<(), SavedError> {
    let patches = saved.patches.len() as u32;
    let regions = saved.free_regions.len() as u32;
    let damaged = |what, index, why| Err(SavedError::Damaged { what, index, why });
    if saved.frame.scale.is_nan() || saved.frame.scale <= 0.0 {
        return damaged("frame", 0, "the scale is not positive");
    }
    for (i, p) in saved.patches.iter().enumerate() {
        if p.region >= regions {
            return damaged("patch", i, "there is no such free region");
        }
        if p.lo.is_nan() || p.hi.is_nan() || p.lo > p.hi {
            return damaged("patch", i, "its orientations are no interval");
        }
    }
    for (i, l) in saved.side_links.iter().enumerate() {
        if l.before >= patches || l.after >= patches {
            return damaged("side link", i, "there is no such patch");
        }
    }
    for (i, l) in saved.vertical_links.iter().enumerate() {
        if l.lower >= patches || l.upper >= patches {
            return damaged("vertical link", i, "there is no such patch");
        }
    }
    Ok(())
}

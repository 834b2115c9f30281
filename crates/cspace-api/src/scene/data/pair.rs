//! Pairs of a scene.

use cspace::{Coordinates, FeatureCounts, PairClass, PairSpace, Part};
use cspace_model::PairEntry;
use serde::Serialize;

/// A pair, with its configuration space if that is known.
#[derive(Debug, Clone, Serialize)]
pub struct ScenePair {
    /// Index of the part in whose frame configurations are expressed.
    pub fixed: usize,
    /// Index of the part that moves in that frame.
    pub moving: usize,
    /// The class. Before the space is known, symmetric pairs count as general.
    pub class: PairClass,
    /// The saved data, as the text of compact JSON: the kernel reads it as it was written, to the sign of a zero.
    pub space: Option<String>,
    /// Reason why there is no space, if it cannot be computed.
    pub error: Option<String>,
    /// Lines, arcs and vertices that are not smooth joints.
    pub features: Counts,
    /// Number of repetitions of each part in a turn, as far as used; 1 before the space is known.
    pub symmetry: Counts,
    /// Configurations nearer to a contact than this are in contact; 0 before the space is known.
    pub contact_distance: f64,
    /// Contacts are known to this; 0 before the space is known.
    pub resolution: f64,
    /// Bands of a planar pair, in ascending order.
    pub bands: Vec<(f64, f64)>,
    /// Free regions in the order of their numbers.
    pub regions: Vec<SceneRegion>,
    /// Duration of the computation, in seconds; 0 for a space that was read.
    pub seconds: f64,
}

/// A number for each part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Number for the fixed part.
    pub fixed: u32,
    /// Number for the moving part.
    pub moving: u32,
}

/// A connected component of free space.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneRegion {
    /// Whether the region is unbounded.
    pub unbounded: bool,
    /// A configuration in it: [x, y, θ] or [u, v].
    pub sample: Vec<f64>,
    /// Ranges of u and v in the region, for a pair on fixed axes.
    pub ranges: Option<[SceneRange; 2]>,
}

/// Range of a coordinate of a region (the model's unit, or radians).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SceneRange {
    /// Smallest value.
    pub lo: f64,
    /// Largest value.
    pub hi: f64,
    /// Whether the range is unbounded below and above.
    pub open: (bool, bool),
    /// Whether the range is a full turn without ends.
    pub around: bool,
}

impl ScenePair {
    /// A pair whose space is not known yet.
    pub fn unknown(entry: &PairEntry, class: PairClass, fixed: &Part, moving: &Part) -> Self {
        let features = FeatureCounts::of(fixed, moving);
        Self {
            fixed: entry.fixed,
            moving: entry.moving,
            class,
            space: None,
            error: None,
            features: Counts {
                fixed: features.fixed,
                moving: features.moving,
            },
            symmetry: Counts {
                fixed: 1,
                moving: 1,
            },
            contact_distance: 0.0,
            resolution: 0.0,
            bands: Vec::new(),
            regions: Vec::new(),
            seconds: 0.0,
        }
    }

    /// Copy of a pair whose space cannot be computed.
    #[must_use]
    pub fn failed(self, error: impl Into<String>) -> Self {
        Self {
            error: Some(error.into()),
            ..self
        }
    }

    /// Pair with its space, which took `seconds` to compute.
    ///
    /// # Errors
    /// If the space cannot be written as JSON, which plain data always can.
    pub fn known(
        entry: &PairEntry,
        space: &PairSpace,
        seconds: f64,
    ) -> Result<Self, serde_json::Error> {
        let symmetry = match space {
            PairSpace::Planar(space) => {
                let symmetry = space.symmetry();
                [symmetry.fixed, symmetry.moving]
            }
            _ => [space.fixed(), space.moving()].map(|p| p.symmetry().fold()),
        };
        let bands = match space {
            PairSpace::Planar(space) => space.bands().iter().map(|b| (b.lo, b.hi)).collect(),
            _ => Vec::new(),
        };
        let ranges = |index: usize| match space {
            PairSpace::FixedAxes(space) => space.regions().get(index).map(|r| {
                let range = |(lo, hi), open, around| SceneRange {
                    lo,
                    hi,
                    open,
                    around,
                };
                [
                    range(r.u, r.open_u, r.around_u),
                    range(r.v, r.open_v, r.around_v),
                ]
            }),
            _ => None,
        };
        let region = |(index, r): (usize, cspace::PairRegion)| SceneRegion {
            unbounded: r.unbounded,
            ranges: ranges(index),
            sample: match r.sample {
                Coordinates::Planar(c) => vec![c.x, c.y, c.theta],
                Coordinates::Axes { u, v } => vec![u, v],
            },
        };
        let features = space.features();
        Ok(Self {
            fixed: entry.fixed,
            moving: entry.moving,
            class: space.class(),
            space: Some(serde_json::to_string(&space.data())?),
            error: None,
            features: Counts {
                fixed: features.fixed,
                moving: features.moving,
            },
            symmetry: Counts {
                fixed: symmetry[0],
                moving: symmetry[1],
            },
            contact_distance: space.contact_distance(),
            resolution: space.resolution(),
            bands,
            regions: (space.regions().into_iter().enumerate())
                .map(region)
                .collect(),
            seconds,
        })
    }
}

//! The summary of a configuration space.

use cspace::fixed_axes::{AxesRegion, AxesStatistics};
use cspace::pair::{Joint, PermanentContact};
use cspace::{
    Axis, Configuration, Coordinates, Decisions, FreeRegion, Location, PairClass, PairSpace,
    RegionId, StageSeconds, Statistics, Window,
};
use cspace_plan::fits_exactly;
use schemars::JsonSchema;
use serde::Serialize;

use crate::subject::{Chosen, Source, Space};

/// The summary of a configuration space.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Summary {
    /// The name of the model, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// How the pair is treated.
    pub class: PairClass,
    /// How the parts are at zero motion; absent of a pair that never parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drawn: Option<Drawn>,
    /// Lines, arcs, and vertices that are not smooth joints.
    pub features: FeatureCount,
    /// The largest fold of a rotation about its own centre that maps the part to itself; 1 for none.
    pub symmetry: PerPart,
    /// Slabs of orientations of which one was computed.
    #[serde(skip)]
    pub slabs: u32,
    /// The orientations that were computed; absent of pairs without orientations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub window: Option<Window>,
    /// How the parts move that have no orientations: on axes or by a joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion: Option<Freedom>,
    /// Orientations at which the structure of the slice changes, radians, ascending.
    pub critical_orientations: Vec<f64>,
    /// How many bands the critical orientations make.
    pub bands: usize,
    /// Bands that were computed, after symmetry.
    pub slices: usize,
    /// Contact patches, or contact curves on fixed axes.
    pub patches: usize,
    /// How patches are linked.
    pub links: Links,
    /// Connected components of free space.
    pub free_regions: usize,
    /// The connected components of free space; their places in this list are their numbers.
    pub regions: Regions,
    /// How exact places are, in the model's unit of length.
    pub resolution: f64,
    /// A clearance below it counts as none, in the model's unit.
    pub least_clearance: f64,
    /// From where to where the patches are not relied upon alone, radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub doubtful_orientations: Option<Vec<(f64, f64)>>,
    /// Counts of the computation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub statistics: Option<Statistic>,
    /// How long it took this time: the stages, of a space that was computed, and their total.
    pub seconds: Seconds,
    /// True where the space was computed before, and read; left out otherwise.
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    pub cached: bool,
}

/// The degrees of freedom of a pair without orientations: two axes, or a joint.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "type")]
pub enum Freedom {
    /// Each part moves on an axis.
    Axes {
        /// The axis of the fixed part.
        fixed: Axis,
        /// The axis of the moving part.
        moving: Axis,
    },
    /// A joint connects the parts.
    Joint {
        /// The joint.
        joint: Joint,
        /// Least and greatest motion, if it is limited.
        limits: Option<(f64, f64)>,
        /// Contacts that the joint never gives up.
        permanent: Vec<PermanentContact>,
    },
}

/// Connected components of free space.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Regions {
    /// In x, y and theta.
    Planar(Vec<FreeRegion>),
    /// In u and v.
    Axes(Vec<AxesRegion>),
}

/// Counts of a computation.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Statistic {
    /// In x, y and theta.
    General(Counts),
    /// In u and v.
    Axes(AxesStatistics),
}

/// How long a computation took, in seconds.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Seconds {
    /// Each stage.
    Stages(StageSeconds),
    /// All together.
    Total {
        /// All together.
        total: f64,
    },
}

impl Seconds {
    /// All together.
    pub fn total(&self) -> f64 {
        match self {
            Self::Stages(s) => s.total,
            Self::Total { total } => *total,
        }
    }
}

/// Lines, arcs, and vertices that are not smooth joints, of two parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct FeatureCount {
    /// In the fixed part.
    pub fixed: u32,
    /// In the moving part.
    pub moving: u32,
    /// In both.
    pub total: u32,
}

/// A number for each part.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PerPart {
    /// For the fixed part.
    pub fixed: u32,
    /// For the moving part.
    pub moving: u32,
}

/// How patches are linked.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Links {
    /// Links at the left and right boundaries of patches.
    pub side: usize,
    /// Links across critical orientations.
    pub vertical: usize,
}

/// Counts of the computation of a space in x, y and theta.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Counts {
    /// Sheets: feature pairs that can touch, by intervals in which their ends keep their identity.
    pub sheets: u64,
    /// Pairs of sheets whose boxes meet.
    pub pairs: u64,
    /// Orientations examined as possibly critical, from pairs of sheets.
    pub pair_events: u64,
    /// Orientations at which three sheets meet.
    pub triple_events: u64,
    /// Different orientations among all events.
    pub clusters: u64,
    /// Crossings of two sheets; of large pairs, without those that are certainly in blocked space.
    pub branches: u64,
    /// Pieces of sheets.
    pub cells: u64,
    /// Configurations tested for overlap.
    pub overlap_tests: u64,
    /// How often the computation contradicted itself; 0 in sound computations.
    pub conflicts: u64,
    /// Counts of decisions, by the certainty reached.
    pub decisions: Decisions,
}

impl From<&Statistics> for Counts {
    fn from(s: &Statistics) -> Self {
        Self {
            sheets: s.sheets,
            pairs: s.pairs,
            pair_events: s.pair_events,
            triple_events: s.triple_events,
            clusters: s.clusters,
            branches: s.branches,
            cells: s.cells,
            overlap_tests: s.overlap_tests,
            conflicts: s.conflicts,
            decisions: s.decisions,
        }
    }
}

/// How the parts are at zero motion.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Drawn {
    /// In a word.
    pub outcome: AsDrawn,
    /// The number of the free region.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<RegionId>,
    /// How far the parts are apart where they are free; none if they are at different heights.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clearance: Option<f64>,
}

/// How the parts are at zero motion, in a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AsDrawn {
    /// They do not touch.
    Free,
    /// They touch.
    Contact,
    /// They touch, and have no room to move.
    ExactFit,
    /// They overlap.
    Blocked,
    /// Zero motion is outside of what was computed.
    Outside,
}

impl Drawn {
    /// `None` for a lower pair, which is in contact in all configurations.
    fn of(space: &PairSpace) -> Option<Self> {
        let at = match space {
            PairSpace::Lower(_) => return None,
            PairSpace::FixedAxes(_) => Coordinates::Axes { u: 0.0, v: 0.0 },
            PairSpace::Planar(_) => Coordinates::Planar(Configuration::default()),
        };
        let (outcome, region) = match space.locate(at) {
            Ok(Location::Free(region)) => (AsDrawn::Free, Some(region)),
            Ok(Location::Contact) => (AsDrawn::Contact, None),
            Ok(Location::Blocked) if fits_exactly(space, at).unwrap_or(false) => {
                (AsDrawn::ExactFit, None)
            }
            Ok(Location::Blocked) => (AsDrawn::Blocked, None),
            Ok(Location::Outside) | Err(_) => (AsDrawn::Outside, None),
        };
        Some(Self {
            outcome,
            region,
            clearance: (region.and_then(|_| space.clearance(at).ok())).filter(|c| c.is_finite()),
        })
    }
}

impl Summary {
    /// Sums up the space of a pair.
    pub(super) fn of(pair: &Chosen<'_>, space: &Space<'_>) -> Self {
        let features = space.features();
        let mut summary = Self {
            model: pair.model_name().map(str::to_owned),
            class: space.class(),
            drawn: Drawn::of(space),
            features: FeatureCount {
                fixed: features.fixed,
                moving: features.moving,
                total: features.fixed + features.moving,
            },
            symmetry: PerPart {
                fixed: pair.fixed().symmetry().fold(),
                moving: pair.moving().symmetry().fold(),
            },
            slabs: 1,
            window: None,
            motion: None,
            critical_orientations: Vec::new(),
            bands: space.band_count(),
            slices: space.band_count(),
            patches: space.patch_count(),
            links: Links {
                side: 0,
                vertical: 0,
            },
            free_regions: space.region_count(),
            regions: Regions::Planar(Vec::new()),
            resolution: space.resolution(),
            least_clearance: space.least_clearance(),
            doubtful_orientations: None,
            statistics: None,
            seconds: Seconds::Total {
                total: space.seconds,
            },
            cached: space.source != Source::Computed,
        };
        summary.add(space);
        summary
    }

    /// Adds what spaces of its class have.
    fn add(&mut self, space: &PairSpace) {
        match space {
            PairSpace::Lower(lower) => {
                self.slices = 0;
                self.motion = Some(Freedom::Joint {
                    joint: lower.joint(),
                    limits: lower.limits(),
                    permanent: lower.contacts().to_vec(),
                });
            }
            PairSpace::FixedAxes(space) => {
                let (fixed, moving) = space.axes();
                self.motion = Some(Freedom::Axes { fixed, moving });
                self.links.side = space.patches().iter().filter(|p| p.next.is_some()).count();
                self.regions = Regions::Axes(space.regions());
                self.statistics = Some(Statistic::Axes(space.statistics()));
            }
            PairSpace::Planar(space) => {
                let symmetry = space.symmetry();
                self.symmetry = PerPart {
                    fixed: symmetry.fixed,
                    moving: symmetry.moving,
                };
                self.slabs = symmetry.slabs;
                self.window = Some(space.window());
                self.critical_orientations = space.critical_orientations().to_vec();
                self.slices = space.computed_bands();
                self.links = Links {
                    side: space.side_links().len(),
                    vertical: space.vertical_links().len(),
                };
                self.regions = Regions::Planar(space.free_regions().to_vec());
                self.doubtful_orientations = Some(space.doubtful_orientations().to_vec());
                self.statistics = Some(Statistic::General(space.statistics().into()));
                // The stages that are read with a space are those of an earlier run.
                if !self.cached {
                    self.seconds = Seconds::Stages(space.statistics().seconds);
                }
            }
        }
    }
}

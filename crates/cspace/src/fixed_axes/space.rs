//! The configuration space of a pair with fixed axes.

use crate::feature::FeatureName;
use crate::feature::tolerance::CONTACT;
use crate::geometry::{Configuration, Rotation};
use crate::part::Part;

use super::adjust::Aside;
use super::arrange::{Arrangement, Cell};
use super::axis::{AxesError, Axis};
use super::bands::regions;
use super::bands::{Bands, Graphs, Sweep};
use super::build::build;
use super::chain::chains;
use super::copies::Partition;
use super::domain::Extent;
use super::judge::Bodies;
use super::judge::Judge;
use super::motion::Motions;
use super::patch::{AxesBranch, AxesPatch};
use super::piece::{Pair, Piece};
use super::setup::{Map, Setting};
use super::tolerance::{MOST_EDGE_PAIRS, MOST_MEETINGS};

/// The configuration space of two parts on fixed axes.
#[derive(Debug)]
pub struct FixedAxesSpace {
    pub(super) fixed: Part,
    pub(super) moving: Part,
    pub(super) axes: (Axis, Axis),
    pub(super) map: Map,
    pub(super) motions: Motions,
    pub(super) x: Extent,
    pub(super) y: Extent,
    pub(super) names: (Vec<FeatureName>, Vec<FeatureName>),
    pub(super) pairs: Vec<Pair>,
    pub(super) pieces: Vec<Piece>,
    pub(super) cells: Vec<Cell>,
    pub(super) free: Vec<bool>,
    pub(super) bands: Bands,
    pub(super) deviation: f64,
    pub(super) grown: f64,
    pub(super) aside: Aside,
    pub(super) bodies: Bodies,
    pub(super) slots: Vec<Vec<u32>>,
    pub(super) patches: Vec<AxesPatch>,
    pub(super) branches: Vec<AxesBranch>,
    pub(super) statistics: AxesStatistics,
}

/// Counts of a computation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
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
    /// Places at which tests and structure told different things, or the structure contradicts itself, that no attempt was
    /// without; 0 unless something lies closer than the resolution. If there are any, configurations are classified by
    /// intersecting the placed parts, and regions and patches are not to be relied upon.
    pub conflicts: usize,
}

impl FixedAxesSpace {
    /// Computes the configuration space of a pair.
    ///
    /// Both parts are drawn in the assembly's frame at zero motion.
    ///
    /// # Errors
    /// If an axis has no direction, an empty range, numbers that are not finite, or a pivot far away; if the parts have too
    /// many edges.
    pub fn compute(
        fixed: &Part,
        fixed_axis: Axis,
        moving: &Part,
        moving_axis: Axis,
    ) -> Result<Self, AxesError> {
        let edges = (fixed.edges().count(), moving.edges().count());
        if edges.0.saturating_mul(edges.1) > MOST_EDGE_PAIRS {
            return Err(AxesError::TooLarge {
                fixed: edges.0,
                moving: edges.1,
                limit: MOST_EDGE_PAIRS,
            });
        }
        let at = |aside| Self::compute_aside(fixed, fixed_axis, moving, moving_axis, aside);
        let (mut best, mut fewest) = at(Aside::default())?;
        for aside in Aside::attempts() {
            if fewest == 0 {
                break;
            }
            let (space, faults) = at(aside)?;
            if faults < fewest {
                (best, fewest) = (space, faults);
            }
        }
        best.statistics.conflicts = fewest;
        Ok(best)
    }

    /// The space of the parts aside of where they are drawn, and how often it contradicts itself.
    fn compute_aside(
        fixed: &Part,
        fixed_axis: Axis,
        moving: &Part,
        moving_axis: Axis,
        aside: Aside,
    ) -> Result<(Self, usize), AxesError> {
        let Setting {
            map,
            scene,
            bodies,
            names,
            deviation,
            grown,
        } = Setting::new(fixed, fixed_axis, moving, moving_axis, aside)?;
        let window = scene.repeats.window(&scene.x);
        let (pairs, pieces) = build(&scene);
        let Some(arrangement) = Arrangement::new(&pairs, &pieces, &scene.y) else {
            return Err(AxesError::TooManyCrossings {
                fixed: fixed.edges().count(),
                moving: moving.edges().count(),
                limit: MOST_MEETINGS,
            });
        };
        let judge = Judge::new(&pairs, &pieces, &bodies, window, scene.y);
        let mut verdicts = judge.verdicts(&arrangement);
        let sweep = |free: &[bool]| {
            Sweep {
                graphs: Graphs {
                    pairs: &pairs,
                    pieces: &pieces,
                    cells: &arrangement.cells,
                    y: scene.y,
                },
                free,
                bodies: &bodies,
                x: window,
            }
            .run()
        };
        let mut swept = sweep(&verdicts.free);
        if swept.contradictions > 0 {
            // A chain hangs together that should not, or a crossing is missed: what is tested gap by gap tells.
            let each = judge.one_by_one(&arrangement.cells);
            let again = sweep(&each.free);
            verdicts.tests += swept.tests + each.tests;
            verdicts.conflicts += swept.conflicts;
            verdicts.free = each.free;
            swept = again;
        }
        // Each pair of features once, whatever copies of the window it touches in.
        let mut touching: Vec<(u32, u32)> = (pairs.iter())
            .map(|p| (scene.repeats.feature(p.first).of, p.second))
            .collect();
        touching.sort_unstable();
        touching.dedup();
        let fold = scene.repeats.fold as usize;
        let statistics = AxesStatistics {
            pairs: fold * touching.len(),
            pieces: fold * pieces.len(),
            crossings: fold * arrangement.crossings,
            tests: verdicts.tests + swept.tests,
            conflicts: verdicts.conflicts + swept.conflicts,
        };
        let Partition {
            pairs,
            pieces,
            cells,
            joints,
            free,
            swept,
            ..
        } = Partition {
            pairs,
            pieces,
            cells: arrangement.cells,
            joints: arrangement.joints,
            free: verdicts.free,
            swept,
            crossings: arrangement.crossings,
        }
        .kept()
        .unrolled(&scene);
        let mut space = Self {
            fixed: fixed.clone(),
            moving: moving.clone(),
            axes: (fixed_axis, moving_axis),
            map,
            motions: scene.motions,
            x: scene.x,
            y: scene.y,
            names,
            pairs,
            pieces,
            cells,
            free,
            bands: regions(swept, &scene.y),
            deviation,
            grown,
            aside,
            bodies,
            slots: Vec::new(),
            patches: Vec::new(),
            branches: Vec::new(),
            statistics,
        };
        space.slots = space.near_slots();
        // A pair of features has an entry for each copy of the window in which it touches, and a circle that was divided
        // to make a part symmetric has several features of one name.
        let (firsts, seconds) = &space.names;
        let same = |p: &Pair, q: &Pair| {
            firsts[p.first as usize] == firsts[q.first as usize]
                && seconds[p.second as usize] == seconds[q.second as usize]
        };
        let chains = chains(
            &space.pairs,
            &space.pieces,
            &space.cells,
            &space.free,
            &joints,
            (space.x, space.y),
            same,
        );
        space.set_patches(chains);
        let faults = space.faults(&verdicts.overlaps);
        Ok((space, faults))
    }

    /// The part called fixed.
    pub fn fixed(&self) -> &Part {
        &self.fixed
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        &self.moving
    }

    /// The axes of the fixed and of the moving part.
    pub fn axes(&self) -> (Axis, Axis) {
        self.axes
    }

    /// Counts of the computation.
    pub fn statistics(&self) -> AxesStatistics {
        self.statistics
    }

    /// The resolution in the model's unit of length: clearances below it count as none.
    ///
    /// Where a part's symmetry about its pivot is used, how far the part as drawn is from being symmetric belongs to it; and
    /// where parts were moved to break a tie, how far: 10⁻¹⁰ to 10⁻⁸ of the parts' size. It is more if a part has a corner of
    /// less than some 30°: parts are grown, and such a corner by more than its sides.
    pub fn resolution(&self) -> f64 {
        self.contact_distance() + self.grown
    }

    /// Configurations at which a contact function is less than this are in contact (model length): the resolution, but for
    /// what corners are grown by.
    pub(super) fn contact_distance(&self) -> f64 {
        self.map.frame.outer_length(CONTACT) + self.deviation
    }

    /// Where the moving part is in the fixed part's frame at (u, v).
    pub fn configuration(&self, u: f64, v: f64) -> Configuration {
        let (x, y) = self.map.inner(u, v);
        let (p, theta) = if self.map.swapped {
            self.motions.swapped().relative(y, x)
        } else {
            self.motions.relative(x, y)
        };
        // Both parts are drawn about the fixed part's centre c: c + p + R (q − c) places a point q.
        let c = self.map.frame.fixed_center.to_vector();
        let turned = Rotation::by(theta) * c;
        let at = p.to_vector() * (1.0 / self.map.frame.scale) + c - turned;
        Configuration::new(at.x, at.y, theta)
    }
}

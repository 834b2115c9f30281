//! Computation of the space: setup, cells, verdicts, sweep, copies, and patches.

use crate::part::Part;

use super::arrange::Arrangement;
use super::axis::{AxesError, Axis, Role};
use super::build::build;
use super::carriers::Carriers;
use super::copies::Partition;
use super::data::{AxesData, AxesStatistics, FORMAT, SAVED_AXES_VERSION};
use super::displacement::Displacement;
use super::judge::Judge;
use super::patches::{Patches, chains};
use super::piece::Pair;
use super::region::{AxesRegion, components};
use super::scene::Scene;
use super::setup::{Bodies, set_up};
use super::space::FixedAxesSpace;
use super::sweep::{Gaps, Graphs, Sweep};
use super::tolerance::{MOST_EDGE_PAIRS, MOST_MEETINGS};

impl FixedAxesSpace {
    /// Computes the configuration space of a pair.
    ///
    /// Both parts are drawn in the assembly's frame at zero motion.
    ///
    /// # Errors
    /// If an axis has no direction, an empty range, numbers that are not finite, or a pivot far away; or if the parts have too many edges.
    pub fn compute(
        fixed: &Part,
        fixed_axis: Axis,
        moving: &Part,
        moving_axis: Axis,
    ) -> Result<Self, AxesError> {
        Self::swept((fixed, fixed_axis), (moving, moving_axis), None)
    }

    /// Computes the space, swept along the coordinate of a given part, if any.
    pub(super) fn swept(
        (fixed, fixed_axis): (&Part, Axis),
        (moving, moving_axis): (&Part, Axis),
        along: Option<Role>,
    ) -> Result<Self, AxesError> {
        let edges = (fixed.edges().count(), moving.edges().count());
        if edges.0.saturating_mul(edges.1) > MOST_EDGE_PAIRS {
            return Err(AxesError::TooLarge {
                fixed: edges.0,
                moving: edges.1,
                limit: MOST_EDGE_PAIRS,
            });
        }
        let at = |d| displaced((fixed, moving), (fixed_axis, moving_axis), d, along);
        let drawn = at(Displacement::NONE)?;
        if drawn.statistics().conflicts == 0 {
            return Ok(drawn);
        }
        for displacement in Displacement::others() {
            let other = at(displacement)?;
            if other.statistics().conflicts == 0 {
                return Ok(other);
            }
        }
        // If all attempts have conflicts, the parts are best intersected as drawn.
        Ok(drawn)
    }
}

/// The space of the parts displaced from where they are drawn; every fault is counted as a conflict.
fn displaced(
    (fixed, moving): (&Part, &Part),
    axes: (Axis, Axis),
    displacement: Displacement,
    along: Option<Role>,
) -> Result<FixedAxesSpace, AxesError> {
    let (setting, scene) = set_up((fixed, moving), axes, displacement, along)?;
    let Some(window) = ComputedWindow::new(&scene, &setting.bodies) else {
        return Err(AxesError::TooManyCrossings {
            fixed: fixed.edges().count(),
            moving: moving.edges().count(),
            limit: MOST_MEETINGS,
        });
    };
    let Partition {
        pairs,
        pieces,
        cells,
        joints,
        swept,
        ..
    } = window.partition.unrolled(&scene);
    let (bands, gaps, regions) = components(swept, &scene.y);
    let found = Gaps {
        graphs: Graphs {
            pairs: &pairs,
            pieces: &pieces,
            cells: &cells,
            y: scene.y,
        },
        bands: &bands,
        gaps: &gaps,
        x: scene.x,
    };
    // A pair of features has an entry for each copy of the window in which it touches, and a circle that was divided to make a part
    // symmetric has several features of one name.
    let (firsts, seconds) = &setting.names;
    let same = |p: &Pair, q: &Pair| {
        firsts[p.first as usize] == firsts[q.first as usize]
            && seconds[p.second as usize] == seconds[q.second as usize]
    };
    let chains = chains(&found.graphs, &scene.x, &joints, same);
    let (patches, branches) = Patches {
        setting: &setting,
        gaps: found,
    }
    .of(chains);
    let data = AxesData {
        format: FORMAT.to_owned(),
        version: SAVED_AXES_VERSION,
        fixed: fixed.clone(),
        moving: moving.clone(),
        fixed_axis: axes.0,
        moving_axis: axes.1,
        patches,
        branches,
        free_regions: (regions.iter())
            .map(|r| AxesRegion::new(r, &setting))
            .collect(),
        statistics: window.statistics,
        displacement,
        map: setting.map,
        motions: setting.motions,
        x: setting.x,
        y: setting.y,
        first_names: firsts.clone(),
        second_names: seconds.clone(),
        pairs: (pairs.iter())
            .map(|p| (p.first, p.second, Carriers::of(&p.condition)))
            .collect(),
        pieces,
        // Only free cells are kept.
        free: vec![true; cells.len()],
        cells,
        bands,
        gaps,
        regions,
    };
    let mut space = FixedAxesSpace::new(data, setting, pairs);
    space.data.statistics.conflicts = space.faults(&window.overlaps);
    Ok(space)
}

/// The computed window: the partition of free space in it.
struct ComputedWindow {
    partition: Partition,
    statistics: AxesStatistics,
    /// Configurations beside cells, away from all curves, at which the parts overlap.
    overlaps: Vec<(f64, f64)>,
}

impl ComputedWindow {
    /// Computes the window; `None` if more curves may cross than the limit.
    fn new(scene: &Scene, bodies: &Bodies) -> Option<Self> {
        let x = scene.repeats.window(&scene.x);
        let (pairs, pieces) = build(scene);
        let arrangement = Arrangement::new(&pairs, &pieces, &scene.y)?;
        let graphs = Graphs {
            pairs: &pairs,
            pieces: &pieces,
            cells: &arrangement.cells,
            y: scene.y,
        };
        let judge = Judge::new(graphs, bodies, x);
        let mut verdicts = judge.verdicts(&arrangement);
        let sweep = |free: &[bool]| {
            let sweep = Sweep {
                graphs,
                free,
                bodies,
                x,
            };
            sweep.run()
        };
        let (mut swept, mut tally) = sweep(&verdicts.free);
        if tally.contradictions > 0 {
            // A chain connects cells that should not be connected, or a crossing is missing: the tests of the gaps show it.
            verdicts.free = judge.one_by_one(&arrangement.cells);
            verdicts.tests += tally.tests + arrangement.cells.len();
            verdicts.conflicts += tally.conflicts;
            (swept, tally) = sweep(&verdicts.free);
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
            tests: verdicts.tests + tally.tests,
            conflicts: verdicts.conflicts + tally.conflicts,
        };
        let partition = Partition {
            crossings: arrangement.crossings,
            cells: arrangement.cells,
            joints: arrangement.joints,
            pairs,
            pieces,
            swept,
        };
        Some(Self {
            partition: partition.kept(&verdicts.free),
            statistics,
            overlaps: verdicts.overlaps,
        })
    }
}

//! Pairs on fixed axes by a method without contact curves: a collision library is asked at every cell of a grid.
//!
//! The library is `parry2d`, as for single configurations. (Convex pieces would need a decomposition of polygons with holes,
//! which it has not, and are slower: a gear has many.)

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::fixed_axes::AxisMotion;
use cspace::{Axis, Classification, Edge, FixedAxesSpace, Part, Point, Rotation, Vector};
use cspace_oracle::Oracle;
use cspace_oracle::shapes::mechanisms::{Mechanism, gears, geneva, mechanisms};
use parry2d_f64::math::{Pose, Vector as V};
use rayon::prelude::*;
use serde::Serialize;

use crate::checks::parry::Polygons;
use crate::stack::CHORD;
use crate::{Failure, median};

/// Cells along each coordinate.
const CELLS: usize = 1024;
/// Number of rows from which the time of all is estimated.
const TRIED: usize = 16;
/// Estimated time, in seconds, beyond which only some rows are run.
const LONG: f64 = 2.0;
/// Then one of so many rows is run.
const EVERY: usize = 8;
/// Largest number of disagreements between grid and space of which the oracle is asked.
const ASKED: usize = 3000;
/// Number of runs, of which the median time counts.
const RUNS: usize = 15;

/// A grid beside the space of the same pair.
#[derive(Serialize)]
pub(crate) struct Row {
    pub(crate) pair: String,
    pub(crate) seconds_of_space: f64,
    pub(crate) cells: [usize; 2],
    pub(crate) seconds_of_grid: f64,
    /// One of so many rows was run, and the time is scaled.
    pub(crate) every: usize,
    /// Verdicts compared; those in contact are left out.
    pub(crate) compared: usize,
    pub(crate) differ: usize,
    /// Differing verdicts of which brute force is certain, among those that it was asked about.
    pub(crate) certain: usize,
    pub(crate) grid_wrong: usize,
    /// Size of a cell.
    pub(crate) step: [f64; 2],
    /// Largest displacement of points of the parts within a cell: smaller clearances are missed.
    pub(crate) moved: f64,
    pub(crate) resolution_of_space: f64,
    pub(crate) play: Option<Play>,
}

/// The play of the moving part where the largest free region is.
#[derive(Serialize)]
pub(crate) struct Play {
    /// The fixed part's coordinate.
    pub(crate) at: f64,
    /// Play by the space.
    pub(crate) exact: f64,
    /// Play by the grid.
    pub(crate) seen: f64,
}

/// Measures the pairs whose names contain a word.
pub(crate) fn measure(word: &str) -> Result<Vec<Row>, Failure> {
    let mut all = vec![gears(14, 12), gears(20, 18), geneva(6, 0.05)];
    all.extend(mechanisms());
    all.retain(|m| m.name.contains(word));
    all.iter().map(row).collect()
}

/// Middles of the cells of a coordinate, the part's places there, and how far its points move from one cell to the next.
struct Cells {
    at: Vec<f64>,
    poses: Vec<Pose>,
    step: f64,
    moved: f64,
}

impl Cells {
    fn new(part: &Part, axis: &Axis, (lo, hi): (f64, f64)) -> Self {
        let n = if axis.motion == AxisMotion::Fixed {
            1
        } else {
            CELLS
        };
        let step = (hi - lo) / n as f64;
        let at: Vec<f64> = (0..n).map(|k| lo + step * (k as f64 + 0.5)).collect();
        let pose = |t: f64| match axis.motion {
            AxisMotion::Fixed => Pose::IDENTITY,
            AxisMotion::Revolute { center } => {
                let shift = center.to_vector() - Rotation::by(t) * center.to_vector();
                Pose::new(V::new(shift.x, shift.y), t)
            }
            AxisMotion::Prismatic { direction } => {
                let shift: Vector = direction.unit() * t;
                Pose::new(V::new(shift.x, shift.y), 0.0)
            }
        };
        let far = |center: Point| {
            let far = |e: Edge| e.start.distance(center);
            part.edges().map(far).fold(0.0, f64::max)
        };
        let moved = match axis.motion {
            AxisMotion::Fixed => 0.0,
            AxisMotion::Revolute { center } => step * far(center),
            AxisMotion::Prismatic { .. } => step,
        };
        Self {
            poses: at.iter().map(|&t| pose(t)).collect(),
            at,
            step,
            moved,
        }
    }
}

fn row(m: &Mechanism) -> Result<Row, Failure> {
    let compute = || FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis);
    let mut times = Vec::new();
    for _ in 0..RUNS {
        let begin = Instant::now();
        black_box(compute()?);
        times.push(begin.elapsed().as_secs_f64());
    }
    let space = compute()?;
    let oracle = Oracle::new(&m.fixed, &m.moving);
    let size = oracle.size();
    let [a, b] = [&m.fixed, &m.moving].map(|part| Polygons::new(part, CHORD * size));
    let [u, v] = space.extent();
    let (us, vs) = (
        Cells::new(&m.fixed, &m.fixed_axis, u),
        Cells::new(&m.moving, &m.moving_axis, v),
    );
    let overlaps = |at: &Pose, bt: &Pose| a.overlaps(at, &b, bt) == Some(true);
    let verdicts = |i: usize| -> Vec<bool> {
        (vs.poses.iter())
            .map(|bt| overlaps(&us.poses[i], bt))
            .collect()
    };
    let rows = us.at.len();
    let run = |every: usize| {
        let chosen: Vec<usize> = (0..rows).step_by(every).collect();
        let begin = Instant::now();
        let done: Vec<Vec<bool>> = chosen.par_iter().map(|&i| verdicts(i)).collect();
        let seconds = begin.elapsed().as_secs_f64() * rows as f64 / chosen.len() as f64;
        (chosen, black_box(done), seconds)
    };
    let sample = run((rows / TRIED).max(1));
    let every = if sample.2 > LONG { EVERY } else { 1 };
    let (chosen, grid, seconds) = run(every);
    let mut differ = Vec::new();
    let mut compared = 0;
    for (&i, verdicts) in chosen.iter().zip(&grid) {
        for (&t, &overlap) in vs.at.iter().zip(verdicts) {
            let class = space.classify(us.at[i], t);
            if matches!(class, None | Some(Classification::Contact)) {
                continue;
            }
            compared += 1;
            if (class == Some(Classification::Blocked)) != overlap {
                differ.push((us.at[i], t, overlap));
            }
        }
    }
    let (mut certain, mut grid_wrong) = (0, 0);
    for &(u, v, overlap) in differ.iter().step_by((differ.len() / ASKED).max(1)) {
        let verdict = oracle.judge(space.configuration(u, v));
        if verdict.margin > 1e-10 * size {
            certain += 1;
            grid_wrong += usize::from(verdict.overlap != overlap);
        }
    }
    Ok(Row {
        pair: m.name.clone(),
        seconds_of_space: median(times),
        cells: [rows, vs.at.len()],
        seconds_of_grid: seconds,
        every,
        compared,
        differ: differ.len(),
        certain,
        grid_wrong,
        step: [us.step, vs.step],
        moved: us.moved + vs.moved,
        resolution_of_space: space.resolution(),
        play: play(&space, &us, &vs, &chosen, &grid),
    })
}

/// The play of the moving part where the largest free region is: as the space has it, and as the grid has it.
fn play(
    space: &FixedAxesSpace,
    us: &Cells,
    vs: &Cells,
    chosen: &[usize],
    grid: &[Vec<bool>],
) -> Option<Play> {
    let region = space.regions().first().copied()?;
    let off = |at: f64, to: f64| (at - to).abs();
    let nearest = |at: f64, values: &mut dyn Iterator<Item = f64>| {
        values
            .enumerate()
            .min_by(|a, b| off(a.1, at).total_cmp(&off(b.1, at)))
            .map_or(0, |f| f.0)
    };
    let r = nearest(region.sample.0, &mut chosen.iter().map(|&i| us.at[i]));
    let u = us.at[chosen[r]];
    let c = nearest(region.sample.1, &mut vs.at.iter().copied());
    let way = |rate: f64| match space.first_contact((u, vs.at[c]), (0.0, rate), TAU) {
        Ok(AxesMotionOutcome::Contact(contact)) => Some(contact.time),
        _ => None,
    };
    let (up, down) = (way(1.0)?, way(-1.0)?);
    let free = |k: i64| !grid[r][k.rem_euclid(vs.at.len() as i64) as usize];
    let most = vs.at.len() as i64;
    let run = |by: i64| (0..most).take_while(|k| free(c as i64 + by * k)).count();
    let cells = (run(1) + run(-1)).saturating_sub(1);
    Some(Play {
        at: u,
        exact: up + down,
        seen: cells as f64 * vs.step,
    })
}

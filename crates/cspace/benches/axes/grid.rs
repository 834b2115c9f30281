//! What one does without contact curves: ask a collision library at every cell of a grid.
//!
//! The library is `parry2d`, in double precision. It has no arcs, so they become chords, [`CHORD`] of the pair's size from
//! the arc at most. A part is the polyline of its boundary in a tree of boxes; where boundaries do not meet, one part may be
//! within the other, which the even-odd rule tells of a vertex of each loop. (Convex pieces would need a decomposition of
//! polygons with holes, which the library has not, and are slower: a gear has many.)

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::fixed_axes::AxisMotion;
use cspace::{Axis, Classification, Edge, FixedAxesSpace, Part, Point, Vector};
use cspace_oracle::Oracle;
use cspace_oracle::shapes::mechanisms::Mechanism;
use parry2d_f64::math::{Pose, Vector as V};
use parry2d_f64::query::intersection_test;
use parry2d_f64::shape::Polyline;
use rayon::prelude::*;

/// How far a chord may be from its arc, as a share of the pair's size.
const CHORD: f64 = 1e-4;
/// Cells along each coordinate.
const CELLS: usize = 1024;
/// Rows that are tried to tell how long all take.
const TRIED: usize = 16;
/// If all rows take longer than this, only some are run.
const LONG: f64 = 2.0;
/// Every so many rows then.
const EVERY: usize = 8;
/// Verdicts on which grid and space disagree of which the oracle is asked, at most.
const ASKED: usize = 3000;

/// A part as polygons.
struct Polygons {
    loops: Vec<Vec<V>>,
    lines: Polyline,
}

impl Polygons {
    fn new(part: &Part, chord: f64) -> Self {
        let mut loops: Vec<Vec<V>> = Vec::new();
        for l in part.loops() {
            let mut points = Vec::new();
            for e in l.edges() {
                chords(&e, chord, &mut points);
            }
            loops.push(points);
        }
        let mut indices = Vec::new();
        let mut first = 0;
        for l in &loops {
            let n = l.len() as u32;
            indices.extend((0..n).map(|k| [first + k, first + (k + 1) % n]));
            first += n;
        }
        let lines = Polyline::new(loops.concat(), Some(indices));
        Self { loops, lines }
    }

    /// Whether a point is in the material: a ray to the right crosses the boundary an odd number of times.
    fn contains(&self, p: V) -> bool {
        let mut inside = false;
        for l in &self.loops {
            for (i, a) in l.iter().enumerate() {
                let b = l[(i + 1) % l.len()];
                if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
                {
                    inside = !inside;
                }
            }
        }
        inside
    }

    /// Whether a loop of the other part, not meeting this boundary, is within the material.
    fn holds(&self, own: &Pose, other: &Self, its: &Pose) -> bool {
        other
            .loops
            .iter()
            .any(|l| self.contains(own.inverse_transform_point(its.transform_point(l[0]))))
    }
}

/// The start of an edge and points along it, so many that no chord is farther than `chord` from the arc.
fn chords(e: &Edge, chord: f64, points: &mut Vec<V>) {
    points.push(V::new(e.start.x, e.start.y));
    if e.is_line() {
        return;
    }
    let share = (1.0 - chord / e.radius().abs()).max(-1.0);
    let pieces = (e.sweep().abs() / (2.0 * share.acos())).ceil().max(1.0);
    let (center, arm) = (e.center(), e.start - e.center());
    for k in 1..pieces as usize {
        let turn = cspace::Rotation::by(e.sweep() * k as f64 / pieces);
        let p = center + turn * arm;
        points.push(V::new(p.x, p.y));
    }
}

fn overlaps(a: &Polygons, at: &Pose, b: &Polygons, bt: &Pose) -> bool {
    intersection_test(at, &a.lines, bt, &b.lines).is_ok_and(|t| t.intersecting)
        || a.holds(at, b, bt)
        || b.holds(bt, a, at)
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
                let shift = center.to_vector() - cspace::Rotation::by(t) * center.to_vector();
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

/// Runs the grid and tells of it, beside a space that took so many milliseconds.
pub(crate) fn report(m: &Mechanism, space: &FixedAxesSpace, ours: f64) {
    let oracle = Oracle::new(&m.fixed, &m.moving);
    let size = oracle.size();
    let (a, b) = (
        Polygons::new(&m.fixed, CHORD * size),
        Polygons::new(&m.moving, CHORD * size),
    );
    let [u, v] = space.extent();
    let (us, vs) = (
        Cells::new(&m.fixed, &m.fixed_axis, u),
        Cells::new(&m.moving, &m.moving_axis, v),
    );
    let row = |i: usize| -> Vec<bool> {
        vs.poses
            .iter()
            .map(|bt| overlaps(&a, &us.poses[i], &b, bt))
            .collect()
    };
    let rows = us.at.len();
    let run = |every: usize| {
        let chosen: Vec<usize> = (0..rows).step_by(every).collect();
        let begin = Instant::now();
        let done: Vec<Vec<bool>> = chosen.par_iter().map(|&i| row(i)).collect();
        let seconds = begin.elapsed().as_secs_f64() * rows as f64 / chosen.len() as f64;
        (chosen, black_box(done), seconds)
    };
    let sample = run((rows / TRIED).max(1));
    let every = if sample.2 > LONG { EVERY } else { 1 };
    let (chosen, grid, seconds) = run(every);
    let part = if every > 1 {
        format!("every {EVERY}th row run, scaled")
    } else {
        "all rows run".into()
    };
    println!(
        "    grid of {} x {} checks with parry2d: {:9.1} ms ({part}), {:.0} times ours",
        rows,
        vs.at.len(),
        1e3 * seconds,
        1e3 * seconds / ours
    );
    // Where the verdicts differ; configurations in contact are left out.
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
    let (mut asked, mut grid_wrong) = (0, 0);
    for &(u, v, overlap) in differ.iter().step_by((differ.len() / ASKED).max(1)) {
        let verdict = oracle.judge(space.configuration(u, v));
        if verdict.margin > 1e-10 * size {
            asked += 1;
            grid_wrong += usize::from(verdict.overlap != overlap);
        }
    }
    println!(
        "      {} of {compared} verdicts differ from ours; of {asked} of them the oracle says that the grid is wrong in {grid_wrong}; arcs are chords within {:.1e}",
        differ.len(),
        CHORD * size
    );
    println!(
        "      a cell is {:.2e} by {:.2e}, in which points move by up to {:.1e}: clearances of less are not seen (ours: {:.1e}){}",
        us.step,
        vs.step,
        us.moved + vs.moved,
        space.resolution(),
        play(space, &us, &vs, &chosen, &grid)
    );
}

/// The play of the moving part where the largest free region is: as the space has it, and as the grid has it.
fn play(
    space: &FixedAxesSpace,
    us: &Cells,
    vs: &Cells,
    chosen: &[usize],
    grid: &[Vec<bool>],
) -> String {
    let none = String::new();
    let Some(region) = space.regions().first().copied() else {
        return none;
    };
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
    let (Some(up), Some(down)) = (way(1.0), way(-1.0)) else {
        return none;
    };
    let free = |k: i64| !grid[r][k.rem_euclid(vs.at.len() as i64) as usize];
    let most = vs.at.len() as i64;
    let run = |by: i64| (0..most).take_while(|k| free(c as i64 + by * k)).count();
    let cells = (run(1) + run(-1)).saturating_sub(1);
    let exact = up + down;
    let seen = cells as f64 * vs.step;
    format!(
        "; the moving part's play at u = {u:.4} is {exact:.6}, on the grid {seen:.6}: {:.1} % off",
        100.0 * (seen - exact).abs() / exact
    )
}

//! Division of a run into the fewest pieces between samples that are tangent to each other.
//!
//! A piece from sample i to sample j that leaves i at the angle δ to the curve has half the sweep a = φ − δ, where φ is the
//! angle from the curve's direction at i to the chord; it arrives at j at the angle a − ψ, where ψ is that from the chord to
//! the curve's direction at j. So a chain of tangent pieces is a path through states (sample, δ), and dynamic programming
//! finds the one with the fewest pieces. Angles are distinguished by cells whose width corresponds to a small part of
//! the tolerance; of the paths into a cell, the one that stays farther from the edges of the band is kept. A chain
//! arrives at a given angle except for part of a cell.

use super::bulges::{Tested, allowed};
use super::run::{Run, RunEnd};

/// Angles below this are no kink: rounding of directions of short pieces.
pub(super) const SMOOTH: f64 = 1e-11;

/// A run in pieces, each a line or an arc.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Division {
    /// The samples at which pieces meet, ends included; the last of a closed run is the first, a turn on.
    pub(super) joints: Vec<usize>,
    /// The bulge of each piece.
    pub(super) bulges: Vec<f64>,
}

/// Arcs between candidates for joints that pass the samples between them within a band.
struct Arcs {
    /// Samples at which pieces may meet.
    candidates: Vec<usize>,
    /// Arcs by the candidate at which they start.
    from: Vec<Vec<Arc>>,
    /// How wide the cells of angles are at each candidate, and the angle they are around: that at which the longest piece
    /// leaves, for directions of samples may be known to few digits.
    cell: Vec<(f64, f64)>,
    /// The steps from candidate to candidate to the end, or once around.
    count: usize,
    /// The number of samples of a closed run.
    around: Option<usize>,
    /// How much narrower cells are at an end at which a chain arrives at a given angle.
    exactness: f64,
}

/// The pieces between two samples.
struct Arc {
    /// Number of candidates from its start to its end.
    on: usize,
    /// φ and ψ.
    angles: [f64; 2],
    /// Half sweeps from and to.
    lo: f64,
    hi: f64,
}

/// Cells of angles on either side of the curve's direction.
const CELLS: i32 = 24;

/// Width of the cells in the middle, as a multiple of the tolerance over the length of the longest piece: the angle at
/// its ends is some ten times that.
const CELL: f64 = 0.8;

/// Number of cells of equal width, beyond which they grow: where a line changes into a curve, and between samples that
/// are far apart, the direction of the samples is known to few digits.
const EVEN: f64 = 5.0;

impl Arcs {
    /// The arcs of a run between candidates within a band of this half width.
    fn new(run: &Run, tested: &Tested, candidates: Vec<usize>, limits: Limits) -> Self {
        /// Number of successive unreachable ends after which further ends are not tried.
        const MISSES: usize = 3;
        let mut arcs = Self {
            count: if run.is_closed {
                candidates.len()
            } else {
                candidates.len() - 1
            },
            around: run.is_closed.then_some(run.points.len()),
            exactness: limits.exactness,
            candidates,
            from: Vec::new(),
            cell: Vec::new(),
        };
        for i in 0..arcs.count {
            let most = if run.is_closed {
                arcs.count - 1
            } else {
                arcs.count - i
            };
            let from = arcs.sample(i);
            let mut of_this: Vec<Arc> = Vec::new();
            let mut misses = 0;
            for on in 1..=most {
                let to = arcs.sample(i + on);
                match allowed(run, tested, from, to, limits.width) {
                    Some((lo, hi)) => {
                        misses = 0;
                        of_this.push(Arc {
                            on,
                            angles: angles(run, from, to),
                            lo: 2.0 * lo.atan(),
                            hi: 2.0 * hi.atan(),
                        });
                    }
                    None => misses += 1,
                }
                // Points that scatter let some ends be reached, and others not.
                if misses > MISSES + on / 8 {
                    break;
                }
            }
            let longest = arcs.sample(i + of_this.last().map_or(1, |a| a.on));
            let length = run
                .joint(from)
                .distance(run.joint(longest))
                .max(f64::MIN_POSITIVE);
            let leaving = of_this
                .last()
                .map_or(0.0, |a| a.angles[0] - f64::midpoint(a.lo, a.hi));
            arcs.cell.push((CELL * limits.width / length, leaving));
            arcs.from.push(of_this);
        }
        // The end of an open run has no piece of its own.
        arcs.cell
            .push(arcs.cell.last().map_or((1.0, 0.0), |c| (c.0, 0.0)));
        arcs
    }

    /// The sample of a candidate, counted on around a closed run.
    fn sample(&self, candidate: usize) -> usize {
        match self.around {
            Some(n) => {
                let count = self.candidates.len();
                self.candidates[candidate % count] + candidate / count * n
            }
            None => self.candidates[candidate],
        }
    }

    fn of(&self, candidate: usize) -> (f64, f64) {
        match self.around {
            Some(_) => self.cell[candidate % self.count],
            None => self.cell[candidate],
        }
    }

    /// The cell of an angle at a candidate; none of one that is far off.
    fn cell(&self, candidate: usize, delta: f64) -> Option<i32> {
        let (width, around) = self.of(candidate);
        Self::cell_of(delta, width, around)
    }

    /// The cell of an angle at an end that is to be arrived at at another.
    fn cell_at_end(&self, candidate: usize, delta: f64, arriving: f64) -> Option<i32> {
        Self::cell_of(delta, self.of(candidate).0 / self.exactness, arriving)
    }

    fn cell_of(delta: f64, width: f64, around: f64) -> Option<i32> {
        let even = (delta - around) / (EVEN * width);
        let cell = (EVEN * even / (1.0 + even.abs() / EVEN)).round();
        (cell.abs() <= f64::from(CELLS)).then_some(cell as i32)
    }

    /// The angle in the middle of a cell.
    fn angle(&self, candidate: usize, cell: i32) -> f64 {
        let (width, around) = self.of(candidate);
        let cell = f64::from(cell) / EVEN;
        around + EVEN * cell / (1.0 - cell.abs() / EVEN) * width
    }

    fn from(&self, candidate: usize) -> &[Arc] {
        &self.from[candidate % self.count]
    }
}

/// The angle from the curve's direction at one sample to the chord to another, and that from the chord to the curve's
/// direction there.
fn angles(run: &Run, from: usize, to: usize) -> [f64; 2] {
    let chord = run.joint(to) - run.joint(from);
    let [start, end] = [from, to].map(|i| run.normal(i).right());
    [
        start.cross(chord).atan2(start.dot(chord)),
        chord.cross(end).atan2(chord.dot(end)),
    ]
}

/// Best path found into a cell.
#[derive(Debug, Clone, Copy)]
struct State {
    pieces: u32,
    /// Sum of the squared distances of the pieces from the middle of the allowed range.
    cost: f64,
    /// The angle to the curve.
    delta: f64,
    /// The sample, as steps back, and the cell that it was reached from, and half the sweep.
    back: u32,
    cell: i32,
    half: f64,
}

/// Number of candidates in one division: candidates farther ahead do not influence which pieces are best here.
const WINDOW: usize = 8192;

/// A division while it is made.
struct Path {
    /// Indices of the candidates.
    joints: Vec<usize>,
    /// Half of each sweep.
    halves: Vec<f64>,
    /// The angles to the curve at the joints.
    deltas: Vec<f64>,
}

impl Path {
    fn division(self, arcs: &Arcs) -> Division {
        Division {
            joints: self.joints.iter().map(|&j| arcs.sample(j)).collect(),
            bulges: self.halves.iter().map(|h| (h / 2.0).tan()).collect(),
        }
    }
}

/// The fewest tangent pieces over some candidates from one on, leaving it at an angle to the curve, or at any, and arriving at
/// the last at an angle, or at any.
fn fewest(
    arcs: &Arcs,
    start: usize,
    samples: usize,
    leaving: Option<f64>,
    arriving: Option<f64>,
) -> Option<Path> {
    let mut path = Path {
        joints: vec![start],
        halves: Vec::new(),
        deltas: vec![leaving.unwrap_or(0.0)],
    };
    let (mut at, mut leaving) = (start, leaving);
    loop {
        let left = start + samples - at;
        if left <= WINDOW {
            let rest = in_window(arcs, at, left, leaving, arriving)?;
            path.join(&rest, rest.halves.len());
            return Some(path);
        }
        let rest = in_window(arcs, at, WINDOW, leaving, None)?;
        let kept = (rest.joints.iter())
            .position(|&j| j > at + WINDOW * 3 / 4)
            .unwrap_or(1)
            .clamp(1, rest.halves.len());
        path.join(&rest, kept);
        at = path.joints[path.joints.len() - 1];
        leaving = path.deltas.last().copied();
    }
}

impl Path {
    /// Appends the first `pieces` pieces of another path.
    fn join(&mut self, rest: &Self, pieces: usize) {
        self.deltas[self.joints.len() - 1] = rest.deltas[0];
        self.joints.extend(&rest.joints[1..=pieces]);
        self.halves.extend(&rest.halves[..pieces]);
        self.deltas.extend(&rest.deltas[1..=pieces]);
    }
}

fn in_window(
    arcs: &Arcs,
    start: usize,
    n: usize,
    leaving: Option<f64>,
    arriving: Option<f64>,
) -> Option<Path> {
    let width = (2 * CELLS + 1) as usize;
    let mut states: Vec<Option<State>> = vec![None; (n + 1) * width];
    let cell_of = |step: usize, delta: f64| match arriving {
        Some(arriving) if step == n => arcs.cell_at_end(start + step, delta, arriving),
        _ => arcs.cell(start + step, delta),
    };
    let index = |step: usize, cell: i32| step * width + (cell + CELLS) as usize;
    let seed = |delta: f64| State {
        pieces: 0,
        cost: 0.0,
        delta,
        back: 0,
        cell: 0,
        half: 0.0,
    };
    match leaving {
        Some(delta) => {
            let cell = cell_of(0, delta)?;
            states[index(0, cell)] = Some(seed(delta));
        }
        None => {
            for cell in -CELLS..=CELLS {
                let delta = arcs.angle(start, cell);
                states[index(0, cell)] = Some(seed(delta));
            }
        }
    }
    for step in 0..n {
        for cell in -CELLS..=CELLS {
            let Some(state) = states[index(step, cell)] else {
                continue;
            };
            for arc in arcs.from(start + step) {
                let to = step + arc.on;
                if to > n {
                    break;
                }
                let half = arc.angles[0] - state.delta;
                if half < arc.lo || half > arc.hi {
                    continue;
                }
                let delta = half - arc.angles[1];
                // A single arc has no joint that could be moved to meet both directions.
                let is_single = to == n && state.pieces == 0 && leaving.is_some();
                if is_single && arriving.is_some_and(|a| (delta - a).abs() > SMOOTH) {
                    continue;
                }
                let Some(next) = cell_of(to, delta) else {
                    continue;
                };
                let off = (2.0 * half - arc.lo - arc.hi) / (arc.hi - arc.lo).max(f64::MIN_POSITIVE);
                let pieces = state.pieces + 1;
                let cost = state.cost + off * off;
                let place = &mut states[index(to, next)];
                let is_better = place.is_none_or(|p| (pieces, cost) < (p.pieces, p.cost));
                if is_better {
                    *place = Some(State {
                        pieces,
                        cost,
                        delta,
                        back: arc.on as u32,
                        cell,
                        half,
                    });
                }
            }
        }
    }
    let ends = match arriving {
        // The remaining angle is taken up by small corrections.
        Some(_) => -1..=1,
        None => -CELLS..=CELLS,
    };
    let end = (ends.filter(|&c| states[index(n, c)].is_some_and(|s| s.pieces > 0))).min_by(
        |&a, &b| {
            let of = |c: i32| states[index(n, c)].map_or((u32::MAX, 0.0), |s| (s.pieces, s.cost));
            let (a, b) = (of(a), of(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        },
    )?;
    let (mut step, mut cell) = (n, end);
    let mut path = Path {
        joints: Vec::new(),
        halves: Vec::new(),
        deltas: Vec::new(),
    };
    while let Some(state) = states[index(step, cell)] {
        path.joints.push(start + step);
        path.deltas.push(state.delta);
        if state.pieces == 0 {
            break;
        }
        path.halves.push(state.half);
        step -= state.back as usize;
        cell = state.cell;
    }
    path.joints.reverse();
    path.halves.reverse();
    path.deltas.reverse();
    Some(path)
}

/// Samples of a run and of a piece at which others may begin, at least.
const PER_RUN: usize = 64;
const PER_PIECE: usize = 16;

/// As above, for a run through measured points, which may change from a line into an arc at any of them.
const PER_PROFILE: usize = 400;
const PER_PIECE_OF_PROFILE: usize = 32;

/// Limits of a division.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Half the width of the band.
    pub(super) width: f64,
    /// Factor by which a chain comes closer than a cell's width to the required angle at its end.
    pub(super) exactness: f64,
}

/// Best division of a run within limits, tangent except for small remaining corrections. `pieces` is about the expected
/// number of pieces.
///
/// If there are many samples, joints are first sought at some of them, and then again with more samples near the joints
/// found, down to every one: where a line changes into an arc the exact sample matters.
pub(super) fn divide(run: &Run, pieces: usize, limits: Limits) -> Option<Division> {
    /// Factor by which the samples near joints become finer, each time.
    const FINER: usize = 16;
    let n = run.points.len();
    let (least, per_piece) = match run.is_measured {
        true => (PER_PROFILE, PER_PIECE_OF_PROFILE),
        false => (PER_RUN, PER_PIECE),
    };
    let tested = Tested::new(run, n / (per_piece * pieces));
    let mut stride = (n / least.max(per_piece * pieces)).max(1);
    let grid: Vec<usize> = (0..n).step_by(stride).chain([n - 1]).collect();
    let mut candidates = grid.clone();
    loop {
        candidates.sort_unstable();
        candidates.dedup();
        let division = over(run, &tested, candidates, limits)?;
        if stride == 1 {
            return Some(division);
        }
        let finer = (stride / FINER).max(1);
        candidates = grid.clone();
        for joint in division.joints {
            let near = (joint + n - 2 * stride..=joint + n + 2 * stride).step_by(finer);
            candidates.extend(near.filter_map(|i| match run.is_closed {
                true => Some(i % n),
                false => i.checked_sub(n).filter(|&i| i < n),
            }));
        }
        stride = finer;
    }
}

fn over(run: &Run, tested: &Tested, candidates: Vec<usize>, limits: Limits) -> Option<Division> {
    let arcs = Arcs::new(run, tested, candidates, limits);
    if run.is_closed {
        return closed(&arcs);
    }
    let fixed = |end: usize, at: usize| match run.ends[end] {
        RunEnd::Free => None,
        RunEnd::Along(direction) => {
            let own = run.normal(at).right();
            Some(own.cross(direction).atan2(own.dot(direction)))
        }
    };
    let ends = (fixed(0, 0), fixed(1, run.points.len() - 1));
    fewest(&arcs, 0, arcs.count, ends.0, ends.1).map(|path| path.division(&arcs))
}

/// Division of a closed run: a chain that goes around twice is cut at the joints of its second turn, at the angles that
/// it has there: by then it does not depend on its start any more.
fn closed(arcs: &Arcs) -> Option<Division> {
    /// Number of joints that are tried.
    const TRIED: usize = 8;
    let n = arcs.count;
    let around = fewest(arcs, 0, 2 * n, None, None)?;
    let mut best: Option<Path> = None;
    let middle = (around.joints.iter().zip(&around.deltas))
        .filter(|(joint, _)| **joint > n / 2)
        .take(TRIED);
    for (&joint, &delta) in middle {
        let start = joint % n;
        let tried = fewest(arcs, start, n, Some(delta), Some(delta));
        let is_better = |p: &Path| {
            best.as_ref()
                .is_none_or(|b| p.halves.len() < b.halves.len())
        };
        if let Some(tried) = tried.filter(is_better) {
            let is_enough = 2 * tried.halves.len() <= around.halves.len();
            best = Some(tried);
            if is_enough {
                break;
            }
        }
    }
    best.map(|path| path.division(arcs))
}

/// Approximate number of pieces: those of a chain that need not be tangent, each as long as possible, found by doubling
/// steps and then by bisection.
pub(super) fn roughly(run: &Run) -> usize {
    let tested = Tested::new(run, 1);
    let end = run.len() - 1;
    let (mut at, mut pieces) = (0, 0);
    while at < end {
        let most = if run.is_closed {
            end.min(at + run.len() - 2)
        } else {
            end
        };
        let test = |to: usize| allowed(run, &tested, at, to, run.band.width()).is_some();
        let mut reached = at + 1;
        let mut step = 1;
        while reached < most && test((reached + step).min(most)) {
            reached = (reached + step).min(most);
            step *= 2;
        }
        let mut beyond = (reached + step).min(most);
        while beyond > reached + 1 {
            let middle = reached.midpoint(beyond);
            if test(middle) {
                reached = middle;
            } else {
                beyond = middle;
            }
        }
        at = reached;
        pieces += 1;
    }
    pieces
}

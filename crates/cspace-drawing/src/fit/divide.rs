//! The fewest pieces between samples that are tangent to each other.
//!
//! A piece from sample i to sample j that leaves i at the angle δ to the curve has half the sweep a = φ − δ, where φ is the
//! angle from the curve's direction at i to the chord; it arrives at j at the angle a − ψ, where ψ is that from the chord to
//! the curve's direction at j. So a chain of tangent pieces is a path through states (sample, δ), and dynamic programming
//! finds the one of fewest pieces. Angles are told apart by cells as wide as a small part of the tolerance makes them; of the
//! ways into a cell the one is kept that stays farther from the edges of the band.

use super::bulges::allowed;
use super::run::{Run, RunEnd};

/// A run in pieces, each a line or an arc.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Division {
    /// The samples at which pieces meet, ends included; the last of a closed run is the first, a turn on.
    pub(super) joints: Vec<usize>,
    /// The bulge of each piece.
    pub(super) bulges: Vec<f64>,
}

/// All pieces that pass the samples between within a band.
pub(super) struct Arcs {
    /// By the sample they start at.
    from: Vec<Vec<Arc>>,
    /// How wide the cells of angles are at each sample.
    cell: Vec<f64>,
    /// The samples before the end, or once around.
    count: usize,
    is_closed: bool,
}

/// The pieces between two samples.
struct Arc {
    /// How many samples on it ends.
    on: usize,
    /// φ and ψ.
    angles: [f64; 2],
    /// Half sweeps from and to.
    lo: f64,
    hi: f64,
}

/// Cells of angles on either side of the curve's direction.
const CELLS: i32 = 20;

/// How wide a cell is, by the tolerance over the length of the longest piece: the angle at its ends is some ten times that.
const CELL: f64 = 0.9;

impl Arcs {
    /// The arcs of a run within a band of this half width.
    pub(super) fn new(run: &Run, width: f64) -> Self {
        /// After so many ends that no arc reaches the next will not be reached either.
        const MISSES: usize = 3;
        let count = run.len() - 1;
        let mut from = Vec::with_capacity(count);
        let mut cell = Vec::with_capacity(count);
        for i in 0..count {
            let most = if run.is_closed { count - 1 } else { count - i };
            let mut arcs: Vec<Arc> = Vec::new();
            let mut misses = 0;
            for on in 1..=most {
                match allowed(run, i, i + on, width) {
                    Some((lo, hi)) => {
                        misses = 0;
                        arcs.push(Arc {
                            on,
                            angles: angles(run, i, i + on),
                            lo: 2.0 * lo.atan(),
                            hi: 2.0 * hi.atan(),
                        });
                    }
                    None => misses += 1,
                }
                if misses > MISSES {
                    break;
                }
            }
            let longest = arcs.last().map_or(1, |a| a.on);
            let length = run.joint(i).distance(run.joint(i + longest)).max(f64::MIN_POSITIVE);
            cell.push(CELL * width / length);
            from.push(arcs);
        }
        // The end of an open run has no piece of its own.
        cell.push(cell.last().copied().unwrap_or(1.0));
        Self {
            from,
            cell,
            count,
            is_closed: run.is_closed,
        }
    }

    fn cell(&self, sample: usize) -> f64 {
        if self.is_closed {
            self.cell[sample % self.count]
        } else {
            self.cell[sample]
        }
    }

    /// How many samples the longest piece from a sample spans.
    pub(super) fn longest(&self, sample: usize) -> usize {
        self.from[sample % self.count].last().map_or(1, |a| a.on)
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

/// The best way found into a cell.
#[derive(Debug, Clone, Copy)]
struct State {
    pieces: u32,
    /// The sum of the squares of how far the pieces are from the middle of what is allowed.
    cost: f64,
    /// The angle to the curve.
    delta: f64,
    /// The sample, as steps back, and the cell that it was reached from, and half the sweep.
    back: u32,
    cell: i32,
    half: f64,
}

/// The fewest tangent pieces from a sample on, leaving it at an angle to the curve, or at any. They end at the last sample,
/// or around at the first, where they arrive at an angle to the curve, or at any.
pub(super) fn fewest(
    arcs: &Arcs,
    start: usize,
    leaving: Option<f64>,
    arriving: Option<f64>,
) -> Option<Division> {
    let width = (2 * CELLS + 1) as usize;
    let n = arcs.count;
    let mut states: Vec<Option<State>> = vec![None; (n + 1) * width];
    let cell_of = |step: usize, delta: f64| {
        let cell = (delta / arcs.cell(start + step)).round();
        (cell.abs() <= f64::from(CELLS)).then_some(cell as i32)
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
            let cell = cell_of(0, delta).unwrap_or(0);
            states[index(0, cell)] = Some(seed(delta));
        }
        None => {
            for cell in -CELLS..=CELLS {
                states[index(0, cell)] = Some(seed(f64::from(cell) * arcs.cell(start)));
            }
        }
    }
    for step in 0..n {
        for cell in -CELLS..=CELLS {
            let Some(state) = states[index(step, cell)] else {
                continue;
            };
            for arc in &arcs.from[(start + step) % n] {
                let to = step + arc.on;
                if to > n {
                    break;
                }
                let half = arc.angles[0] - state.delta;
                if half < arc.lo || half > arc.hi {
                    continue;
                }
                let delta = half - arc.angles[1];
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
        // What is left of the angle is taken up by small changes.
        Some(delta) => {
            let cell = cell_of(n, delta)?;
            (cell - 1).max(-CELLS)..=(cell + 1).min(CELLS)
        }
        None => -CELLS..=CELLS,
    };
    let end = (ends.filter(|&c| states[index(n, c)].is_some_and(|s| s.pieces > 0)))
        .min_by(|&a, &b| {
            let of = |c: i32| states[index(n, c)].map_or((u32::MAX, 0.0), |s| (s.pieces, s.cost));
            let (a, b) = (of(a), of(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        })?;
    let (mut step, mut cell) = (n, end);
    let (mut joints, mut bulges) = (vec![start + n], Vec::new());
    while let Some(state) = states[index(step, cell)].filter(|s| s.pieces > 0) {
        step -= state.back as usize;
        cell = state.cell;
        joints.push(start + step);
        bulges.push((state.half / 2.0).tan());
    }
    joints.reverse();
    bulges.reverse();
    Some(Division { joints, bulges })
}

/// The best division of a run within a band of this half width, tangent but for what small changes will mend.
pub(super) fn divide(run: &Run, width: f64) -> Option<Division> {
    let arcs = Arcs::new(run, width);
    if !run.is_closed {
        let fixed = |end: usize, at: usize| match run.ends[end] {
            RunEnd::Free => None,
            RunEnd::Along(direction) => {
                let own = run.normal(at).right();
                Some(own.cross(direction).atan2(own.dot(direction)))
            }
        };
        return fewest(&arcs, 0, fixed(0, 0), fixed(1, run.points.len() - 1));
    }
    // Where a closed run begins, and at which angle, is open: some of each are tried.
    let first = arcs.longest(0);
    let pieces = arcs.count / first.max(1);
    // Of many pieces one more or less does not matter.
    let (starts, leaving): (usize, i32) = if pieces > 60 { (1, 1) } else { (4, 3) };
    let mut best: Option<Division> = None;
    for k in 0..starts {
        let start = k * first / starts;
        for cell in -leaving..=leaving {
            let delta = f64::from(cell * CELLS / (leaving + 1)) * arcs.cell(start);
            let tried = fewest(&arcs, start, Some(delta), Some(delta));
            let is_better = |d: &Division| {
                best.as_ref().is_none_or(|b| d.bulges.len() < b.bulges.len())
            };
            if let Some(tried) = tried.filter(is_better) {
                best = Some(tried);
            }
        }
    }
    best
}

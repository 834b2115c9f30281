//! Contracts structures of the perturbed parts that last less than the narrowest band, which are not those of the drawing.
//!
//! Where the drawing has one critical orientation, the perturbed parts have a run of them, nearer to each other than [`NARROWEST_BAND`],
//! with cells between that do not exist in the drawing. All clusters of a run are merged. Cells that begin and end in it are removed; cells
//! that end in it are continued by cells that begin in it where both lie at one place of one curve and are connected by removed cells.
//! Shells are unchanged, so that regions keep their connections.

use std::collections::BTreeMap;

use crate::boxes::Boxes;
use crate::contact::{Curve, Geometry};
use crate::feature::tolerance::NARROWEST_BAND;
use crate::geometry::Vector;
use crate::parallel;
use crate::part::Bounds;
use crate::union_find::UnionFind;

use crate::general::cells::cell::{Cell, SideContact, VerticalContact};
use crate::general::cells::extent::{CellExtents, Extent, Side};
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::verdict::shells::Shells;

/// Minimum number of runs per thread.
const RUNS: usize = 16;

/// Distance of curves below which they are one where a run is contracted (length).
const ONE_CURVE: f64 = 1e-9;

/// Minimum length of the piece of curve that two cells share where a run is contracted; for short cells, a quarter of the shorter one:
/// places move during the run.
const SHARED: f64 = 1e-8;

/// Minimum length in any case: pieces that growth and perturbation leave within the narrowest band are shorter.
const SHORTEST: f64 = 4.0 * NARROWEST_BAND;

/// Accuracy to which ends are measured (length): well below the length that two cells must share.
const MEASURED: f64 = SHORTEST / 64.0;

/// Distance within which the ends of cells that share a piece of a curve must come to each other (length): far above [`ONE_CURVE`].
const NEAR: f64 = 1e-6;

/// Number of ends up to which they are compared one by one, which is faster than a search by place.
const FEW: usize = 8;

/// Placeholder for the number of a run.
const NONE: u32 = u32::MAX;

/// Contracts clusters that are nearer to each other than the narrowest band; only clusters at which free cells begin or end count.
pub(crate) fn contract(
    geometry: &Geometry,
    branches: &[Branch],
    clusters: &Clusters,
    cells: &mut [Cell],
    shells: &mut Shells,
) -> Option<Clusters> {
    let runs = Runs::new(clusters, cells, &shells.free);
    if runs.all.is_empty() {
        return None;
    }
    let contraction = Contraction {
        geometry,
        branches,
        clusters,
        cells,
        runs: &runs,
    };
    let continued = contraction.continued(shells);
    let (contracted, moved) = clusters.contracted(&runs.all);
    let one_run = |c: &Cell| runs.of(c.from) != NONE && runs.of(c.from) == runs.of(c.to);
    for (c, free) in cells.iter().zip(&mut shells.free) {
        *free &= !one_run(c);
    }
    shells.vertical.retain(|v| runs.of(v.at) == NONE);
    shells.vertical.extend(continued);
    let index = |old: u32| moved[old as usize];
    for v in &mut shells.vertical {
        v.at = index(v.at);
    }
    for c in cells.iter_mut() {
        (c.from, c.to) = (index(c.from), index(c.to));
    }
    for s in &mut shells.side {
        (s.from, s.to) = (index(s.from), index(s.to));
    }
    shells.side.retain(|s| s.from < s.to);
    Some(contracted)
}

/// Runs of clusters to be merged.
struct Runs {
    /// First and last cluster of each run.
    all: Vec<(u32, u32)>,
    number: Vec<u32>,
}

impl Runs {
    fn new(clusters: &Clusters, cells: &[Cell], free: &[bool]) -> Self {
        let count = clusters.len();
        let mut used = vec![false; count];
        for (c, _) in cells.iter().zip(free).filter(|(_, free)| **free) {
            used[c.from as usize] = true;
            used[c.to as usize] = true;
        }
        // The ends of the window, or of a period, are kept.
        let inner = (1..count.saturating_sub(1) as u32).filter(|&i| used[i as usize]);
        let inner: Vec<u32> = inner.collect();
        let near = |a: &u32, b: &u32| clusters.duration(*a, *b) < NARROWEST_BAND;
        let all: Vec<(u32, u32)> = (inner.chunk_by(near))
            .filter(|run| run.len() > 1)
            .map(|run| (run[0], run[run.len() - 1]))
            .collect();
        let mut number = vec![NONE; count];
        for (n, &(first, last)) in (0..).zip(&all) {
            number[first as usize..=last as usize].fill(n);
        }
        Self { all, number }
    }

    fn of(&self, cluster: u32) -> u32 {
        self.number[cluster as usize]
    }
}

struct Contraction<'a> {
    geometry: &'a Geometry,
    branches: &'a [Branch],
    clusters: &'a Clusters,
    cells: &'a [Cell],
    runs: &'a Runs,
}

/// Cells that end or begin in a run.
#[derive(Default)]
struct Touched {
    ending: Vec<u32>,
    beginning: Vec<u32>,
    /// Cells that are connected within the run.
    joined: Vec<(u32, u32)>,
}

impl Contraction<'_> {
    /// The contacts across all runs.
    fn continued(&self, shells: &Shells) -> Vec<VerticalContact> {
        let mut all: Vec<Touched> = Vec::new();
        all.resize_with(self.runs.all.len(), Touched::default);
        for (i, c) in (0u32..).zip(self.cells) {
            let (from, to) = (self.runs.of(c.from), self.runs.of(c.to));
            if !shells.free[i as usize] || from == to {
                continue;
            }
            if to != NONE {
                all[to as usize].ending.push(i);
            }
            if from != NONE {
                all[from as usize].beginning.push(i);
            }
        }
        for v in &shells.vertical {
            let run = self.runs.of(v.at);
            if run != NONE {
                all[run as usize].joined.push((v.lower, v.upper));
            }
        }
        for s in &shells.side {
            for run in self.runs_within(s).into_iter().filter(|&run| run != NONE) {
                all[run as usize].joined.push((s.before, s.after));
            }
        }
        let all = parallel::chunks(&all, RUNS, |first, touched| {
            let runs = (first as u32..).zip(touched);
            runs.flat_map(|(run, touched)| self.across(run, touched))
                .collect::<Vec<_>>()
        });
        all.into_iter().flatten().collect()
    }

    /// The runs in which two cells follow each other for a while, and one of them begins or ends: each once, and [`NONE`] for missing ones.
    fn runs_within(&self, s: &SideContact) -> [u32; 4] {
        let [a, b] = [s.before, s.after].map(|c| &self.cells[c as usize]);
        let mut runs = [a.from, a.to, b.from, b.to].map(|at| self.runs.of(at));
        for k in 0..runs.len() {
            let lasts = |run: u32| {
                let (first, last) = self.runs.all[run as usize];
                s.from.max(first) < s.to.min(last)
            };
            if runs[k] != NONE && (runs[..k].contains(&runs[k]) || !lasts(runs[k])) {
                runs[k] = NONE;
            }
        }
        runs
    }

    fn across(&self, run: u32, touched: &Touched) -> Vec<VerticalContact> {
        let mut out = Vec::new();
        let mut local: Vec<u32> = (touched.joined.iter())
            .flat_map(|&(a, b)| [a, b])
            .chain(touched.ending.iter().copied())
            .chain(touched.beginning.iter().copied())
            .collect();
        local.sort_unstable();
        local.dedup();
        let index = |cell: u32| local.partition_point(|&c| c < cell) as u32;
        let mut sets = UnionFind::new(local.len());
        for &(a, b) in &touched.joined {
            sets.union(index(a), index(b));
        }
        let mut beginning: Vec<(u32, u32)> = (touched.beginning.iter())
            .map(|&c| (sets.find(index(c)), c))
            .collect();
        beginning.sort_unstable();
        let mut ends = Ends::default();
        let mut measured: BTreeMap<u32, Above> = BTreeMap::new();
        for &c in &touched.ending {
            let set = sets.find(index(c));
            let first = beginning.partition_point(|b| b.0 < set);
            let cells = (beginning[first..].iter())
                .take_while(|b| b.0 == set)
                .map(|b| b.1);
            if cells.clone().next().is_none() {
                continue;
            }
            let above = measured
                .entry(set)
                .or_insert_with(|| Above::new(self, cells, &mut ends));
            let below = ends.of(self, c, Side::Below);
            let (first, _) = self.runs.all[run as usize];
            out.extend(above.near(self, &below).filter_map(|upper| {
                let (lo, hi) = self.shared(&below, upper)?;
                Some(VerticalContact {
                    lower: c,
                    upper: upper.cell,
                    at: first,
                    lo,
                    hi,
                    certain: true,
                })
            }));
        }
        out
    }

    /// The curve that a cell's end lies on.
    fn curve(&self, end: &End) -> Curve {
        let sheet = self.cells[end.cell as usize].sheet;
        self.geometry.contacts.sheets[sheet as usize]
            .curve(self.clusters.at(end.at), self.clusters.turn(end.at))
    }

    /// A box that contains a cell's end: places on it are no further from its middle than along the curve.
    fn bounds(&self, end: &End) -> Bounds {
        let Extent { lo, hi, .. } = end.extent;
        let middle = self.curve(end).point(0.5 * (lo + hi));
        let reach = 0.5 * (hi - lo).abs() + NEAR;
        let corner = Vector::new(reach, reach);
        Bounds::of(middle + -corner, middle + corner)
    }

    /// The range of places that two ends share, along the curve of the first.
    fn shared(&self, below: &End, above: &End) -> Option<(f64, f64)> {
        let (c, d) = (
            &self.cells[below.cell as usize],
            &self.cells[above.cell as usize],
        );
        let mut other = (above.extent.lo, above.extent.hi);
        if c.sheet != d.sheet {
            let (f, g) = (self.curve(below), self.curve(above));
            let points = [other.0, 0.5 * (other.0 + other.1), other.1].map(|place| g.point(place));
            let on_it =
                |p| f.cycle.distance(p).abs() <= ONE_CURVE && f.normal(p).dot(g.normal(p)) > 0.0;
            if !points.into_iter().all(on_it) {
                return None;
            }
            other = (f.position(points[0]), f.position(points[2]));
        }
        let (lo, hi) = (below.extent.lo.max(other.0), below.extent.hi.min(other.1));
        // Cells of small pockets are themselves short.
        let shorter = (below.extent.hi - below.extent.lo).min(other.1 - other.0);
        (hi - lo > SHARED.min(0.25 * shorter).max(SHORTEST)).then_some((lo, hi))
    }
}

/// The ends of cells that begin in a run and are connected: for a symmetric drawing whose symmetry is not used there may be thousands, and
/// each shares its curve with few.
struct Above {
    ends: Vec<End>,
    /// Tree of their boxes, unless they are few.
    places: Option<Boxes>,
}

impl Above {
    fn new<'a>(
        within: &Contraction<'a>,
        cells: impl Iterator<Item = u32>,
        ends: &mut Ends<'a>,
    ) -> Self {
        let ends: Vec<End> = cells.map(|c| ends.of(within, c, Side::Above)).collect();
        let many = ends.len() > FEW;
        Self {
            places: many.then(|| Boxes::new(ends.iter().map(|e| within.bounds(e)))),
            ends,
        }
    }

    /// Ends that may share a piece of a curve with an end below, in their order.
    fn near(&self, within: &Contraction<'_>, below: &End) -> impl Iterator<Item = &End> {
        let mut near: Vec<u32> = Vec::new();
        match &self.places {
            None => near.extend(0..self.ends.len() as u32),
            Some(places) => {
                let own = within.bounds(below);
                places.any(
                    |b| meet(b, &own),
                    |i| {
                        near.push(i);
                        false
                    },
                );
                near.sort_unstable();
            }
        }
        near.into_iter().map(|i| &self.ends[i as usize])
    }
}

/// Whether two boxes have a place in common.
fn meet(a: &Bounds, b: &Bounds) -> bool {
    a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y
}

/// Ends measured in a run: adjacent cells share bounds, and most are needed again.
#[derive(Default)]
struct Ends<'a> {
    extents: BTreeMap<(u32, u32), CellExtents<'a>>,
    known: BTreeMap<(u32, Side), End>,
}

impl<'a> Ends<'a> {
    fn of(&mut self, within: &Contraction<'a>, cell: u32, side: Side) -> End {
        *self.known.entry((cell, side)).or_insert_with(|| {
            let c = &within.cells[cell as usize];
            let at = if side == Side::Below { c.to } else { c.from };
            let extents = self.extents.entry((c.sheet, at)).or_insert_with(|| {
                let Contraction {
                    geometry,
                    clusters,
                    branches,
                    ..
                } = *within;
                CellExtents::new(geometry, clusters, branches, c.sheet, at)
                    .measured_within(MEASURED)
            });
            End {
                cell,
                at,
                extent: extents.of(c, side),
            }
        })
    }
}

/// The end or beginning of a cell in a run.
#[derive(Clone, Copy)]
struct End {
    cell: u32,
    at: u32,
    extent: Extent,
}

//! Shells: cells that hang together, and whether they bound free space.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::contact::{Geometry, Seam};
use crate::geometry::{Point, Rotation, Vector};
use crate::union_find::UnionFind;

use super::branch::Branch;
use super::candidates::{Candidates, SheetRun};
use super::cells::{Cell, END, SideContact, VerticalContact};
use super::clusters::Clusters;
use super::sweep::{CellExtents, Cells, Extent, Placing};

/// Contacts between cells, and the verdict on each cell.
#[derive(Debug)]
pub(super) struct Shells {
    pub(super) side: Vec<SideContact>,
    pub(super) vertical: Vec<VerticalContact>,
    pub(super) free: Vec<bool>,
    /// For every cell the smallest cell of its shell.
    pub(super) shell: Vec<u32>,
    /// How many configurations were tested for overlap.
    pub(super) tests: usize,
    /// Shells whose bounds and tests told different things; their cells were tested one by one.
    pub(super) conflicts: usize,
}

pub(super) struct ShellFinder<'a> {
    pub(super) geometry: &'a Geometry,
    pub(super) clusters: &'a Clusters,
    pub(super) branches: &'a [Branch],
    pub(super) candidates: &'a Candidates,
}

impl ShellFinder<'_> {
    pub(super) fn find(&self, cells: &Cells) -> Shells {
        let side = self.side_contacts(&cells.cells);
        let mut vertical = cells.vertical.clone();
        self.seams(&cells.cells, &mut vertical);
        let mut sets = UnionFind::new(cells.cells.len());
        for s in &side {
            sets.union(s.before, s.after);
        }
        for v in &vertical {
            sets.union(v.lower, v.upper);
        }
        let shell: Vec<u32> = (0..cells.cells.len() as u32)
            .map(|i| sets.find(i))
            .collect();
        let mut shells = Shells {
            side,
            vertical,
            free: Vec::new(),
            shell,
            tests: 0,
            conflicts: 0,
        };
        self.judge(&cells.cells, &mut shells);
        shells
    }

    /// Cells that follow each other at shared ends and at branches.
    fn side_contacts(&self, cells: &[Cell]) -> Vec<SideContact> {
        let contacts = &self.geometry.contacts;
        let first_cell = |sheet: u32| cells.partition_point(|c| c.sheet < sheet);
        let mut side = Vec::new();
        let mut join = |before: u32, after: u32, branch: u32| {
            let (b, a) = (&cells[before as usize], &cells[after as usize]);
            let (from, to) = (b.from.max(a.from), b.to.min(a.to));
            if from < to {
                side.push(SideContact {
                    before,
                    after,
                    from,
                    to,
                    branch,
                });
            }
        };
        for (i, c) in (0u32..).zip(cells) {
            if c.right != END {
                continue;
            }
            for g in contacts.starting_at(contacts.sheets[c.sheet as usize].end_name) {
                let from = first_cell(g);
                for (j, d) in (from as u32..)
                    .zip(&cells[from..])
                    .take_while(|(_, d)| d.sheet == g)
                {
                    if d.left == END {
                        join(i, j, END);
                    }
                }
            }
        }
        // At a branch the outer piece of the sheet that enters is followed by the outer piece of the other.
        let mut ends: Vec<(u32, u32)> = Vec::new();
        let mut starts: Vec<(u32, u32)> = Vec::new();
        for (i, c) in (0u32..).zip(cells) {
            if c.right != END && self.branches[c.right as usize].enters(c.sheet) {
                ends.push((c.right, i));
            }
            if c.left != END && !self.branches[c.left as usize].enters(c.sheet) {
                starts.push((c.left, i));
            }
        }
        ends.sort_unstable();
        starts.sort_unstable();
        let mut at = 0;
        for &(branch, before) in &ends {
            while at < starts.len() && starts[at].0 < branch {
                at += 1;
            }
            for &(_, after) in starts[at..].iter().take_while(|s| s.0 == branch) {
                join(before, after, branch);
            }
        }
        side
    }

    /// Cells that continue each other where the orientations of their sheets end.
    fn seams(&self, cells: &[Cell], vertical: &mut Vec<VerticalContact>) {
        let sheets = &self.geometry.contacts.sheets;
        // By seam and cluster: cells that end there, cells that begin there.
        let mut groups: BTreeMap<(Seam, u32), (Vec<u32>, Vec<u32>)> = BTreeMap::new();
        for (i, c) in (0u32..).zip(cells) {
            let sheet = &sheets[c.sheet as usize];
            let skip = |s: Seam| matches!(s, Seam::Point | Seam::Window);
            // The two ends of the full turn are one orientation.
            let time = |seam: Seam, t: u32| if matches!(seam, Seam::Wrap(..)) { 0 } else { t };
            if c.at_top && !skip(sheet.top) {
                groups
                    .entry((sheet.top, time(sheet.top, c.to)))
                    .or_default()
                    .0
                    .push(i);
            }
            if c.at_bottom && !skip(sheet.bottom) {
                groups
                    .entry((sheet.bottom, time(sheet.bottom, c.from)))
                    .or_default()
                    .1
                    .push(i);
            }
        }
        for ((seam, _), (ends, starts)) in &groups {
            let lines = !matches!(seam, Seam::Wrap(..) | Seam::Same(..));
            let below: Vec<Extent> = ends
                .iter()
                .map(|&c| self.extent(&cells[c as usize], true, lines))
                .collect();
            let above: Vec<Extent> = starts
                .iter()
                .map(|&c| self.extent(&cells[c as usize], false, lines))
                .collect();
            for (i, b) in below.iter().enumerate() {
                for (j, a) in above.iter().enumerate() {
                    if let Some((lo, hi)) = b.shared_with(a) {
                        let at = cells[ends[i] as usize].to;
                        let middle = if lines {
                            self.line_origin(&cells[ends[i] as usize], true)
                        } else {
                            0.0
                        };
                        vertical.push(VerticalContact {
                            lower: ends[i],
                            upper: starts[j],
                            at,
                            lo: lo - middle,
                            hi: hi - middle,
                        });
                    }
                }
            }
        }
    }

    /// The cell's range at its top or bottom; along the common line of the seam, or along its own curve.
    fn extent(&self, cell: &Cell, top: bool, along_line: bool) -> Extent {
        let at = if top { cell.to } else { cell.from };
        let e =
            CellExtents::new(self.geometry, self.clusters, self.branches, cell.sheet, at).of(cell);
        let origin = if along_line {
            self.line_origin(cell, top)
        } else {
            0.0
        };
        Extent {
            lo: e.lo + origin,
            hi: e.hi + origin,
            ..e
        }
    }

    /// Where the middle of a straight contact curve lies along its line, from the foot of the frame's origin.
    fn line_origin(&self, cell: &Cell, top: bool) -> f64 {
        let at = if top { cell.to } else { cell.from };
        let theta = self.clusters.at(at);
        let turn = Rotation::by(theta);
        let curve = self.geometry.contacts.sheets[cell.sheet as usize].curve(theta, turn);
        let along = self.geometry.contacts.sheets[cell.sheet as usize]
            .normal_at(turn)
            .left();
        along.dot(curve.start.midpoint(curve.end) - Point::ORIGIN)
    }

    /// Decides each shell by what bounds its cells and by an honest test.
    fn judge(&self, cells: &[Cell], shells: &mut Shells) {
        let mut members: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (i, &s) in (0u32..).zip(&shells.shell) {
            members.entry(s).or_default().push(i);
        }
        let verdicts: Vec<(Vec<bool>, usize, bool)> = members
            .values()
            .collect::<Vec<_>>()
            .par_iter()
            .map(|shell| self.judge_shell(cells, shell))
            .collect();
        shells.free = vec![false; cells.len()];
        for (shell, (free, tests, conflict)) in members.values().zip(verdicts) {
            shells.tests += tests;
            shells.conflicts += usize::from(conflict);
            for (&c, f) in shell.iter().zip(free) {
                shells.free[c as usize] = f;
            }
        }
    }

    /// For each cell of a shell whether it bounds free space, how many tests that took, and whether they disagreed.
    fn judge_shell(&self, cells: &[Cell], shell: &[u32]) -> (Vec<bool>, usize, bool) {
        let blocked = shell.iter().any(|&c| cells[c as usize].blocked);
        let undecided = shell.iter().filter(|&&c| !cells[c as usize].blocked);
        let largest = undecided.max_by(|&&a, &&b| {
            self.size(&cells[a as usize])
                .total_cmp(&self.size(&cells[b as usize]))
        });
        let Some(&largest) = largest else {
            return (vec![false; shell.len()], 0, false);
        };
        let free = self.is_free(&cells[largest as usize]);
        if !blocked || !free {
            return (vec![free && !blocked; shell.len()], 1, false);
        }
        let each = shell
            .iter()
            .map(|&c| !cells[c as usize].blocked && self.is_free(&cells[c as usize]))
            .collect();
        (each, 1 + shell.len(), true)
    }

    /// A measure of how far inside its middle is: the smaller of its extent in orientation and along the curve.
    fn size(&self, cell: &Cell) -> f64 {
        let (lo, hi) = self.range(cell, self.middle(cell));
        (hi - lo).min(self.clusters.lo(cell.to) - self.clusters.hi(cell.from))
    }

    fn middle(&self, cell: &Cell) -> f64 {
        self.clusters.between(cell.from, cell.to)
    }

    fn range(&self, cell: &Cell, theta: f64) -> (f64, f64) {
        let placing = Placing::new(self.geometry, cell.sheet, theta);
        let place = |b: u32, end: f64| {
            if b == END {
                end
            } else {
                placing.place(&self.branches[b as usize])
            }
        };
        (
            place(cell.left, -placing.half()),
            place(cell.right, placing.half()),
        )
    }

    /// An honest test beside the middle of a cell: half way to the next contact curve on its free side, the parts
    /// must not overlap.
    fn is_free(&self, cell: &Cell) -> bool {
        /// How far the free side is looked at, in the pair's frame.
        const STEP: f64 = 1.0 / 256.0;
        let theta = self.middle(cell);
        let turn = Rotation::by(theta);
        let (lo, hi) = self.range(cell, theta);
        let sheets = &self.geometry.contacts.sheets;
        let sheet = &sheets[cell.sheet as usize];
        let curve = sheet.curve(theta, turn);
        let p = curve.point(0.5 * (lo + hi));
        let normal: Vector = curve.normal(p);
        let mut reach = if sheet.is_circle() {
            STEP.min(0.5 * sheet.radius.abs())
        } else {
            STEP
        };
        for run in &self.candidates.sheets {
            let SheetRun {
                sheet: other,
                lo,
                hi,
                ..
            } = *run;
            if other != cell.sheet && lo <= theta && theta <= hi {
                let c = sheets[other as usize].curve(theta, turn);
                reach = c.hit(p, normal, reach).unwrap_or(reach);
            }
        }
        !self.geometry.overlaps(p + normal * (0.5 * reach), theta)
    }
}

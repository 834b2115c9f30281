//! Shells: cells that hang together, and whether they bound free space.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::contact::Geometry;
use crate::geometry::{Rotation, Vector};
use crate::union_find::UnionFind;

use super::branch::{Branch, Coincidence};
use super::candidates::Candidates;
use super::cells::{Cell, END, SideContact, VerticalContact};
use super::clusters::Clusters;
use super::levels::Levels;
use super::sweep::{Cells, Placing};

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
    pub(super) coincidences: &'a [Coincidence],
}

impl ShellFinder<'_> {
    pub(super) fn find(&self, cells: &Cells) -> Shells {
        let side = self.side_contacts(&cells.cells);
        let levels = Levels {
            geometry: self.geometry,
            clusters: self.clusters,
            branches: self.branches,
            cells: &cells.cells,
            free: None,
        };
        let mut vertical = cells.vertical.clone();
        levels.connect_wraps(&mut vertical);
        let without_levels = vertical.len();
        let groups = levels.groups(self.coincidences);
        levels.connect(&groups, &mut vertical);
        let mut sets = UnionFind::new(cells.cells.len());
        for s in &side {
            sets.union(s.before, s.after);
        }
        for v in vertical.iter().filter(|v| v.certain) {
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
        // Every top of a free cell is continued over its whole length, unless a curve that faces the other way meets it. So
        // what may be too short to join shells is still the best there is to link patches by.
        shells.vertical.truncate(without_levels);
        let levels = Levels {
            free: Some(&shells.free),
            ..levels
        };
        levels.connect(&groups, &mut shells.vertical);
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
        for &other in self.candidates.around(theta) {
            let s = &sheets[other as usize];
            if other != cell.sheet && s.lo <= theta && theta <= s.hi {
                reach = s.curve(theta, turn).hit(p, normal, reach).unwrap_or(reach);
            }
        }
        !self.geometry.overlaps(p + normal * (0.5 * reach), theta)
    }
}

//! Shells: connected cells, and whether they bound free space.

use crate::contact::{Curve, Cycle, Exact, Geometry, Orientation};
use crate::geometry::{Point, Rotation, Vector};
use crate::grouped::Grouped;
use crate::parallel;
use crate::union_find::UnionFind;

use crate::general::broad::candidates::Candidates;
use crate::general::cells::cell::{Cell, END, SideContact, VerticalContact};
use crate::general::cells::levels::Levels;
use crate::general::cells::sweep::Cells;
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::events::placing::Placing;
use crate::general::events::trace::Coincidence;

/// Contacts between cells, and the class of each cell.
#[derive(Debug, Default)]
pub(crate) struct Shells {
    pub(crate) side: Vec<SideContact>,
    pub(crate) vertical: Vec<VerticalContact>,
    pub(crate) free: Vec<bool>,
    /// For every cell, whether a shell's bounds and tests contradict each other there.
    pub(crate) in_conflict: Vec<bool>,
    /// For every cell, the smallest cell of its shell.
    pub(crate) shell: Vec<u32>,
    /// Number of configurations tested for overlap.
    pub(crate) tests: usize,
    /// Number of shells with cells whose bounds leave them open.
    pub(crate) judged: usize,
    /// Number of pieces of curve that cells share, and of those that are not certainly longer than the errors of their ends.
    pub(crate) overlaps: (u64, u64),
    /// Number of shells whose bounds and tests contradicted each other; their rings, or else their cells, were tested one by one.
    pub(crate) conflicts: usize,
}

/// Number of cells of longest duration from which the one to be tested is chosen.
const TRIED: usize = 8;

/// Duration below which cells are short, radians: critical orientations that are separated only by growth are so near to each other.
const NARROW: f64 = 1e-5;

/// Distance of curves (length) below which f64 does not decide what is free between them.
const TELLING: f64 = 2e-12;

/// A cell whose bounds leave it open, in its shell and its ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Member {
    shell: u32,
    ring: u32,
    cell: u32,
}

/// Classification of a shell.
struct Verdict {
    /// Class of each of its members.
    free: Vec<bool>,
    tests: usize,
    conflict: bool,
}

pub(crate) struct ShellFinder<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) clusters: &'a Clusters,
    pub(crate) branches: &'a [Branch],
    pub(crate) candidates: &'a Candidates,
    pub(crate) coincidences: &'a [Coincidence],
}

impl ShellFinder<'_> {
    /// Finds the shells; the contacts within sheets are moved there from the cells.
    pub(crate) fn find(&self, cells: &mut Cells) -> Shells {
        let mut vertical = core::mem::take(&mut cells.vertical);
        let cells = &*cells;
        let side = self.side_contacts(cells);
        let levels = Levels {
            geometry: self.geometry,
            clusters: self.clusters,
            branches: self.branches,
            cells,
            free: None,
        };
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
        let uncertain = vertical.iter().filter(|v| !v.certain).count();
        let overlaps = (vertical.len() as u64, uncertain as u64);
        let shell: Vec<u32> = (0..cells.cells.len() as u32)
            .map(|i| sets.find(i))
            .collect();
        let mut shells = Shells {
            side,
            vertical,
            free: Vec::new(),
            in_conflict: Vec::new(),
            shell,
            tests: 0,
            judged: 0,
            overlaps,
            conflicts: 0,
        };
        self.judge(&cells.cells, &mut shells);
        // Every top of a free cell is continued over its whole length, unless a curve that faces the other way meets it. So overlaps that
        // may be too short to join shells are still the best available for linking patches.
        shells.vertical.truncate(without_levels);
        let levels = Levels {
            free: Some(&shells.free),
            ..levels
        };
        levels.connect(&groups, &mut shells.vertical);
        shells
    }

    /// Contacts of cells that follow each other at shared ends and at branches, unless both are blocked anyway.
    fn side_contacts(&self, all: &Cells) -> Vec<SideContact> {
        let contacts = &self.geometry.contacts;
        let cells = &all.cells;
        let mut side = Vec::new();
        let mut join = |before: u32, after: u32, branch: u32| {
            let (b, a) = (&cells[before as usize], &cells[after as usize]);
            let (from, to) = (b.from.max(a.from), b.to.min(a.to));
            if from < to && !(b.blocked && a.blocked) {
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
            for g in contacts.starting_at(contacts.sheets[c.sheet as usize].end.name) {
                for (j, d) in all.of(g) {
                    if d.left == END {
                        join(i, j, END);
                    }
                }
            }
        }
        // At a branch, the outer piece of the sheet that enters is followed by the outer piece of the other sheet.
        let starts_outside =
            |c: &Cell| c.left != END && !self.branches[c.left as usize].enters(c.sheet);
        let starting = (0u32..).zip(cells).filter(|(_, c)| starts_outside(c));
        let starting = Grouped::new(self.branches.len(), starting.map(|(i, c)| (c.left, i)));
        for (i, c) in (0u32..).zip(cells) {
            if c.right != END && self.branches[c.right as usize].enters(c.sheet) {
                for &after in starting.of(c.right) {
                    join(i, after, c.right);
                }
            }
        }
        side
    }

    /// Decides each shell by the bounds of its cells and by exact tests.
    ///
    /// Cells that follow each other are on the boundary of free space together or not at all, so in each ring of cells those whose bounds
    /// leave them open are tested separately: rings are few. Blocked cells among those that continue or follow them do not count against
    /// them, because with many curves through one point that may be a false link: a pocket that has no other evidence would be lost.
    fn judge(&self, cells: &[Cell], shells: &mut Shells) {
        let mut rings = UnionFind::new(cells.len());
        for s in &shells.side {
            rings.union(s.before, s.after);
        }
        let ring: Vec<u32> = (0..cells.len() as u32).map(|i| rings.find(i)).collect();
        let mut blocked_shell = vec![false; cells.len()];
        let mut blocked_ring = vec![false; cells.len()];
        let mut members: Vec<Member> = Vec::new();
        for (cell, c) in (0u32..).zip(cells) {
            let (shell, ring) = (shells.shell[cell as usize], ring[cell as usize]);
            if c.blocked {
                blocked_shell[shell as usize] = true;
                blocked_ring[ring as usize] = true;
            } else {
                members.push(Member { shell, ring, cell });
            }
        }
        members.sort_unstable();
        let open: Vec<&[Member]> = members.chunk_by(|a, b| a.shell == b.shell).collect();
        let verdicts = parallel::map(&open, 4, |shell| {
            let blocked = blocked_shell[shell[0].shell as usize];
            self.judge_shell(cells, shell, blocked, &blocked_ring)
        });
        shells.free = vec![false; cells.len()];
        let mut conflict = vec![false; cells.len()];
        for (shell, verdict) in open.iter().zip(verdicts) {
            shells.judged += 1;
            shells.tests += verdict.tests;
            shells.conflicts += usize::from(verdict.conflict);
            conflict[shell[0].shell as usize] = verdict.conflict;
            for (m, free) in shell.iter().zip(verdict.free) {
                shells.free[m.cell as usize] = free;
            }
        }
        shells.in_conflict = Self::contradicting(shells, conflict);
    }

    /// The cells in shells with a conflict that are linked to cells of the other class: the error is there. All cells of a shell that has
    /// none, in which tests alone contradict each other.
    fn contradicting(shells: &Shells, conflict: Vec<bool>) -> Vec<bool> {
        let mut contradicting = vec![false; conflict.len()];
        if !conflict.contains(&true) {
            return contradicting;
        }
        let mut unexplained = conflict;
        let side = shells.side.iter().map(|s| (s.before, s.after));
        let vertical = (shells.vertical.iter().filter(|v| v.certain)).map(|v| (v.lower, v.upper));
        for (a, b) in side.chain(vertical) {
            let shell = shells.shell[a as usize] as usize;
            if shells.free[a as usize] != shells.free[b as usize] {
                unexplained[shell] = false;
                contradicting[a as usize] = true;
                contradicting[b as usize] = true;
            }
        }
        for (cell, &shell) in contradicting.iter_mut().zip(&shells.shell) {
            *cell |= unexplained[shell as usize];
        }
        contradicting
    }

    /// Classifies a shell by the cells whose bounds leave it open. `blocked` states whether the shell has other cells, which are blocked,
    /// and `blocked_ring` which rings have: those are not connected as they should be.
    fn judge_shell(
        &self,
        cells: &[Cell],
        shell: &[Member],
        blocked: bool,
        blocked_ring: &[bool],
    ) -> Verdict {
        // Result of a test for each ring, where f64 decides.
        let lasting = |ring: &[Member]| {
            let duration = |m: &Member| {
                let c = &cells[m.cell as usize];
                self.duration(c.from, c.to)
            };
            ring.iter().map(duration).fold(0.0, f64::max)
        };
        let mut rings: Vec<(&[Member], Option<bool>)> = (shell.chunk_by(|a, b| a.ring == b.ring))
            .map(|ring| {
                let wide = lasting(ring) > NARROW;
                (ring, wide.then(|| self.ring_is_free(cells, ring)).flatten())
            })
            .collect();
        if !blocked && rings.iter().all(|r| r.1.is_none()) {
            // A short pocket is tested where it lasts longest.
            let by_duration = |a: &usize, b: &usize| {
                let [a, b] = [a, b].map(|&i| lasting(rings[i].0));
                b.total_cmp(&a)
            };
            let mut longest: Vec<usize> = (0..rings.len()).collect();
            longest.sort_by(by_duration);
            for i in longest.into_iter().take(TRIED) {
                rings[i].1 = self.ring_is_free(cells, rings[i].0);
                if rings[i].1.is_some() {
                    break;
                }
            }
        }
        let mut tests = rings.iter().filter(|r| r.1.is_some()).count();
        let some_free = rings.iter().any(|r| r.1 == Some(true));
        let some_blocked = blocked || rings.iter().any(|r| r.1 == Some(false));
        let conflict = some_free && some_blocked;
        let mut free = Vec::with_capacity(shell.len());
        for (ring, tested) in rings {
            let apart = tested.is_none() || blocked_ring[ring[0].ring as usize];
            if apart && conflict {
                tests += ring.len();
                let open = |m: &Member| self.is_free(&cells[m.cell as usize]) == Some(true);
                free.extend(ring.iter().map(open));
            } else {
                free.resize(free.len() + ring.len(), tested.unwrap_or(some_free));
            }
        }
        Verdict {
            free,
            tests,
            conflict,
        }
    }

    /// Distance from the end of one cluster to the beginning of another, radians.
    fn duration(&self, from: u32, to: u32) -> f64 {
        self.clusters.duration(from, to)
    }

    /// The largest of the cells of longest duration.
    fn largest(&self, cells: &[Cell], ring: &[Member]) -> u32 {
        let longest = self.longest(cells, ring, |_| 0.0);
        let mut largest = longest[0].1;
        let mut size = f64::NEG_INFINITY;
        for &(duration, c) in &longest {
            if duration <= size {
                break;
            }
            let (lo, hi) = self.range(&cells[c as usize], self.middle(&cells[c as usize]));
            if duration.min(hi - lo) > size {
                (size, largest) = (duration.min(hi - lo), c);
            }
        }
        largest
    }

    /// Some cells of longest duration; among equally long ones those with the largest `rank`.
    fn longest(
        &self,
        cells: &[Cell],
        ring: &[Member],
        rank: impl Fn(&Cell) -> f64,
    ) -> Vec<(f64, u32)> {
        let measured = |m: &Member| {
            let c = &cells[m.cell as usize];
            (self.duration(c.from, c.to), rank(c), m.cell)
        };
        let mut longest: Vec<(f64, f64, u32)> = ring.iter().map(measured).collect();
        let order = |a: &(f64, f64, u32), b: &(f64, f64, u32)| {
            (b.0.total_cmp(&a.0))
                .then(b.1.total_cmp(&a.1))
                .then(a.2.cmp(&b.2))
        };
        if longest.len() > TRIED {
            longest.select_nth_unstable_by(TRIED - 1, order);
            longest.truncate(TRIED);
        }
        longest.sort_unstable_by(order);
        longest.into_iter().map(|l| (l.0, l.2)).collect()
    }

    fn middle(&self, cell: &Cell) -> f64 {
        self.clusters.between(cell.from, cell.to)
    }

    fn range(&self, cell: &Cell, theta: f64) -> (f64, f64) {
        let placing = Placing::new(self.geometry, cell.sheet, Orientation::by(theta));
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

    /// The point of a cell at a share of its length, in the middle of its duration.
    ///
    /// Curves cross at small angles near the orientation at which they coincide: there places are found in double-double.
    fn point(&self, cell: &Cell, share: f64, curve: &Curve) -> Point {
        if self.duration(cell.from, cell.to) > NARROW {
            let (lo, hi) = self.range(cell, self.middle(cell));
            return curve.point(lo + share * (hi - lo));
        }
        let (placing, place) = self.exact_place(cell, share);
        placing.point(place)
    }

    /// Placing of the curve, and the place as in [`point`](Self::point), in double-double.
    fn exact_place(&self, cell: &Cell, share: f64) -> (Placing<'_, Exact>, Exact) {
        let turn = Orientation::by(self.clusters.exact_between(cell.from, cell.to));
        let placing = Placing::new(self.geometry, cell.sheet, turn);
        let (from, to) = placing.ends();
        let place = |b: u32, end: Exact| {
            if b == END {
                end
            } else {
                placing.place(&self.branches[b as usize])
            }
        };
        let (lo, hi) = (place(cell.left, from), place(cell.right, to));
        (placing, lo + (hi - lo) * share)
    }

    /// Tests beside the largest cell of a ring; where f64 decides nothing there, beside others: in a slice all cells last equally long, and
    /// the first may be arcs of 1e-12.
    fn ring_is_free(&self, cells: &[Cell], ring: &[Member]) -> Option<bool> {
        let is_free = |c: u32| self.is_free(&cells[c as usize]);
        let radius = |c: &Cell| {
            let sheet = &self.geometry.contacts.sheets[c.sheet as usize];
            if sheet.is_line() {
                f64::INFINITY
            } else {
                sheet.locus.carrier.radius.abs()
            }
        };
        is_free(self.largest(cells, ring)).or_else(|| {
            let others = self.longest(cells, ring, radius);
            others.iter().find_map(|&(_, c)| is_free(c))
        })
    }

    /// Exact test beside a place of a cell; `None` if curves that face it are so near at all places tried that f64 does not decide.
    fn is_free(&self, cell: &Cell) -> Option<bool> {
        [0.5, 0.27, 0.81]
            .iter()
            .find_map(|&share| self.is_free_at(cell, share))
    }

    /// Exact test beside the place at a share of a cell's length: half way to the next contact curve on its free side, the parts must not
    /// overlap.
    fn is_free_at(&self, cell: &Cell, share: f64) -> Option<bool> {
        /// Largest distance searched on the free side, in the pair's frame.
        const STEP: f64 = 1.0 / 256.0;
        let theta = self.middle(cell);
        let turn = Rotation::by(theta);
        let sheets = &self.geometry.contacts.sheets;
        let sheet = &sheets[cell.sheet as usize];
        let curve = sheet.curve(theta, turn);
        let p = self.point(cell, share, &curve);
        let normal: Vector = curve.normal(p);
        let mut reach = if !sheet.is_line() {
            STEP.min(0.5 * sheet.locus.carrier.radius.abs())
        } else {
            STEP
        };
        for other_sheet in self.candidates.around(theta, p, reach) {
            let s = &sheets[other_sheet as usize];
            let exists = s.lo <= theta && theta <= s.hi;
            if other_sheet == cell.sheet || !exists {
                continue;
            }
            let cycle: Cycle = s.cycle(turn);
            let off = cycle.distance(p).abs();
            if off <= reach {
                let other = s.curve(theta, turn);
                let on_it = other.position(p).abs() <= other.half + TELLING;
                if off < TELLING && on_it {
                    let one_circle = sheet.is_circle() == s.is_circle()
                        && (sheet.locus.carrier.radius - s.locus.carrier.radius).abs() < TELLING;
                    if !one_circle || other.normal(p).dot(normal) < 0.0 {
                        return None;
                    }
                    // The curves lie on each other and face the same way. A curve behind changes nothing, a curve in front blocks.
                    let (placing, place) = self.exact_place(cell, share);
                    if placing.is_covered_by(place, other_sheet, normal) {
                        return Some(false);
                    }
                    continue;
                }
                reach = other.hit(p, normal, reach).unwrap_or(reach);
            }
        }
        (reach > TELLING).then(|| !self.geometry.overlaps(p + normal * (0.5 * reach), theta))
    }
}

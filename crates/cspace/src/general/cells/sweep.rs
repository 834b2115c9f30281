//! Cuts each sheet into cells by a sweep over orientation.

use crate::contact::Geometry;
use crate::grouped::{Grouped, starts};
use crate::parallel;

use crate::general::broad::candidates::SheetRun;
use crate::general::cells::active::Active;
use crate::general::cells::cell::{Cell, VerticalContact};
use crate::general::cells::extent::CellExtents;
use crate::general::cells::gaps::Gaps;
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;

/// Input of a sweep.
pub(crate) struct Sweep<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) clusters: &'a Clusters,
    pub(crate) branches: &'a [Branch],
    pub(crate) on_sheet: &'a Grouped,
    /// Sheets with the clusters at which branches pass each other on them, sorted.
    pub(crate) passings: &'a [(u32, u32)],
    /// Sheets with the clusters at which another sheet lies on the same carrier, sorted: their cells end there.
    pub(crate) splits: &'a [(u32, u32)],
}

/// The clusters listed for a sheet.
fn listed(list: &[(u32, u32)], sheet: u32) -> impl Iterator<Item = u32> + '_ {
    let from = list.partition_point(|p| p.0 < sheet);
    list[from..]
        .iter()
        .take_while(move |p| p.0 == sheet)
        .map(|p| p.1)
}

/// Sheets swept at a time by one thread.
const CHUNK: usize = 32;

/// Buffers that are reused from sheet to sheet.
#[derive(Default)]
struct Work {
    /// Clusters at which cells of the sheet may begin or end.
    times: Vec<u32>,
    /// Clusters at which all cells of the sheet end.
    splits: Vec<u32>,
    /// Cells that have begun and not ended, in order of travel.
    open: Vec<u32>,
    /// Bounds (left and right branch) of the cells of the next interval.
    keys: Vec<(u32, u32)>,
    /// Cells that end where the interval begins.
    closing: Vec<u32>,
    /// For each cell of the sheet, whether it is closed: the branches that bound it block it from both sides.
    shut: Vec<bool>,
    /// New number of each cell after the cells that nothing needs are dropped.
    moved: Vec<u32>,
}

/// Placeholder for a number.
const NONE: u32 = u32::MAX;

/// The cells of all sheets, sorted by sheet, and the contacts by which they continue each other within a sheet; without closed cells that
/// continue nothing.
#[derive(Debug, Default)]
pub(crate) struct Cells {
    pub(crate) cells: Vec<Cell>,
    pub(crate) vertical: Vec<VerticalContact>,
    /// The cells of sheet i are `cells[first[i]..first[i + 1]]`.
    pub(crate) first: Vec<u32>,
    /// Number of cells dropped.
    pub(crate) dropped: u64,
}

impl Cells {
    /// The cells of a sheet, with their indices.
    pub(crate) fn of(&self, sheet: u32) -> impl Iterator<Item = (u32, &Cell)> {
        let (from, to) = (self.first[sheet as usize], self.first[sheet as usize + 1]);
        (from..to).zip(&self.cells[from as usize..to as usize])
    }
}

impl Sweep<'_> {
    pub(crate) fn run(&self, runs: &[SheetRun]) -> Cells {
        let parts = parallel::chunks(runs, CHUNK, |_, runs| {
            let (mut work, mut cells) = (Work::default(), Cells::default());
            for run in runs {
                self.sheet(run, &mut work, &mut cells);
            }
            cells
        });
        let mut all = Cells::default();
        for part in parts {
            let offset = all.cells.len() as u32;
            all.dropped += part.dropped;
            all.cells.extend(part.cells);
            all.vertical
                .extend(part.vertical.into_iter().map(|v| VerticalContact {
                    lower: v.lower + offset,
                    upper: v.upper + offset,
                    ..v
                }));
        }
        let sheets = self.geometry.contacts.sheets.len();
        all.first = starts(sheets, all.cells.iter().map(|c| c.sheet));
        all
    }

    /// Appends the cells of a sheet.
    fn sheet(&self, run: &SheetRun, work: &mut Work, out: &mut Cells) {
        let Work {
            times,
            splits,
            open,
            keys,
            closing,
            shut,
            moved,
        } = work;
        let clusters = self.clusters;
        let (first, last) = (clusters.index(run.lo), clusters.index(run.hi));
        let (first_cell, first_contact) = (out.cells.len(), out.vertical.len());
        shut.clear();
        let mine = self.on_sheet.of(run.sheet);
        times.clear();
        times.extend([first, last]);
        let within = |t: &u32| first < *t && *t < last;
        for &b in mine {
            let b = &self.branches[b as usize];
            times.extend([b.from, b.to].iter().filter(|t| within(t)));
        }
        times.extend(listed(self.passings, run.sheet).filter(within));
        splits.clear();
        splits.extend(listed(self.splits, run.sheet).filter(within));
        times.extend(&*splits);
        times.sort_unstable();
        times.dedup();

        let mut gaps = Gaps::of(self.geometry, run.sheet);
        open.clear();
        let mut active = Active::new(self.branches, mine);
        for w in times.windows(2) {
            let (t0, t1) = (w[0], w[1]);
            gaps.arrange(
                self.geometry,
                self.branches,
                run.sheet,
                active.after(t0),
                clusters.exact_between(t0, t1),
            );
            keys.clear();
            keys.extend((0..=gaps.branches()).map(|gap| gaps.bounds(gap)));
            let split = splits.binary_search(&t0).is_ok();
            let same = |c: u32, key: &(u32, u32)| {
                let cell: &Cell = &out.cells[c as usize];
                !split && (cell.left, cell.right) == *key
            };
            let kept_before = open
                .iter()
                .zip(&*keys)
                .take_while(|(c, k)| same(**c, k))
                .count();
            let room = open.len().min(keys.len()) - kept_before;
            let kept_after = open
                .iter()
                .rev()
                .zip(keys.iter().rev())
                .take(room)
                .take_while(|(c, k)| same(**c, k))
                .count();
            let (kept_to, opened_to) = (open.len() - kept_after, keys.len() - kept_after);
            closing.clear();
            closing.extend(&open[kept_before..kept_to]);
            let new_first = out.cells.len() as u32;
            for (gap, &(left, right)) in (kept_before..).zip(&keys[kept_before..opened_to]) {
                shut.push(gaps.is_shut(gap));
                out.cells.push(Cell {
                    sheet: run.sheet,
                    from: t0,
                    to: t1,
                    left,
                    right,
                    blocked: !gaps.is_open(gap) || (t0 == first && run.lo_blocked),
                    at_bottom: t0 == first && !run.lo_blocked,
                    at_top: false,
                });
            }
            let new = new_first..out.cells.len() as u32;
            if t0 != first && !split {
                self.connect(run.sheet, t0, closing, new.clone(), out);
            }
            open.splice(kept_before..kept_to, new);
            for &c in &*open {
                out.cells[c as usize].to = t1;
            }
        }
        for &c in &*open {
            let cell = &mut out.cells[c as usize];
            cell.blocked |= run.hi_blocked;
            cell.at_top = !run.hi_blocked;
        }
        let on_level = |t: u32| t == first || t == last || splits.binary_search(&t).is_ok();
        drop_shut(out, (first_cell, first_contact), shut, moved, on_level);
    }

    /// Connects cells that end and cells that begin at one cluster, where they overlap.
    fn connect(
        &self,
        sheet: u32,
        at: u32,
        closing: &[u32],
        opening: core::ops::Range<u32>,
        out: &mut Cells,
    ) {
        let Cells {
            cells, vertical, ..
        } = out;
        // Cells that are blocked below and above need no contacts.
        let matters = |i: u32| !cells[i as usize].blocked;
        let any_matters = closing.iter().copied().chain(opening.clone()).any(matters);
        if closing.is_empty() || opening.is_empty() || !any_matters {
            return;
        }
        let mut extents = CellExtents::new(self.geometry, self.clusters, self.branches, sheet, at);
        for &lower in closing {
            for upper in opening.clone() {
                if matters(lower) || matters(upper) {
                    let both = [lower, upper].map(|c| &cells[c as usize]);
                    let shared = extents.shared(both[0], both[1]);
                    vertical.extend(shared.map(|shared| VerticalContact {
                        lower,
                        upper,
                        at,
                        lo: shared.lo,
                        hi: shared.hi,
                        certain: shared.certain,
                    }));
                }
            }
        }
    }
}

/// Drops the closed cells of a sheet, from `first_cell` on, whose contacts begin at `first_contact`.
///
/// Nothing follows a closed cell. Unless it continues another, or begins or ends on a level, where the sheet lies on others, it is not
/// needed: for parts with many teeth most cells are deep in blocked space.
fn drop_shut(
    out: &mut Cells,
    (first_cell, first_contact): (usize, usize),
    shut: &[bool],
    moved: &mut Vec<u32>,
    on_level: impl Fn(u32) -> bool,
) {
    let new = &out.cells[first_cell..];
    moved.clear();
    moved.extend((new.iter().zip(shut)).map(|(c, &shut)| {
        let dropped = shut && !on_level(c.from) && !on_level(c.to);
        if dropped { NONE } else { 0 }
    }));
    let contacts = &mut out.vertical[first_contact..];
    for v in &*contacts {
        moved[v.lower as usize - first_cell] = 0;
        moved[v.upper as usize - first_cell] = 0;
    }
    let mut kept = first_cell;
    for (i, m) in (first_cell..).zip(&mut *moved) {
        if *m != NONE {
            *m = kept as u32;
            out.cells[kept] = out.cells[i];
            kept += 1;
        }
    }
    out.dropped += (out.cells.len() - kept) as u64;
    out.cells.truncate(kept);
    for v in contacts {
        v.lower = moved[v.lower as usize - first_cell];
        v.upper = moved[v.upper as usize - first_cell];
    }
}

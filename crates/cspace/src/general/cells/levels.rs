//! Sheets that share one curve at one orientation, and how free space continues across it.
//!
//! Where intervals of sheets begin and end (two lines parallel, an end normal reached), and where curves of other sheets happen to lie on
//! one carrier (two vertices of the moving part on one line of the fixed part), several sheets lie on top of each other at one orientation.
//! Just below it one of them is outermost at every place of the curve, just above it maybe another: these two continue each other there. A
//! sheet that faces the other way and is passed leaves no room: no cell continues there.

use core::cell::LazyCell;
use core::ops::Deref;
use std::collections::BTreeMap;

use crate::contact::{Curve, Exact, Geometry, Orientation, Seam};
use crate::feature::tolerance::SHORTEST_OVERLAP;
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::union_find::UnionFind;

use crate::general::cells::cell::VerticalContact;
use crate::general::cells::extent::{CellExtents, Extent, Side};
use crate::general::cells::sweep::Cells;
use crate::general::cells::track::{Piece, Place, Track};
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::events::trace::Coincidence;

pub(crate) struct Levels<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) clusters: &'a Clusters,
    pub(crate) branches: &'a [Branch],
    pub(crate) cells: &'a Cells,
    /// Whether each cell is free, once this is known.
    ///
    /// Among all cells on a level it is not certain which are outermost. Once the others are known to be blocked, a free cell can be
    /// continued by a free cell only.
    pub(crate) free: Option<&'a [bool]>,
}

/// A stretch of a level over which two cells continue each other.
struct Stretch {
    lower: u32,
    upper: u32,
    from: f64,
    to: f64,
    /// Whether a part of it is certainly covered by both.
    certain: bool,
}

/// Number of groups of sheets on one level that a thread handles at a time.
const CHUNK: usize = 16;

/// A sheet that lies on a level; sheets on one level have one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Level {
    number: u32,
    /// The cluster of the level.
    at: u32,
    sheet: u32,
}

/// Buffers that are reused from level to level.
#[derive(Default)]
struct Work {
    /// Cells that end on the level, and cells that begin there.
    ending: Vec<u32>,
    beginning: Vec<u32>,
    /// Pieces of the track covered by these cells.
    below: Vec<Piece>,
    above: Vec<Piece>,
    /// The ends of all pieces, in order.
    marks: Vec<f64>,
    /// Stretches of the track with the cells that continue each other there, on the face along the track's normal and on the other face;
    /// adjacent stretches of one pair of cells are merged.
    stretches: [Vec<Stretch>; 2],
}

impl Levels<'_> {
    /// Adds the contacts across all levels.
    pub(crate) fn connect(&self, groups: &[Level], out: &mut Vec<VerticalContact>) {
        let groups: Vec<&[Level]> = groups.chunk_by(|a, b| a.number == b.number).collect();
        let found = parallel::chunks(&groups, CHUNK, |_, groups| {
            let (mut work, mut out) = (Work::default(), Vec::new());
            for group in groups {
                self.connect_group(group, &mut work, &mut out);
            }
            out
        });
        out.extend(found.into_iter().flatten());
    }

    fn counts(&self, cell: u32) -> bool {
        self.free.is_none_or(|free| free[cell as usize])
    }

    /// The curve of a sheet at a cluster.
    fn curve(&self, sheet: u32, at: u32) -> Curve {
        let (theta, turn) = (self.clusters.exact_at(at), self.clusters.turn(at));
        self.geometry.rounded_curve(sheet, theta, turn)
    }

    fn extents(&self, sheet: u32, at: u32) -> CellExtents<'_> {
        CellExtents::new(self.geometry, self.clusters, self.branches, sheet, at)
    }

    /// Sheets that share a curve at a cluster, by the seams at which they begin and end and by coincidence: sorted.
    pub(crate) fn groups(&self, coincidences: &[Coincidence]) -> Vec<Level> {
        let sheets = &self.geometry.contacts.sheets;
        let mut seams: Vec<(Seam, u32, u32)> = Vec::new();
        for c in &self.cells.cells {
            let sheet = &sheets[c.sheet as usize];
            let counts = |s: Seam| !matches!(s, Seam::Point | Seam::Window | Seam::Wrap(..));
            // If both ends change at once, the piece between was dropped: it does not matter which end it was.
            let plain = |s: Seam| match s {
                Seam::Same(a, b, k, _) => Seam::Same(a, b, k, 0),
                other => other,
            };
            if c.at_top && counts(sheet.top) {
                seams.push((plain(sheet.top), c.to, c.sheet));
            }
            if c.at_bottom && counts(sheet.bottom) {
                seams.push((plain(sheet.bottom), c.from, c.sheet));
            }
        }
        seams.sort_unstable();
        seams.dedup();
        let mut nodes: Vec<(u32, u32)> = seams.iter().map(|s| (s.1, s.2)).collect();
        nodes.extend(
            coincidences
                .iter()
                .flat_map(|c| [(c.at, c.first), (c.at, c.second)]),
        );
        nodes.sort_unstable();
        nodes.dedup();
        let node = |at: u32, sheet: u32| nodes.partition_point(|n| *n < (at, sheet)) as u32;
        let mut sets = UnionFind::new(nodes.len());
        for w in seams.windows(2) {
            if (w[0].0, w[0].1) == (w[1].0, w[1].1) {
                sets.union(node(w[0].1, w[0].2), node(w[1].1, w[1].2));
            }
        }
        for c in coincidences {
            sets.union(node(c.at, c.first), node(c.at, c.second));
        }
        let mut levels: Vec<Level> = (0..)
            .zip(&nodes)
            .map(|(i, &(at, sheet))| Level {
                number: sets.find(i),
                at,
                sheet,
            })
            .collect();
        levels.sort_unstable();
        levels
    }

    fn connect_group(&self, group: &[Level], work: &mut Work, out: &mut Vec<VerticalContact>) {
        let Work {
            ending,
            beginning,
            below,
            above,
            marks,
            stretches,
        } = work;
        let at = group[0].at;
        ending.clear();
        beginning.clear();
        for level in group {
            for (i, c) in self.cells.of(level.sheet).filter(|(i, _)| self.counts(*i)) {
                if c.to == at {
                    ending.push(i);
                }
                if c.from == at {
                    beginning.push(i);
                }
            }
        }
        // Cells that are blocked below and above need no contacts.
        let matters = |&i: &u32| !self.cells.cells[i as usize].blocked;
        let none_matters = !ending.iter().chain(&*beginning).any(matters);
        if ending.is_empty() || beginning.is_empty() || none_matters {
            return;
        }
        let turn = self.clusters.turn(at);
        let first = &self.geometry.contacts.sheets[group[0].sheet as usize];
        let track = Track::of(first, turn);
        self.pieces(ending, at, Side::Below, &track, below);
        self.pieces(beginning, at, Side::Above, &track, above);
        marks.clear();
        marks.extend(
            (below.iter().chain(&*above))
                .flat_map(|p| [p.mid - p.half, p.mid + p.half])
                .map(|m| track.difference(m, 0.0)),
        );
        marks.extend(track.cuts().into_iter().flatten());
        marks.sort_unstable_by(f64::total_cmp);
        let (just_below, just_above) = self.clusters.exactly_beside(at);
        // Most often one piece covers a place, and its height is not needed.
        let turn_below = LazyCell::new(|| Orientation::by(just_below));
        let turn_above = LazyCell::new(|| Orientation::by(just_above));
        let (mut near_below, mut near_above) = (track.covering(below), track.covering(above));
        stretches.iter_mut().for_each(Vec::clear);
        for w in marks.windows(2) {
            if w[1] - w[0] <= SHORTEST_OVERLAP {
                continue;
            }
            let middle = 0.5 * (w[0] + w[1]);
            let place = Place::new(&track, middle);
            near_below.go_to(middle);
            near_above.go_to(middle);
            let low = near_below.here().map(|i| &below[i]);
            let low = self.outermost(low, &track, &place, &turn_below);
            let high = near_above.here().map(|i| &above[i]);
            let high = self.outermost(high, &track, &place, &turn_above);
            for ((low, high), stretches) in low.into_iter().zip(high).zip(&mut *stretches) {
                let (Some(low), Some(high)) = (low, high) else {
                    continue;
                };
                let certain = [low, high]
                    .iter()
                    .all(|q| q.certainly_covers(&track, middle));
                match stretches.last_mut() {
                    Some(s)
                        if (s.lower, s.upper) == (low.cell, high.cell)
                            && w[0] - s.to <= SHORTEST_OVERLAP =>
                    {
                        s.to = w[1];
                        s.certain |= certain;
                    }
                    _ => stretches.push(Stretch {
                        lower: low.cell,
                        upper: high.cell,
                        from: w[0],
                        to: w[1],
                        certain,
                    }),
                }
            }
        }
        out.extend(stretches.iter().flatten().map(|s| {
            // Range along the lower cell's own curve, from its middle.
            let curve = self.curve(self.sheet_of(s.lower), at);
            let middle = track.point(0.5 * (s.from + s.to));
            let place = curve.position(middle);
            let half = 0.5 * (s.to - s.from);
            VerticalContact {
                lower: s.lower,
                upper: s.upper,
                at,
                lo: place - half,
                hi: place + half,
                certain: s.certain,
            }
        }));
    }

    fn sheet_of(&self, cell: u32) -> u32 {
        self.cells.cells[cell as usize].sheet
    }

    /// The pieces of a track that are cells.
    fn pieces(&self, cells: &[u32], at: u32, side: Side, track: &Track, out: &mut Vec<Piece>) {
        out.clear();
        for same in cells.chunk_by(|&a, &b| self.sheet_of(a) == self.sheet_of(b)) {
            self.pieces_of_sheet(same, at, side, track, out);
        }
    }

    /// Appends the pieces of a track that are cells of one sheet.
    fn pieces_of_sheet(
        &self,
        cells: &[u32],
        at: u32,
        side: Side,
        track: &Track,
        out: &mut Vec<Piece>,
    ) {
        let index = self.sheet_of(cells[0]);
        let sheet = &self.geometry.contacts.sheets[index as usize];
        let curve = self.curve(index, at);
        let mut extents = self.extents(index, at);
        for &cell in cells {
            let e = extents.of(&self.cells.cells[cell as usize], side);
            let p = curve.point(0.5 * (e.lo + e.hi));
            let (along, forward) = track.ways(sheet, curve.normal(p), p);
            let (lo, hi) = (e.lo_error, e.hi_error);
            let errors = if forward { (lo, hi) } else { (hi, lo) };
            let half = 0.5 * (e.hi - e.lo);
            if half > 0.0 {
                out.push(Piece {
                    cell,
                    mid: track.coordinate(p),
                    half,
                    errors,
                    along,
                });
            }
        }
    }

    /// The pieces that face free space at a place, just beside the level, on the face of the track along its normal and on the other face.
    fn outermost<'p>(
        &self,
        pieces: impl Iterator<Item = &'p Piece>,
        track: &Track,
        place: &Place,
        turn: &impl Deref<Target = Orientation<Exact>>,
    ) -> [Option<&'p Piece>; 2] {
        let mut covering = pieces.filter(|q| q.covers(track, place.coordinate));
        let (first, second) = (covering.next(), covering.next());
        if second.is_none() {
            // A single piece is outermost, whatever its height.
            return [true, false].map(|along| first.filter(|q| q.along == along));
        }
        let mut highest: Option<(Exact, &Piece)> = None;
        let mut lowest: Option<(Exact, &Piece)> = None;
        for q in first.into_iter().chain(second).chain(covering) {
            let h = self.height(q.cell, place.point, place.normal, turn);
            if q.along && highest.is_none_or(|b| h > b.0) {
                highest = Some((h, q));
            } else if !q.along && lowest.is_none_or(|b| h < b.0) {
                lowest = Some((h, q));
            }
        }
        // Pieces that face each other leave no room unless they are apart.
        match (highest, lowest) {
            (Some(a), Some(b)) if a.0 >= b.0 => [None; 2],
            _ => [highest, lowest].map(|outer| outer.map(|o| o.1)),
        }
    }

    /// Signed distance, outward from a point, of the line or circle of a cell's sheet.
    fn height(&self, cell: u32, p: Point, outward: Vector, turn: &Orientation<Exact>) -> Exact {
        (self.geometry.curve(self.sheet_of(cell), turn))
            .height(p.map(Exact::from), outward.map(Exact::from))
    }

    /// Connects cells that continue each other at the two ends of a full turn, which are one orientation.
    pub(crate) fn connect_wraps(&self, out: &mut Vec<VerticalContact>) {
        let sheets = &self.geometry.contacts.sheets;
        let mut groups: BTreeMap<Seam, (Vec<u32>, Vec<u32>)> = BTreeMap::new();
        for (i, c) in (0u32..).zip(&self.cells.cells) {
            let sheet = &sheets[c.sheet as usize];
            if c.at_top && matches!(sheet.top, Seam::Wrap(..)) {
                groups.entry(sheet.top).or_default().0.push(i);
            }
            if c.at_bottom && matches!(sheet.bottom, Seam::Wrap(..)) {
                groups.entry(sheet.bottom).or_default().1.push(i);
            }
        }
        let groups: Vec<_> = groups.into_values().collect();
        let found = parallel::chunks(&groups, CHUNK, |_, groups| {
            let mut out = Vec::new();
            for (ends, starts) in groups {
                let above = self.measured(starts, Side::Above);
                for (&lower, below) in ends.iter().zip(self.measured(ends, Side::Below)) {
                    for (&upper, above) in starts.iter().zip(&above) {
                        out.extend(below.shared_with(above).map(|shared| VerticalContact {
                            lower,
                            upper,
                            at: self.cells.cells[lower as usize].to,
                            lo: shared.lo,
                            hi: shared.hi,
                            certain: shared.certain,
                        }));
                    }
                }
            }
            out
        });
        out.extend(found.into_iter().flatten());
    }

    /// The extents of cells that end or begin together, where they do: all of one sheet are measured with the same curve.
    fn measured(&self, cells: &[u32], side: Side) -> Vec<Extent> {
        let mut all = Vec::with_capacity(cells.len());
        for same in cells.chunk_by(|&a, &b| self.sheet_of(a) == self.sheet_of(b)) {
            let cell = |c: u32| &self.cells.cells[c as usize];
            let first = cell(same[0]);
            let at = match side {
                Side::Below => first.to,
                Side::Above => first.from,
            };
            let mut extents = self.extents(first.sheet, at);
            all.extend(same.iter().map(|&c| extents.of(cell(c), side)));
        }
        all
    }
}

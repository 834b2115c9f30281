//! The free configurations of a part and of all parts that hang on it, as a graph over the part's coordinate.
//!
//! Over a *slab* of the coordinate x the free configurations fall into *cells* that all reach from one end of the slab to the other, and
//! that links join across its ends: a Reeb graph. A part with none on it is one cell. Otherwise, for each child, with y its coordinate:
//! at one x, a gap of the plane (x, y) leaves of the child's graph what is over an interval of y, which falls into connected *pieces*;
//! a slab ends where an end of a gap, which is monotone, passes an end of a slab of the child. The children do not touch each other, so
//! a cell is any choice of a piece of each.

use core::f64::consts::TAU;
use std::collections::HashMap;

use cspace::parallel;

use crate::modes::column::clusters;
use crate::modes::error::ModesError;
use crate::modes::extent::Extent;
use crate::modes::plane::{Plane, turns_onto};
use crate::modes::roots::sign_change;
use crate::modes::tree::hang::Knot;
use crate::modes::tree::turning::{MOST_TURNING, Turning, Whole};
use crate::modes::turns::{Sets, less, plus};

/// The most cells of a graph, and the most links of it: each takes some 80 bytes, all a third of a gigabyte.
pub(crate) const MOST_PRODUCTS: usize = 1 << 22;

/// The graph of a part and of what hangs on it.
#[derive(Debug)]
pub(crate) struct Branch {
    pub(crate) coordinate: usize,
    pub(crate) x: Extent,
    pub(crate) children: Vec<(Plane, Branch)>,
    pub(crate) slabs: Vec<Slab>,
    pub(crate) cells: usize,
    /// From each slab to the next one; of a full turn, from the last to the first.
    links: Vec<Vec<Link>>,
}

/// An interval of the coordinate over which no cell comes or goes.
#[derive(Debug)]
pub(crate) struct Slab {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// The number of its first cell.
    pub(crate) first: usize,
    /// Pieces of each child.
    pub(crate) pieces: Vec<Vec<Piece>>,
}

/// Connected cells of a child that are in a gap.
#[derive(Debug)]
pub(crate) struct Piece {
    pub(crate) gap: usize,
    pub(crate) cells: Vec<Instance>,
    /// Turns by which motions within it come back.
    loops: Vec<Whole>,
}

/// A cell of a child, as it is in a piece.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Instance {
    pub(crate) cell: usize,
    /// In which turn of the child's coordinate the gap meets it.
    pub(crate) turns: i32,
    /// Turns of all coordinates by which it is moved, seen from the origin of the piece.
    pub(crate) at: Whole,
}

/// Cell `to`, moved by some turns, goes on where cell `from` ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Link {
    from: usize,
    to: usize,
    by: Whole,
}

impl Slab {
    pub(crate) fn cells(&self) -> usize {
        self.pieces.iter().map(Vec::len).product()
    }

    /// The cell of a piece of each child.
    pub(crate) fn cell(&self, of: &[usize]) -> usize {
        let digits = self.pieces.iter().zip(of);
        self.first + digits.fold(0, |number, (pieces, k)| number * pieces.len() + k)
    }

    /// The piece of each child that a cell is of.
    pub(crate) fn pieces_of(&self, cell: usize) -> Vec<&Piece> {
        let mut rest = cell - self.first;
        let mut of: Vec<&Piece> = (self.pieces.iter().rev())
            .map(|pieces| {
                let k = rest % pieces.len();
                rest /= pieces.len();
                &pieces[k]
            })
            .collect();
        of.reverse();
        of
    }
}

impl Branch {
    pub(crate) fn of(knot: Knot, names: &[String], turning: &Turning) -> Result<Self, ModesError> {
        let children: Vec<(Plane, Self)> = (knot.below.into_iter())
            .map(|(plane, below)| Ok((plane, Self::of(below, names, turning)?)))
            .collect::<Result<_, ModesError>>()?;
        let mut branch = Self {
            coordinate: knot.coordinate,
            x: knot.x,
            children,
            slabs: Vec::new(),
            cells: 0,
            links: Vec::new(),
        };
        let too_many = |products: usize| ModesError::TooManyProducts {
            part: names[knot.coordinate].clone(),
            products,
            limit: MOST_PRODUCTS,
        };
        let intervals = branch.intervals();
        branch.slabs = parallel::map(&intervals, 1, |&(lo, hi)| {
            let x = 0.5 * (lo + hi);
            let pieces = (branch.children.iter())
                .map(|(plane, child)| child.pieces(plane, x, turning))
                .collect();
            let first = 0;
            Slab {
                lo,
                hi,
                first,
                pieces,
            }
        });
        for slab in &mut branch.slabs {
            slab.first = branch.cells;
            let counts = slab.pieces.iter().map(Vec::len);
            let cells = counts.fold(1, |all: usize, n| all.saturating_mul(n));
            branch.cells = branch.cells.saturating_add(cells);
            if branch.cells > MOST_PRODUCTS {
                return Err(too_many(branch.cells));
            }
        }
        let n = branch.slabs.len();
        let mut all = 0_usize;
        for k in 0..n {
            if k + 1 < n || branch.x.circle {
                let joins = branch.joins(k, (k + 1) % n);
                let counts = joins.iter().map(Vec::len);
                all = all.saturating_add(counts.fold(1, |all: usize, n| all.saturating_mul(n)));
                if all > MOST_PRODUCTS {
                    return Err(too_many(all));
                }
                let around = turning.of_one(branch.coordinate, i32::from(k + 1 == n));
                let links = branch.products(k, (k + 1) % n, around, &joins);
                branch.links.push(links);
            } else {
                branch.links.push(Vec::new());
            }
        }
        Ok(branch)
    }

    /// The slabs of the coordinate.
    fn intervals(&self) -> Vec<(f64, f64)> {
        let mut critical = Vec::new();
        for (plane, child) in &self.children {
            critical.extend(plane.bands.iter().flat_map(|b| [b.lo, b.hi]));
            child.passings(plane, &mut critical);
        }
        if self.children.is_empty() {
            critical.extend([self.x.lo, self.x.hi]);
        }
        let clusters = clusters(critical, self.x.narrowest);
        clusters.windows(2).map(|w| (w[0].1, w[1].0)).collect()
    }

    /// The coordinates at which a slab goes over into the next one.
    fn levels(&self) -> Vec<f64> {
        let ends = self.slabs.windows(2).map(|w| 0.5 * (w[0].hi + w[1].lo));
        ends.chain(self.x.circle.then_some(self.x.lo)).collect()
    }

    /// Adds the x at which an end of a gap of the plane (x, y) passes an end of a slab, of which the coordinate is y.
    fn passings(&self, plane: &Plane, critical: &mut Vec<f64>) {
        let levels = self.levels();
        for band in &plane.bands {
            for gap in band.gaps.clone() {
                let Some(span) = plane.span(gap) else {
                    continue;
                };
                for end in [span.lower, span.upper] {
                    let (a, b) = (end.at(band.lo), end.at(band.hi));
                    for &level in &levels {
                        for turns in plane.shifts((level, level), (a.min(b), a.max(b))) {
                            let level = level + TAU * f64::from(turns);
                            let at = sign_change(|x| end.at(x) - level, (band.lo, band.hi));
                            critical.extend(at);
                        }
                    }
                }
            }
        }
    }

    /// The pieces of the gaps of a plane at an x.
    fn pieces(&self, plane: &Plane, x: f64, turning: &Turning) -> Vec<Piece> {
        let gaps = plane.bands[plane.band_at(x)].gaps.clone();
        gaps.flat_map(|gap| {
            let interval = plane.span(gap).map(|span| span.at(x));
            self.pieces_in(gap, interval, turning)
        })
        .collect()
    }

    /// The pieces of what is over an interval of the coordinate; `None` is a full turn.
    fn pieces_in(&self, gap: usize, y: Option<(f64, f64)>, turning: &Turning) -> Vec<Piece> {
        // Slabs, each with its turn and the number of its first cell here.
        let mut over: Vec<(usize, i32, usize)> = Vec::new();
        let mut cells = 0;
        let turns = match y {
            Some(y) => turns_onto(self.x.circle, (self.x.lo, self.x.hi), y),
            None => 0..=0,
        };
        for turns in turns {
            let by = TAU * f64::from(turns);
            for (k, slab) in self.slabs.iter().enumerate() {
                let room = |(lo, hi): (f64, f64)| hi.min(slab.hi + by) - lo.max(slab.lo + by);
                if y.is_none_or(|y| room(y) > self.x.opening) {
                    over.push((k, turns, cells));
                    cells += slab.cells();
                }
            }
        }
        let first: HashMap<(usize, i32), usize> = (over.iter())
            .map(|&(k, t, first)| ((k, t), first))
            .collect();
        let mut sets: Sets<MOST_TURNING> = Sets::new(cells);
        for &(k, turns, from) in &over {
            let next = (k + 1) % self.slabs.len();
            let around = i32::from(next <= k);
            let there = if y.is_some() { turns + around } else { turns };
            if let Some(&to) = first.get(&(next, there)) {
                let moved = turning.of_one(self.coordinate, there - turns);
                for link in &self.links[k] {
                    let a = from + link.from - self.slabs[k].first;
                    let b = to + link.to - self.slabs[next].first;
                    sets.link(a as u32, b as u32, less(link.by, moved));
                }
            }
            for (number, cell) in self.cells_of(k).enumerate() {
                for by in self.loops(k, cell) {
                    let a = (from + number) as u32;
                    sets.link(a, a, by);
                }
            }
        }
        let mut pieces: Vec<Piece> = Vec::new();
        let mut known: HashMap<u32, usize> = HashMap::new();
        for &(k, turns, from) in &over {
            for (number, cell) in self.cells_of(k).enumerate() {
                let (root, at) = sets.find((from + number) as u32);
                let piece = *known.entry(root).or_insert_with(|| {
                    let rows = sets.lattice(root).reduced();
                    pieces.push(Piece {
                        gap,
                        cells: Vec::new(),
                        loops: rows.iter().map(|row| row.map(|t| t as i32)).collect(),
                    });
                    pieces.len() - 1
                });
                pieces[piece].cells.push(Instance {
                    cell,
                    turns,
                    at: plus(at, turning.of_one(self.coordinate, turns)),
                });
            }
        }
        pieces
    }

    fn cells_of(&self, slab: usize) -> core::ops::Range<usize> {
        let slab = &self.slabs[slab];
        slab.first..slab.first + slab.cells()
    }

    /// Turns by which motions within a cell come back.
    fn loops(&self, slab: usize, cell: usize) -> impl Iterator<Item = Whole> {
        let pieces = self.slabs[slab].pieces_of(cell);
        pieces.into_iter().flat_map(|p| p.loops.clone())
    }

    /// The slab of a cell.
    pub(crate) fn slab_of(&self, cell: usize) -> &Slab {
        let after = self.slabs.partition_point(|slab| slab.first <= cell);
        &self.slabs[after - 1]
    }

    /// For each child, the pieces of a slab that go on in pieces of the next one, with the turns by which these are to be moved.
    fn joins(&self, from: usize, to: usize) -> Vec<Vec<(usize, usize, Whole)>> {
        let (left, right) = (&self.slabs[from], &self.slabs[to]);
        let middle = |slab: &Slab| 0.5 * (slab.lo + slab.hi);
        (self.children.iter().enumerate())
            .map(|(k, (plane, child))| {
                let bands = (plane.band_at(middle(left)), plane.band_at(middle(right)));
                let openings = plane.openings((bands.0, left.hi), (bands.1, right.lo));
                let mut joins = Vec::new();
                for opening in openings {
                    let there: HashMap<(usize, i32), (usize, Whole)> =
                        (right.pieces[k].iter().enumerate())
                            .filter(|(_, piece)| piece.gap == opening.to)
                            .flat_map(|(b, piece)| {
                                piece
                                    .cells
                                    .iter()
                                    .map(move |c| ((c.cell, c.turns), (b, c.at)))
                            })
                            .collect();
                    for (a, piece) in left.pieces[k].iter().enumerate() {
                        for c in piece.cells.iter().filter(|_| piece.gap == opening.from) {
                            let slab = child.slab_of(c.cell);
                            let by = TAU * f64::from(c.turns);
                            let is_open =
                                opening.lo.max(slab.lo + by) < opening.hi.min(slab.hi + by);
                            let other = there.get(&(c.cell, c.turns - opening.turns));
                            if let (true, Some(&(b, at))) = (is_open, other) {
                                joins.push((a, b, less(c.at, at)));
                            }
                        }
                    }
                }
                joins.sort_unstable();
                joins.dedup();
                joins
            })
            .collect()
    }

    /// The links from one slab to another: all combinations of joins of the children.
    fn products(
        &self,
        from: usize,
        to: usize,
        around: Whole,
        joins: &[Vec<(usize, usize, Whole)>],
    ) -> Vec<Link> {
        let mut some: Vec<(Vec<usize>, Vec<usize>, Whole)> = vec![(vec![], vec![], around)];
        for joins in joins {
            some = (some.iter())
                .flat_map(|(a, b, by)| {
                    joins.iter().map(move |&(p, q, more)| {
                        let with = |of: &[usize], k: usize| [of, &[k]].concat();
                        (with(a, p), with(b, q), plus(*by, more))
                    })
                })
                .collect();
        }
        let (left, right) = (&self.slabs[from], &self.slabs[to]);
        (some.into_iter())
            .map(|(a, b, by)| Link {
                from: left.cell(&a),
                to: right.cell(&b),
                by,
            })
            .collect()
    }

    /// All cells joined.
    pub(crate) fn sets(&self) -> Sets<MOST_TURNING> {
        let mut sets = Sets::new(self.cells);
        for (k, links) in self.links.iter().enumerate() {
            for link in links {
                sets.link(link.from as u32, link.to as u32, link.by);
            }
            for cell in self.cells_of(k) {
                for by in self.loops(k, cell) {
                    sets.link(cell as u32, cell as u32, by);
                }
            }
        }
        sets
    }

    /// Places at which the planes contradict themselves.
    pub(crate) fn conflicts(&self) -> usize {
        let of = |(plane, child): &(Plane, Self)| plane.conflicts() + child.conflicts();
        self.children.iter().map(of).sum()
    }
}

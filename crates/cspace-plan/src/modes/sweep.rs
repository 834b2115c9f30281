//! Free space of three coordinates, swept along one that two of the planes have in common.

use cspace::parallel;

use crate::modes::column::{Column, Layer, Layers, clusters};
use crate::modes::error::ModesError;
use crate::modes::plane::{Opening, Plane};
use crate::modes::section::Place;
use crate::modes::turns::Sets;

/// The most columns: each takes some 250 bytes, all a gigabyte.
const MOST_COLUMNS: usize = 1 << 22;

/// The three planes: of (s, p) and of (s, q), both swept along s, and of (p, q), swept along p.
#[derive(Debug)]
pub(crate) struct Planes {
    pub(crate) sp: Plane,
    pub(crate) sq: Plane,
    pub(crate) pq: Plane,
}

/// An interval of s in which the free intervals of p and q stay in order.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slab {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// The bands of both planes.
    pub(crate) bands: (usize, usize),
    /// Index of its first stack.
    pub(crate) first: usize,
}

/// The layers of a column.
#[derive(Debug)]
pub(crate) struct Stack {
    pub(crate) slab: usize,
    /// The gaps of both planes.
    pub(crate) gaps: (usize, usize),
    pub(crate) layers: Vec<Layer>,
    /// The number of its first cell.
    pub(crate) first: u32,
}

/// Result of the sweep.
#[derive(Debug)]
pub(crate) struct Swept {
    pub(crate) slabs: Vec<Slab>,
    pub(crate) stacks: Vec<Stack>,
    /// Connected sets of the cells of all layers, in order.
    pub(crate) sets: Sets<3>,
    pub(crate) cells: u32,
    /// Columns in which critical values could not be separated.
    pub(crate) undecided: usize,
}

impl Planes {
    pub(crate) fn column<'a>(
        &'a self,
        openings: &'a [Vec<Opening>],
        slab: &Slab,
        gaps: (usize, usize),
    ) -> Column<'a> {
        Column {
            plane: &self.pq,
            openings,
            p: self.sp.span(gaps.0),
            q: self.sq.span(gaps.1),
            slab: (slab.lo, slab.hi),
            narrowest: self.sp.x.narrowest,
        }
    }

    /// The openings from each band of (p, q) to the next one.
    pub(crate) fn openings(&self) -> Vec<Vec<Opening>> {
        let plane = &self.pq;
        let n = plane.bands.len();
        (0..n)
            .map(|k| {
                let next = (k + 1) % n;
                if next <= k && !plane.x.circle {
                    return Vec::new();
                }
                plane.openings((k, plane.bands[k].hi), (next, plane.bands[next].lo))
            })
            .collect()
    }

    fn columns_of(&self, bands: (usize, usize)) -> usize {
        self.sp.bands[bands.0].gaps.len() * self.sq.bands[bands.1].gaps.len()
    }

    fn slabs(&self) -> Vec<Slab> {
        let ends =
            |plane: &Plane| -> Vec<f64> { plane.bands.iter().flat_map(|b| [b.lo, b.hi]).collect() };
        let all = [ends(&self.sp), ends(&self.sq)].concat();
        let clusters = clusters(all, self.sp.x.narrowest);
        let mut first = 0;
        let between = clusters.windows(2).map(|w| (w[0].1, w[1].0));
        between
            .map(|(lo, hi)| {
                let middle = 0.5 * (lo + hi);
                let bands = (self.sp.band_at(middle), self.sq.band_at(middle));
                let slab = Slab {
                    lo,
                    hi,
                    bands,
                    first,
                };
                first += self.columns_of(bands);
                slab
            })
            .collect()
    }

    pub(crate) fn sweep(&self) -> Result<Swept, ModesError> {
        let slabs = self.slabs();
        let columns = slabs
            .last()
            .map_or(0, |s| s.first + self.columns_of(s.bands));
        if columns > MOST_COLUMNS {
            return Err(ModesError::TooLarge {
                columns,
                limit: MOST_COLUMNS,
            });
        }
        let openings = self.openings();
        let columns: Vec<(usize, usize, usize)> = (slabs.iter().enumerate())
            .flat_map(|(k, slab)| {
                let (a, b) = (&self.sp.bands[slab.bands.0], &self.sq.bands[slab.bands.1]);
                let q = b.gaps.clone();
                (a.gaps.clone()).flat_map(move |i| q.clone().map(move |j| (k, i, j)))
            })
            .collect();
        let layers: Vec<Layers> = parallel::map(&columns, 1, |&(k, i, j)| {
            self.column(&openings, &slabs[k], (i, j)).layers()
        });
        let undecided = layers.iter().filter(|l| !l.decided).count();
        let mut cells = 0;
        let stacks: Vec<Stack> = (columns.into_iter().zip(layers))
            .map(|((slab, i, j), l)| {
                let first = cells;
                cells += l.layers.iter().map(|l| l.cells.len() as u32).sum::<u32>();
                Stack {
                    slab,
                    gaps: (i, j),
                    layers: l.layers,
                    first,
                }
            })
            .collect();
        let mut swept = Swept {
            sets: Sets::new(cells as usize),
            slabs,
            stacks,
            cells,
            undecided,
        };
        for number in 0..swept.stacks.len() {
            self.join_layers(&mut swept, &openings, number);
        }
        let n = swept.slabs.len();
        for k in 0..n {
            if k + 1 < n || self.sp.x.circle {
                self.join_slabs(&mut swept, k, (k + 1) % n);
            }
        }
        Ok(swept)
    }

    /// Joins the cells of a column: within each layer, and from one to the next.
    fn join_layers(&self, swept: &mut Swept, openings: &[Vec<Opening>], number: usize) {
        let stack = &swept.stacks[number];
        let column = self.column(openings, &swept.slabs[stack.slab], stack.gaps);
        let whole = (column.p.is_none(), column.q.is_none());
        let mut first = stack.first;
        for (k, layer) in stack.layers.iter().enumerate() {
            for &(a, b, [p, q]) in &layer.beside {
                swept
                    .sets
                    .link(first + a as u32, first + b as u32, [0, p, q]);
            }
            for (a, cell) in (first..).zip(&layer.cells) {
                // All of a full turn is free: it comes back to itself.
                if whole.1 && self.pq.span(cell.gap as usize).is_none() {
                    swept.sets.link(a, a, [0, 0, 1]);
                }
            }
            let after = first + layer.cells.len() as u32;
            if let Some(next) = stack.layers.get(k + 1) {
                let (p, q) = column.rectangle(layer.hi);
                for (a, cell) in (first..).zip(&layer.cells) {
                    let same = next.cells.iter().position(|c| c == cell);
                    let Some(b) = same else { continue };
                    if self.pq.within(*cell, p, q).is_some() {
                        swept.sets.link(a, after + b as u32, [0; 3]);
                    }
                }
            }
            first = after;
        }
    }

    /// Joins the cells at the end of a slab to those at the beginning of the next one.
    fn join_slabs(&self, swept: &mut Swept, from: usize, to: usize) {
        let (left, right) = (swept.slabs[from], swept.slabs[to]);
        let around = i32::from(to <= from);
        let open = |plane: &Plane, a: usize, b: usize| plane.openings((a, left.hi), (b, right.lo));
        let in_p = open(&self.sp, left.bands.0, right.bands.0);
        let in_q = open(&self.sq, left.bands.1, right.bands.1);
        let stack = |plane: &Planes, slab: &Slab, gaps: (usize, usize)| {
            let (a, b) = (
                &plane.sp.bands[slab.bands.0].gaps,
                &plane.sq.bands[slab.bands.1].gaps,
            );
            slab.first + (gaps.0 - a.start) * b.len() + (gaps.1 - b.start)
        };
        for p in &in_p {
            for q in &in_q {
                let a = &swept.stacks[stack(self, &left, (p.from, q.from))];
                let b = &swept.stacks[stack(self, &right, (p.to, q.to))];
                let links = self.links((a, b), (p, q));
                for (a, b, [turns_p, turns_q]) in links {
                    swept.sets.link(a, b, [around, turns_p, turns_q]);
                }
            }
        }
    }

    /// The last cells of one stack and the first of another that go over into each other through openings of p and q.
    fn links(
        &self,
        (a, b): (&Stack, &Stack),
        (p, q): (&Opening, &Opening),
    ) -> Vec<(u32, u32, [i32; 2])> {
        let mut links = Vec::new();
        let (Some(last), Some(next)) = (a.layers.last(), b.layers.first()) else {
            return links;
        };
        let before: usize = a.layers.iter().map(|l| l.cells.len()).sum();
        let first_a = a.first + (before - last.cells.len()) as u32;
        let whole_a = self.sq.span(a.gaps.1).is_none();
        let whole_b = self.sq.span(b.gaps.1).is_none();
        let (p_open, q_open) = (Some((p.lo, p.hi)), Some((q.lo, q.hi)));
        for (i, cell) in (first_a..).zip(&last.cells) {
            let whole = self.pq.span(cell.gap as usize).is_none();
            // In what turn the gap is met where the opening is.
            let turns = if whole || !whole_a {
                cell.q_turns..=cell.q_turns
            } else {
                self.pq
                    .turns_of(cell.band as usize, cell.gap as usize, q_open)
            };
            for q_turns in turns {
                let met = Place { q_turns, ..*cell };
                if self.pq.within(met, p_open, q_open).is_none() {
                    continue;
                }
                let there = Place {
                    p_turns: cell.p_turns - p.turns,
                    q_turns: match whole || whole_b {
                        true => 0,
                        false => q_turns - q.turns,
                    },
                    ..*cell
                };
                let by = match whole {
                    true if whole_a || whole_b => 0,
                    true => q.turns,
                    false => cell.q_turns - there.q_turns,
                };
                if let Some(k) = next.cells.iter().position(|c| *c == there) {
                    links.push((i, b.first + k as u32, [p.turns, by]));
                }
            }
        }
        links
    }
}

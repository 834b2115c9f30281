//! Copies from the window to the full turn of a part that repeats itself (figure 4 of Sacks 1999, for two degrees of freedom).

use super::arrange::{Cell, Stop};
use super::build;
use super::piece::{End, Key, Name, Pair, Piece};
use super::scene::Scene;
use super::sweep::{Band, Gap, Link, Swept};
use core::f64::consts::TAU;

impl Partition {
    /// The partition with all copies of the window, one after the other.
    pub(super) fn unrolled(self, scene: &Scene) -> Self {
        let fold = scene.repeats.fold;
        if fold == 1 {
            return self;
        }
        let copies = fold as usize;
        let mut all = Self {
            crossings: copies * self.crossings,
            ..Self::default()
        };
        all.swept.spans = self.swept.spans.repeat(copies);
        let middles: Vec<f64> = self.pieces.iter().map(|p| self.middle(p)).collect();
        for number in 0..fold {
            let copy = Copy {
                scene,
                number,
                by: scene.repeats.period() * f64::from(number),
                crossings: self.crossings as u32 * number,
                pairs: self.pairs.len() as u32 * number,
            };
            all.pairs.extend(self.pairs.iter().map(|p| copy.pair(p)));
            for (piece, &y) in self.pieces.iter().zip(&middles) {
                let moved = copy.piece(piece, y, &all.pairs);
                all.pieces.push(moved);
            }
            let first = self.pieces.len() as u32 * number;
            all.cells
                .extend(self.cells.iter().map(|c| copy.cell(c, &self.pieces, first)));
            let cells = self.cells.len() as u32;
            all.joints.extend(
                self.joints
                    .iter()
                    .map(|j| self.joint(*j, cells, number, fold)),
            );
            self.swept.copied(&copy, cells, fold, &mut all.swept);
        }
        all
    }

    /// y in the middle of a graph, according to its pair's root.
    fn middle(&self, piece: &Piece) -> f64 {
        if piece.vertical {
            return 0.0;
        }
        let x = 0.5 * (piece.start.x + piece.end.x);
        let condition = &self.pairs[piece.pair as usize].condition;
        condition.y(x, piece.root)
    }

    /// A joint of the copy: at a seam the cell that ends there is followed by a cell of the next copy.
    fn joint(
        &self,
        joint: [(u32, bool); 2],
        cells: u32,
        number: u32,
        fold: u32,
    ) -> [(u32, bool); 2] {
        let [a, b] = joint;
        let stop = |(i, at_end): (u32, bool)| {
            let c = &self.cells[i as usize];
            if at_end { c.end } else { c.start }
        };
        let seam = |s: Stop| matches!(s, Stop::Node(key) if matches!(key.name, Name::Seam(..)));
        let across = seam(stop(a)) && seam(stop(b));
        let of = |(i, at_end): (u32, bool)| {
            let next = across && !at_end;
            let copy = if next { (number + 1) % fold } else { number };
            (i + cells * copy, at_end)
        };
        [of(a), of(b)]
    }
}

/// One copy of the window.
struct Copy<'a> {
    scene: &'a Scene,
    number: u32,
    by: f64,
    crossings: u32,
    pairs: u32,
}

impl Copy<'_> {
    fn pair(&self, pair: &Pair) -> Pair {
        let repeats = &self.scene.repeats;
        let first = repeats.image(pair.first, repeats.fold - self.number);
        build::pair(self.scene, first, pair.second).unwrap_or(Pair { first, ..*pair })
    }

    /// The image of a piece; `y` is the middle of a graph according to the pair in the window.
    fn piece(&self, piece: &Piece, y: f64, pairs: &[Pair]) -> Piece {
        let end = |e: &End| End {
            key: self.key(e.key),
            x: e.x + self.by,
            ..*e
        };
        let mut moved = Piece {
            pair: piece.pair + self.pairs,
            start: end(&piece.start),
            end: end(&piece.end),
            ..*piece
        };
        if !piece.vertical && self.number > 0 && self.scene.y.repeats() {
            // Roots of the image may be measured from an angle a turn away.
            let x = 0.5 * (piece.start.x + piece.end.x) + self.by;
            let here = pairs[moved.pair as usize].condition.y(x, piece.root);
            moved.turns += ((y - here) / TAU).round() as i32;
        }
        moved
    }

    fn key(&self, key: Key) -> Key {
        Key {
            x_turn: key.x_turn + self.number as i32,
            ..key.renumbered(|pair| pair + self.pairs)
        }
    }

    fn cell(&self, cell: &Cell, pieces: &[Piece], first: u32) -> Cell {
        // The parameter of a graph is x, that of a vertical piece y.
        let by = if pieces[cell.piece as usize].vertical {
            0.0
        } else {
            self.by
        };
        let stop = |s: Stop| match s {
            Stop::Node(key) => Stop::Node(self.key(key)),
            Stop::Crossing(i) => Stop::Crossing(i + self.crossings),
        };
        Cell {
            piece: cell.piece + first,
            from: cell.from + by,
            to: cell.to + by,
            start: stop(cell.start),
            end: stop(cell.end),
            ..*cell
        }
    }
}

impl Swept {
    fn copied(&self, copy: &Copy<'_>, cells: u32, fold: u32, all: &mut Self) {
        let gaps = self.gaps.len() as u32;
        let first = gaps * copy.number;
        all.bands.extend(self.bands.iter().map(|b| Band {
            lo: b.lo + copy.by,
            hi: b.hi + copy.by,
            gaps: b.gaps.start + first..b.gaps.end + first,
        }));
        let cell = |c: Option<u32>| c.map(|i| i + cells * copy.number);
        all.gaps.extend(self.gaps.iter().map(|g| Gap {
            lower: cell(g.lower),
            upper: cell(g.upper),
            ..*g
        }));
        all.links.extend(self.links.iter().map(|l| {
            let to = copy.number + l.x_turns as u32;
            Link {
                from: l.from + first,
                to: l.to + gaps * (to % fold),
                x_turns: i32::from(to == fold),
                y_turns: l.y_turns,
            }
        }));
    }
}

// Result of the sweep: the cells that bound free space, and the gaps between them.

/// The partition of the window, or of the full extent.
#[derive(Debug, Default)]
pub(super) struct Partition {
    pub(super) pairs: Vec<Pair>,
    pub(super) pieces: Vec<Piece>,
    pub(super) cells: Vec<Cell>,
    pub(super) joints: Vec<[(u32, bool); 2]>,
    pub(super) swept: Swept,
    pub(super) crossings: usize,
}

impl Partition {
    /// The partition without the cells that do not bound free space, and without the pieces and pairs that have no other cells: they are
    /// not needed.
    pub(super) fn kept(mut self, free: &[bool]) -> Self {
        let mut pieces = vec![false; self.pieces.len()];
        let mut pairs = vec![false; self.pairs.len()];
        for (cell, _) in self.cells.iter().zip(free).filter(|c| *c.1) {
            pieces[cell.piece as usize] = true;
            pairs[self.pieces[cell.piece as usize].pair as usize] = true;
        }
        let (new_cell, new_piece, new_pair) = (numbers(free), numbers(&pieces), numbers(&pairs));
        retain(&mut self.pairs, &pairs);
        retain(&mut self.pieces, &pieces);
        for piece in &mut self.pieces {
            *piece = piece.renumbered(|pair| new_pair[pair as usize]);
        }
        let stop = |s: Stop| match s {
            Stop::Node(key) => Stop::Node(key.renumbered(|pair| new_pair[pair as usize])),
            crossing => crossing,
        };
        retain(&mut self.cells, free);
        for cell in &mut self.cells {
            cell.piece = new_piece[cell.piece as usize];
            cell.start = stop(cell.start);
            cell.end = stop(cell.end);
        }
        self.joints
            .retain(|j| j.iter().all(|&(c, _)| free[c as usize]));
        for (cell, _) in self.joints.iter_mut().flatten() {
            *cell = new_cell[*cell as usize];
        }
        for gap in &mut self.swept.gaps {
            for cell in [&mut gap.lower, &mut gap.upper].into_iter().flatten() {
                *cell = new_cell[*cell as usize];
            }
        }
        self
    }
}

/// New consecutive numbers of the elements that are kept.
fn numbers(kept: &[bool]) -> Vec<u32> {
    let mut next = 0;
    kept.iter()
        .map(|&k| {
            let number = next;
            next += u32::from(k);
            number
        })
        .collect()
}

fn retain<T>(all: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    all.retain(|_| kept.next() == Some(&true));
}

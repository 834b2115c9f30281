//! What the sweep leaves: the cells that bound free space, and the gaps between them.

use super::arrange::{Cell, Stop};
use super::bands::Swept;
use super::piece::{Pair, Piece};

/// The partition of the window, or of all.
#[derive(Debug)]
pub(super) struct Partition {
    pub(super) pairs: Vec<Pair>,
    pub(super) pieces: Vec<Piece>,
    pub(super) cells: Vec<Cell>,
    pub(super) joints: Vec<[(u32, bool); 2]>,
    pub(super) free: Vec<bool>,
    pub(super) swept: Swept,
    pub(super) crossings: usize,
}

impl Partition {
    /// The partition without the cells that do not bound free space, and without the pieces and pairs of no other cells:
    /// nothing asks for them.
    pub(super) fn kept(mut self) -> Self {
        let mut pieces = vec![false; self.pieces.len()];
        let mut pairs = vec![false; self.pairs.len()];
        for (cell, _) in self.cells.iter().zip(&self.free).filter(|c| *c.1) {
            pieces[cell.piece as usize] = true;
            pairs[self.pieces[cell.piece as usize].pair as usize] = true;
        }
        let (new_cell, new_piece, new_pair) =
            (numbers(&self.free), numbers(&pieces), numbers(&pairs));
        retain(&mut self.pairs, &pairs);
        retain(&mut self.pieces, &pieces);
        for piece in &mut self.pieces {
            *piece = piece.renumbered(|pair| new_pair[pair as usize]);
        }
        let stop = |s: Stop| match s {
            Stop::Node(key) => Stop::Node(key.renumbered(|pair| new_pair[pair as usize])),
            crossing => crossing,
        };
        retain(&mut self.cells, &self.free);
        for cell in &mut self.cells {
            cell.piece = new_piece[cell.piece as usize];
            cell.start = stop(cell.start);
            cell.end = stop(cell.end);
        }
        let free = &self.free;
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
        self.free = vec![true; self.cells.len()];
        self
    }
}

/// The numbers of those that are kept, counted anew.
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

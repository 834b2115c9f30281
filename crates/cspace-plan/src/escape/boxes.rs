//! A domain of configurations divided into boxes, each free, blocked, or not known.

use crate::legs::{Coords, Scene};

use super::domain::Domain;
use super::energy::Energy;

/// State that all configurations of a box have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    Free,
    Blocked,
    /// Neither is known.
    Open,
}

/// A box of configurations.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub(super) lo: Coords,
    pub(super) hi: Coords,
    pub(super) state: State,
    halves: Option<[u32; 2]>,
}

/// A face that two boxes share.
#[derive(Debug, Clone, Copy)]
pub(super) struct Face {
    /// The box on the other side.
    pub(super) other: u32,
    pub(super) lo: Coords,
    pub(super) hi: Coords,
    /// How many turns more the other box's coordinates are: of the same place, −1 or 1 across the end of a coordinate that closes up.
    pub(super) turns: [i32; 3],
}

/// A domain divided by halving.
pub(super) struct Boxes<'a> {
    pub(super) scene: &'a Scene,
    pub(super) domain: Domain,
    pub(super) energy: Energy<'a>,
    pub(super) cells: Vec<Cell>,
}

impl<'a> Boxes<'a> {
    pub(super) fn new(scene: &'a Scene, domain: Domain, energy: Energy<'a>) -> Self {
        let mut boxes = Self {
            scene,
            cells: Vec::new(),
            energy,
            domain,
        };
        let (lo, hi) = (boxes.domain.lo, boxes.domain.hi);
        boxes.add(lo, hi, State::Open);
        boxes
    }

    fn add(&mut self, lo: Coords, hi: Coords, state: State) {
        let state = match state {
            State::Open => self.judged(lo, hi),
            known => known,
        };
        self.cells.push(Cell {
            lo,
            hi,
            state,
            halves: None,
        });
    }

    fn judged(&self, lo: Coords, hi: Coords) -> State {
        if self.domain.is_out(lo, hi) {
            return State::Free;
        }
        let (middle, half) = middle(lo, hi);
        let at = self.domain.configuration(middle);
        let moved = self.domain.moved(half);
        match (self.scene.is_apart(at, at, moved), self.scene.overlaps(at)) {
            (true, true) => State::Blocked,
            (true, false) => State::Free,
            (false, true) if self.scene.overlaps_deeply(at, moved) => State::Blocked,
            (false, _) => State::Open,
        }
    }

    /// Whether the motion of constant rates between two places is free, of which the first is.
    pub(super) fn is_free(&self, from: Coords, to: Coords) -> bool {
        let [a, b] = [from, to].map(|z| self.domain.configuration(z));
        is_free(self.scene, a, b)
    }

    pub(super) fn cell(&self, i: u32) -> &Cell {
        &self.cells[i as usize]
    }

    pub(super) fn is_divided(&self, i: u32) -> bool {
        self.cell(i).halves.is_some()
    }

    /// How far a box moves the parts.
    pub(super) fn extent(&self, i: u32) -> f64 {
        let cell = self.cell(i);
        self.domain.widest(cell.lo, cell.hi).1
    }

    /// Least and greatest energy in a box.
    pub(super) fn energy(&self, lo: Coords, hi: Coords) -> (f64, f64) {
        let (middle, half) = middle(lo, hi);
        self.energy.range(middle, half)
    }

    /// Halves a box across its longest side.
    pub(super) fn divide(&mut self, i: u32) -> [u32; 2] {
        let cell = *self.cell(i);
        if let Some(halves) = cell.halves {
            return halves;
        }
        let (k, _) = self.domain.widest(cell.lo, cell.hi);
        let at = 0.5 * (cell.lo[k] + cell.hi[k]);
        let (mut hi, mut lo) = (cell.hi, cell.lo);
        hi[k] = at;
        lo[k] = at;
        let first = self.cells.len() as u32;
        self.add(cell.lo, hi, cell.state);
        self.add(lo, cell.hi, cell.state);
        self.cells[i as usize].halves = Some([first, first + 1]);
        [first, first + 1]
    }

    /// The undivided box that holds coordinates.
    pub(super) fn holding(&self, at: Coords) -> u32 {
        let mut i = 0;
        while let Some([a, b]) = self.cell(i).halves {
            let within = |c: &Cell| (0..3).all(|k| c.lo[k] <= at[k] && at[k] <= c.hi[k]);
            i = if within(self.cell(a)) { a } else { b };
        }
        i
    }

    /// The undivided boxes beside one, with the faces that they share.
    pub(super) fn beside(&self, i: u32, found: &mut Vec<Face>) {
        found.clear();
        let cell = *self.cell(i);
        for k in 0..3 {
            for (side, end, opposite, turn) in [
                (cell.hi[k], self.domain.hi[k], self.domain.lo[k], -1),
                (cell.lo[k], self.domain.lo[k], self.domain.hi[k], 1),
            ] {
                let (mut lo, mut hi) = (cell.lo, cell.hi);
                let mut turns = [0; 3];
                let mut at = side;
                if side == end {
                    if !self.domain.around[k] {
                        continue;
                    }
                    at = opposite;
                    turns[k] = turn;
                }
                (lo[k], hi[k]) = (at, at);
                self.gather(0, k, (lo, hi), (side, turns), found);
            }
        }
        found.retain(|f| f.other != i);
    }

    /// The undivided boxes in a part of the tree that have a face in a rectangle across coordinate `k`, on the side on which the one
    /// that asks is not.
    fn gather(
        &self,
        i: u32,
        k: usize,
        (lo, hi): (Coords, Coords),
        (side, turns): (f64, [i32; 3]),
        found: &mut Vec<Face>,
    ) {
        let cell = self.cell(i);
        let meets = (0..3).all(|j| {
            if j == k {
                cell.lo[j] <= lo[j] && hi[j] <= cell.hi[j]
            } else {
                // The boxes have a face in common, not an edge; a coordinate without a range is no side.
                (cell.lo[j] < hi[j] && lo[j] < cell.hi[j]) || cell.lo[j] == cell.hi[j]
            }
        });
        if !meets {
            return;
        }
        if let Some(halves) = cell.halves {
            for half in halves {
                self.gather(half, k, (lo, hi), (side, turns), found);
            }
            return;
        }
        if lo[k] != cell.lo[k] && lo[k] != cell.hi[k] {
            return;
        }
        let mut face = Face {
            other: i,
            lo: core::array::from_fn(|j| lo[j].max(cell.lo[j])),
            hi: core::array::from_fn(|j| hi[j].min(cell.hi[j])),
            turns,
        };
        // In the numbers of the box that asks.
        (face.lo[k], face.hi[k]) = (side, side);
        found.push(face);
    }
}

/// Legs keep at least this share of the parts' size.
const KEPT: f64 = 1e-10;

/// Whether a leg is free that begins at a free configuration: nothing on it touches, and so nothing overlaps.
pub(super) fn is_free(scene: &Scene, from: Coords, to: Coords) -> bool {
    let kept = KEPT * scene.size() + scene.rounding(from, to);
    scene.is_apart(from, to, kept)
}

/// The middle of a box and half its sides.
pub(super) fn middle(lo: Coords, hi: Coords) -> (Coords, Coords) {
    (
        core::array::from_fn(|k| 0.5 * (lo[k] + hi[k])),
        core::array::from_fn(|k| 0.5 * (hi[k] - lo[k])),
    )
}

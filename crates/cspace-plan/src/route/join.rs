//! Legs from a way: so many, and so low above patches, that all are free.

use core::cell::Cell;

use crate::legs::{Coords, Scene};

use super::piece::Piece;

/// Legs are tried at these shares of the height that patches allow.
const HEIGHTS: [f64; 4] = [1.0, 0.25, 0.0625, 0.015_625];
/// Pieces are halved so often at most.
const HALVINGS: u32 = 40;
/// A path is given up after so many bridges, and so many for each piece: it keeps to surfaces with next to no clearance.
const MOST: usize = 1024;
const EACH: usize = 32;
/// Divisor of these where a path is known, and one with more clearance is sought.
const LESS: usize = 4;
/// A leg keeps at least this share of the clearance at its ends.
const KEPT: f64 = 0.1;

/// How much is tried before a path is given up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effort {
    /// There is a path by the contact space: its legs are sought.
    Full,
    /// Another path is known.
    Less,
}

/// The configurations between which all legs are free, from the start of the first piece to the end of the last. `None` if
/// there is no such path to rounding.
pub(crate) fn join(
    scene: &Scene,
    pieces: &[Box<dyn Piece + '_>],
    effort: Effort,
) -> Option<Vec<Coords>> {
    let all = MOST + EACH * pieces.len();
    let joiner = Joiner {
        scene,
        left: Cell::new(match effort {
            Effort::Full => all,
            Effort::Less => all / LESS,
        }),
    };
    let (first, last) = (pieces.first()?, pieces.last()?);
    let mut path = vec![first.at(0.0).at(1.0)];
    let mut begins = 0.0;
    for pair in pieces.windows(2) {
        let (a, b) = (pair[0].as_ref(), pair[1].as_ref());
        let (margin, bridge) = joiner.across(a, b)?;
        joiner.within(a, (begins, 1.0 - margin), &mut path, HALVINGS)?;
        path.extend(bridge);
        begins = margin;
    }
    joiner.within(last.as_ref(), (begins, 1.0), &mut path, HALVINGS)?;
    path.dedup();
    Some(path)
}

struct Joiner<'a> {
    scene: &'a Scene,
    /// So many bridges are still tried.
    left: Cell<usize>,
}

impl Joiner<'_> {
    fn is_free(&self, from: Coords, to: Coords) -> bool {
        let ends = self.scene.clearance(from).min(self.scene.clearance(to));
        ends > 0.0 && self.scene.is_clearly_apart(from, to, KEPT * ends)
    }

    /// From near the end of one piece to near the start of the next: how near, and the configurations up to there.
    fn across(&self, a: &dyn Piece, b: &dyn Piece) -> Option<(f64, Vec<Coords>)> {
        let mut margin = 0.5;
        for _ in 0..HALVINGS {
            if let Some(bridge) = self.bridge((a, 1.0 - margin), (b, margin)) {
                return Some((margin, bridge));
            }
            margin *= 0.5;
        }
        None
    }

    /// From one place to another, down to some height, across, and up again.
    fn bridge(&self, (a, s): (&dyn Piece, f64), (b, t): (&dyn Piece, f64)) -> Option<Vec<Coords>> {
        self.left.set(self.left.get().checked_sub(1)?);
        let (from, to) = (a.at(s), b.at(t));
        HEIGHTS.iter().find_map(|&height| {
            let way = [from.at(1.0), from.at(height), to.at(height), to.at(1.0)];
            let free = (way.windows(2)).all(|leg| leg[0] == leg[1] || self.is_free(leg[0], leg[1]));
            free.then(|| way[1..].to_vec())
        })
    }

    /// Adds the way along a piece between two places; it is at the first of them.
    fn within(
        &self,
        piece: &dyn Piece,
        (s, t): (f64, f64),
        path: &mut Vec<Coords>,
        left: u32,
    ) -> Option<()> {
        if s == t {
            return Some(());
        }
        if let Some(bridge) = self.bridge((piece, s), (piece, t)) {
            path.extend(bridge);
            return Some(());
        }
        let middle = 0.5 * (s + t);
        if left == 0 || self.left.get() == 0 || middle == s || middle == t {
            return None;
        }
        self.within(piece, (s, middle), path, left - 1)?;
        self.within(piece, (middle, t), path, left - 1)
    }
}

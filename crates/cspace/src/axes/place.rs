//! Pieces in every turn of y, cut to the limits of motion.

use core::f64::consts::TAU;

use super::build::Builder;
use super::domain::{ExtentKind, brought_between};
use super::names::{Key, Name};
use super::piece::{End, Pair, Piece};

impl Builder<'_> {
    /// The piece in every turn of y, cut to the limits of both coordinates.
    pub(super) fn in_each_turn(&mut self, piece: Piece) {
        let y = self.scene.y;
        let (lo, hi) = piece.y_range();
        let (first, last) = match y.kind {
            ExtentKind::Circle => {
                let k = -((lo - y.lo) / TAU).floor() as i32;
                (k, k)
            }
            ExtentKind::TurnLimits => (
                ((y.lo - hi) / TAU).ceil() as i32,
                ((y.hi - lo) / TAU).floor() as i32,
            ),
            _ => (0, 0),
        };
        for k in first..=last {
            let mut piece = piece;
            piece.turns += k;
            for end in [&mut piece.start, &mut piece.end] {
                end.turns += k;
                end.key.y_turn = if y.is_circle() { 0 } else { end.turns };
            }
            if let Some(piece) = self.limited(piece) {
                self.pieces.push(piece);
            }
        }
    }

    /// The piece cut to the limits of x and y.
    fn limited(&self, mut piece: Piece) -> Option<Piece> {
        let (x, y) = (self.scene.x, self.scene.y);
        let limit = |x: f64, base: f64| End {
            key: Key {
                name: Name::Limit,
                root: 0,
                x_turn: 0,
                y_turn: 0,
            },
            x,
            base,
            turns: 0,
        };
        let limited_x = matches!(x.kind, ExtentKind::TurnLimits | ExtentKind::SlideLimits);
        if limited_x {
            let (x0, x1) = piece.x_range();
            if x1 <= x.lo || x0 >= x.hi {
                return None;
            }
            if !piece.vertical {
                // A monotone piece stays between its ends, however steep it is: rounding at a pole may lead far beyond.
                let (lowest, highest) = piece.y_range();
                let at = |x: f64| brought_between(piece.y(&self.pairs, x), lowest, highest);
                let (from, to) = (at(x.lo), at(x.hi));
                if x0 < x.lo {
                    piece.start = limit(x.lo, from);
                }
                if x1 > x.hi {
                    piece.end = limit(x.hi, to);
                }
            }
        }
        if matches!(y.kind, ExtentKind::TurnLimits | ExtentKind::SlideLimits) {
            let (lo, hi) = piece.y_range();
            if hi <= y.lo || lo >= y.hi {
                return None;
            }
            for (at, outside) in [(y.lo, lo < y.lo), (y.hi, hi > y.hi)] {
                if outside {
                    let x = if piece.vertical {
                        piece.start.x
                    } else {
                        crossing_of_level(&piece, &self.pairs, at)
                    };
                    let end = limit(x, at);
                    let start_outside = (piece.start.y() < at) == (at == y.lo);
                    if start_outside {
                        piece.start = end;
                    } else {
                        piece.end = end;
                    }
                }
            }
        }
        Some(piece)
    }
}

/// The x at which a monotone piece has a given y.
pub(super) fn crossing_of_level(piece: &Piece, pairs: &[Pair], level: f64) -> f64 {
    let (mut lo, mut hi) = piece.x_range();
    let rising = piece.start.y() < piece.end.y();
    loop {
        let middle = 0.5 * (lo + hi);
        if middle <= lo || middle >= hi {
            return middle;
        }
        if (piece.y(pairs, middle) < level) == rising {
            lo = middle;
        } else {
            hi = middle;
        }
    }
}

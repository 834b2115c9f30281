//! Places pieces in every turn of y, cut to the limits of motion.

use super::build::Builder;
use super::condition::Condition;
use super::motion::{ExtentKind, brought_between};
use super::piece::{End, Key, Name, Pair, Piece};
use super::scene::{Scene, Side};
use super::tolerance::INDEPENDENT;
use crate::contact::Cycle;
use crate::feature::Feature;
use crate::geometry::{Vector, wrap};
use crate::number::halved;
use core::f64::consts::TAU;

impl Builder<'_> {
    /// Adds the piece in every turn of y, cut to the limits of both coordinates.
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
                // A monotone piece stays between its ends, however steep it is: rounding near a pole may give values far beyond.
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
                        crossing_of_level(&piece, &self.pairs, piece.x_range(), at)
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

/// The x between two others at which a monotone piece has a given y.
pub(super) fn crossing_of_level(
    piece: &Piece,
    pairs: &[Pair],
    range: (f64, f64),
    level: f64,
) -> f64 {
    let rising = piece.start.y() < piece.end.y();
    let (lo, hi) = halved(range, 0.0, |x| (piece.y(pairs, x) < level) == rising);
    0.5 * (lo + hi)
}

// Selects the sections of a curve that are contact: those where both features contain the point and the normal.

/// Distance of a section's middle from the ends of its features (length, or radians) below which the test is not used: then the section on
/// the other side of the adjacent node decides.
const UNCLEAR: f64 = 1e-11;

/// Distance of the contact at (x, y) inside the extents of both features: negative outside.
pub(super) fn margin(scene: &Scene, pair: &Pair, x: f64, y: f64) -> f64 {
    let (a, b) = (
        scene.first_feature(pair.first),
        scene.second_feature(pair.second),
    );
    let motions = scene.motions;
    let turning = motions.first.turns() || motions.second.turns();
    let inside =
        |f: &Feature, angle: f64| 0.5 * (f.hi - f.lo) - wrap(angle - 0.5 * (f.lo + f.hi)).abs();
    let half_turn = core::f64::consts::PI;
    let Condition { first, second, .. } = &pair.condition;
    let (p, q) = pair.condition.moved(x, y);
    let n = p.between(&q);
    let of_first = match place(&p, &q, n) {
        Some(at) => between_ends(&scene.first, a, first, at),
        None if turning || !b.is_line() => inside(a, n.angle() - motions.first.angle(x)),
        None => f64::INFINITY,
    };
    let of_second = match place(&q, &p, -n) {
        Some(at) => between_ends(&scene.second, b, second, at),
        None if turning || !a.is_line() => {
            inside(b, n.angle() + half_turn - motions.second.angle(y))
        }
        None => f64::INFINITY,
    };
    of_first.min(of_second)
}

/// Coordinate of the contact along the tangent of a line or large arc, from the point by which it is written; n is K times its normal
/// there. `None` for a cycle written by its centre. Never on the far side of a circle.
///
/// On a circle the vector from one point to the other is (n / K − n₁) / λ₁. Its component along the tangent is (λ₂ t·d − t·n₂) / K.
fn place(own: &Cycle, other: &Cycle, n: Vector) -> Option<f64> {
    if own.is_centred() {
        return None;
    }
    if own.normal.dot(n) < 0.0 {
        return Some(f64::INFINITY);
    }
    let t = own.normal.left();
    let way = (other.through - own.through) * other.weight - other.normal;
    Some(t.dot(way) / own.total(other))
}

/// Distance of a place along the tangent of a line or large arc from its ends, positive inside.
fn between_ends(side: &Side, f: &Feature, own: &Cycle, at: f64) -> f64 {
    let t = own.normal.left();
    let place = |joint: u32| t.dot(side.point(joint) - own.through);
    (at - place(f.start)).min(place(f.end) - at)
}

/// Decides which sections are contact: by their margins, and where those are unclear by the adjacent section.
pub(super) fn decide(margins: &[f64], ends: impl Fn(usize) -> bool) -> Vec<bool> {
    let n = margins.len();
    let mut verdicts: Vec<Option<bool>> = margins
        .iter()
        .map(|&m| (m.abs() > UNCLEAR).then_some(m > 0.0))
        .collect();
    for i in 1..n {
        if verdicts[i].is_none() {
            verdicts[i] = verdicts[i - 1].map(|before| before != ends(i));
        }
    }
    for i in (0..n.saturating_sub(1)).rev() {
        if verdicts[i].is_none() {
            verdicts[i] = verdicts[i + 1].map(|after| after != ends(i + 1));
        }
    }
    // A curve without nodes that runs permanently along a joint of both parts (discs that slide along their line of centres) belongs to the
    // features on either side of it; one of them is enough, more do no harm.
    verdicts
        .iter()
        .zip(margins)
        .map(|(v, m)| v.unwrap_or(n == 1 && *m > -INDEPENDENT))
        .collect()
}

//! The configuration of a contact curve that is nearest to a given one, in a metric in which turning by a radian counts as a length.
//!
//! Along a branch x and y are monotone functions of each other, so its part between two places is in the box of these. The square of the
//! distance from (x₀, y₀) has half the gradient d = (wₓ² (x − x₀), w_y² (y − y₀)), and along the curve f = 0 it increases or decreases
//! according to the sign of S = d × ∇f: over a box in which S has no zero, only the ends of the part count. Remaining parts are halved
//! (`number/least.rs`).

use crate::geometry::images;
use crate::ids::PatchId;
use crate::number::{Ball, Bounded, Real, least};

use super::motion::{Extent, Motion, brought_between};
use super::piece::Piece;
use super::space::FixedAxesSpace;
use super::tolerance::NEAR;

/// A place (x, y), and its distance from the given configuration (length of the pair's frame).
type Found = ((f64, f64), f64);

impl FixedAxesSpace {
    /// The configuration of a patch that is nearest to (u, v), and its distance in the model's unit of length, where turning by a radian
    /// counts as `length_per_radian`. Coordinates of parts that turn without limits are taken modulo a turn: the result has the images
    /// nearest to the given ones.
    ///
    /// `None` if there is no such patch, a part that does not move is not at 0, or the patch is not nearer than `known`.
    pub(crate) fn project(
        &self,
        (u, v): (f64, f64),
        patch: PatchId,
        length_per_radian: f64,
        known: f64,
    ) -> Option<((f64, f64), f64)> {
        let (x, y) = self.setting.map.inner(u, v);
        let scale = self.setting.map.frame.scale;
        let weight = |motion: Motion, t: f64| match motion {
            Motion::Turn { .. } => Some(length_per_radian * scale),
            Motion::Slide { .. } => Some(1.0),
            Motion::Still => (t == 0.0).then_some(0.0),
        };
        let weights = (
            weight(self.setting.motions.first, x)?,
            weight(self.setting.motions.second, y)?,
        );
        let known = known * scale;
        let mut best: Found = ((x, y), known);
        for branch in self.data.patches.get(patch.index())?.branches.clone() {
            let cell = self.data.branches[branch as usize].cell;
            if let Some(share) = self.setting.on_one_line() {
                let found = self.foot_on_line(cell, share, (x, y));
                best = if found.1 < best.1 { found } else { best };
                continue;
            }
            let (x_range, y_range) = self.graphs().cell_box(cell);
            for s in seen(&self.setting.x, x, x_range) {
                for t in seen(&self.setting.y, y, y_range) {
                    if let Some(((a, b), distance)) = self.nearest_on(cell, (s, t), weights, best.1)
                    {
                        best = ((a + (x - s), b + (y - t)), distance);
                    }
                }
            }
        }
        let (a, b) = best.0;
        (best.1 < known).then(|| (self.setting.outer(a, b), best.1 / scale))
    }

    /// The nearest place of a cell, if it is nearer than the known distance.
    fn nearest_on(
        &self,
        cell: u32,
        from: (f64, f64),
        weights: (f64, f64),
        known: f64,
    ) -> Option<Found> {
        let (c, piece) = self.graphs().cell(cell);
        let search = Search {
            space: self,
            piece,
            from,
            weights,
        };
        if piece.vertical {
            let at = (piece.start.x, brought_between(from.1, c.from, c.to));
            let distance = search.distance(at);
            return (distance < known).then_some((at, distance));
        }
        let (t, distance) = least(&search, (c.from, c.to), known)?;
        Some(((t, search.y(t)), distance))
    }

    /// The foot on a cell of parts that slide along one line without limits: the cell lies on the line y = c + `share` x.
    fn foot_on_line(&self, cell: u32, share: f64, (x, y): (f64, f64)) -> Found {
        let (c, piece) = self.graphs().cell(cell);
        let above = y - share * x - (piece.y(&self.pairs, c.from) - share * c.from);
        let by = above / (1.0 + share * share);
        let foot = (x + share * by, y - by);
        (foot, (share * by).hypot(by))
    }
}

/// The images of a coordinate within half a turn of a range; only the value itself, if the ends of its extent are not one place.
fn seen(extent: &Extent, t: f64, range: (f64, f64)) -> Vec<f64> {
    if extent.is_circle() {
        images(t, range).collect()
    } else {
        vec![t]
    }
}

/// A graph y(x), as seen from a place.
struct Search<'a> {
    space: &'a FixedAxesSpace,
    piece: &'a Piece,
    from: (f64, f64),
    /// Lengths that a unit of x and of y counts (length of the pair's frame).
    weights: (f64, f64),
}

impl Search<'_> {
    fn y(&self, x: f64) -> f64 {
        self.piece.y(&self.space.pairs, x)
    }

    fn distance(&self, (x, y): (f64, f64)) -> f64 {
        (self.weights.0 * (x - self.from.0)).hypot(self.weights.1 * (y - self.from.1))
    }
}

impl Bounded for Search<'_> {
    fn at(&self, x: f64) -> f64 {
        self.distance((x, self.y(x)))
    }

    fn below(&self, lo: f64, hi: f64) -> f64 {
        let mid = 0.5 * (lo + hi);
        let (start, middle, end) = (self.y(lo), self.y(mid), self.y(hi));
        let (low, high) = (start.min(end) - NEAR, start.max(end) + NEAR);
        let (x, y) = (Ball::between(lo, hi), Ball::between(low, high));
        let condition = &self.space.pairs[self.piece.pair as usize].condition;
        let (a, b) = condition.moved(x, y);
        let (by_x, by_y) = condition.slopes(&a, &b);
        let pull = |t: Ball, from: f64, weight: f64| {
            (t - Ball::constant(from)) * Ball::constant(weight) * Ball::constant(weight)
        };
        let (across, up) = (
            pull(x, self.from.0, self.weights.0),
            pull(y, self.from.1, self.weights.1),
        );
        let rate = across * by_y - up * by_x;
        if rate.sign() != 0 {
            return f64::INFINITY;
        }
        let direct = self.distance((
            brought_between(self.from.0, lo, hi),
            brought_between(self.from.1, low, high),
        ));
        // The square changes by 2 S / f_y along x, and by 2 S / f_x along y.
        let least = |by: Ball| (by.mid.abs() - by.radius).max(0.0);
        let tall = (middle - low).max(high - middle);
        let way = (0.5 * (hi - lo) / least(by_y)).min(tall / least(by_x));
        let change = 2.0 * (rate.mid.abs() + rate.radius) * way;
        let square = self.distance((mid, middle)).powi(2) - change;
        direct.max(square.max(0.0).sqrt())
    }
}

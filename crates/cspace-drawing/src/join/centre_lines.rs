//! Centre lines of circles, which are no outline.
//!
//! A straight open chain is left out without being asked where it goes through the centre of a circle, or of half of one or more, of a closed
//! outline, and ends a little beyond that circle, or a little beyond the outline around it: an outline that went there would cross the
//! circle. Neither end lies on an outline. What another line is cannot be told: a dimension's, or a side of an outline that is not finished.

use cspace::Point;
use cspace::part::Bounds;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::joined::{Chain, ChainPiece};
use super::pieces::Shape;
use crate::drawing::edge;

/// A centre line goes beyond the centre by this share of the radius at least, on both sides.
const LEAST: f64 = 0.1;
/// Radii of a circle within which its own centre line ends,
const OWN: f64 = 3.0;
/// and the share of the box of the outline around it by which a part's goes beyond that.
const OUTSIDE: f64 = 0.25;
/// Arcs whose sweep is at least this have a centre line.
const SWEEP: f64 = 0.99 * core::f64::consts::PI;

/// Why a centre line is left out.
pub(crate) const CENTRE_LINE: &str = "it is a centre line: it goes through the centre of a circle";

/// A circle or an arc of a closed outline: its radius, and the box of the largest outline around it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Round {
    radius: f64,
    around: Bounds,
}

/// The circles of closed outlines, by their centres, and all pieces of these.
pub(super) struct Centres<'l> {
    rounds: RTree<GeomWithData<[f64; 2], Round>>,
    pieces: RTree<GeomWithData<Rectangle<[f64; 2]>, &'l ChainPiece<'l>>>,
    /// Points nearer than this are one.
    reach: f64,
}

impl<'l> Centres<'l> {
    pub(super) fn of(loops: &'l [Chain<'l>], reach: f64) -> Self {
        let boxes: Vec<Bounds> = loops.iter().map(Chain::bounds).collect();
        let tree = RTree::bulk_load(boxes.iter().map(|b| boxed(*b, *b)).collect());
        let round = |(l, piece): (usize, &ChainPiece<'_>)| match piece.shape {
            Shape::Edge(bulge) if bulge != 0.0 => {
                let arc = edge(piece.start, piece.end, bulge);
                if arc.is_line() || arc.sweep().abs() < SWEEP {
                    return None;
                }
                let own = boxes[l];
                let holding = tree.locate_in_envelope_intersecting(envelope(own));
                let around = (holding.map(|b| b.data))
                    .filter(|b| b.contains(own.min) && b.contains(own.max))
                    .max_by(|a, b| a.diagonal().total_cmp(&b.diagonal()));
                let (at, radius) = (arc.center(), arc.radius().abs());
                let around = around.unwrap_or(own);
                Some(GeomWithData::new([at.x, at.y], Round { radius, around }))
            }
            _ => None,
        };
        let all =
            || (loops.iter().enumerate()).flat_map(|(l, of)| of.pieces.iter().map(move |p| (l, p)));
        Self {
            rounds: RTree::bulk_load(all().filter_map(round).collect()),
            pieces: RTree::bulk_load(
                all()
                    .map(|(_, p)| boxed(p.shape.bounds(p.start, p.end), p))
                    .collect(),
            ),
            reach,
        }
    }

    /// Whether an open chain is a centre line.
    pub(super) fn has_line(&self, chain: &Chain<'_>) -> bool {
        let (Some(first), Some(last)) = (chain.pieces.first(), chain.pieces.last()) else {
            return false;
        };
        let (from, to) = (first.start, last.end);
        let length = from.distance(to);
        let travelled: Option<f64> = (chain.pieces.iter())
            .map(|p| matches!(p.shape, Shape::Edge(0.0)).then(|| p.start.distance(p.end)))
            .sum();
        let is_straight = travelled.is_some_and(|t| t <= length + self.reach);
        is_straight
            && length > 0.0
            && self.is_through_one(from, to)
            && ![from, to].iter().any(|&p| self.is_on_outline(p))
    }

    fn is_through_one(&self, from: Point, to: Point) -> bool {
        let length = from.distance(to);
        let along = (to - from) * (1.0 / length);
        // All centres that the line may go through are within half of its length of its middle.
        let middle = from.midpoint(to);
        let half = 0.5 * length;
        let near = (self.rounds).locate_within_distance([middle.x, middle.y], half * half);
        near.into_iter().any(|centre| {
            let [x, y] = *centre.geom();
            let Round { radius, around } = centre.data;
            let off = Point::new(x, y) - from;
            let (past, aside) = (off.dot(along), off.cross(along).abs());
            let beyond = [past, length - past];
            let is_own = || beyond.iter().all(|b| *b <= OWN * radius);
            let ends_outside = |p: Point| {
                let d = around.distance(p);
                d > 0.0 && d <= OUTSIDE * around.diagonal()
            };
            aside <= self.reach
                && beyond.iter().all(|b| *b >= LEAST * radius)
                && (is_own() || (ends_outside(from) && ends_outside(to)))
        })
    }

    /// Whether a point lies on a closed outline; of a curve, in its box.
    fn is_on_outline(&self, p: Point) -> bool {
        let r = self.reach;
        let here = AABB::from_corners([p.x - r, p.y - r], [p.x + r, p.y + r]);
        let mut near = self.pieces.locate_in_envelope_intersecting(here);
        near.any(|n| match n.data.shape {
            Shape::Curve(_) => true,
            Shape::Edge(bulge) => edge(n.data.start, n.data.end, bulge).distance(p) <= r,
        })
    }
}

fn corners(bounds: Bounds) -> [[f64; 2]; 2] {
    [bounds.min, bounds.max].map(|p| [p.x, p.y])
}

fn envelope(bounds: Bounds) -> AABB<[f64; 2]> {
    let [lo, hi] = corners(bounds);
    AABB::from_corners(lo, hi)
}

fn boxed<T>(bounds: Bounds, data: T) -> GeomWithData<Rectangle<[f64; 2]>, T> {
    let [lo, hi] = corners(bounds);
    GeomWithData::new(Rectangle::from_corners(lo, hi), data)
}

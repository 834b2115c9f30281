//! Centre lines of circles, which are no outline.
//!
//! A straight open chain is left out without being asked where it goes through the centre of a circle, or of half of one or more, of a closed
//! outline: an outline that went there would cross the circle. What a line is that goes through no centre cannot be told: a dimension's,
//! or a side of an outline that is not finished.

use cspace::Point;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::joined::{Chain, ChainPiece};
use super::pieces::Shape;
use crate::drawing::edge;

/// A centre line goes beyond the centre by this share of the radius at least, on both sides.
const BEYOND: f64 = 0.1;
/// Arcs whose sweep is at least this have a centre line.
const SWEEP: f64 = 0.99 * core::f64::consts::PI;

/// Why a centre line is left out.
pub(crate) const CENTRE_LINE: &str = "it is a centre line: it goes through the centre of a circle";

/// The centres of circles of closed outlines, each with its radius.
pub(super) struct Centres {
    tree: RTree<GeomWithData<[f64; 2], f64>>,
    /// Points nearer than this are one.
    reach: f64,
}

impl Centres {
    pub(super) fn of(loops: &[Chain<'_>], reach: f64) -> Self {
        let centre = |piece: &ChainPiece<'_>| match piece.shape {
            Shape::Edge(bulge) if bulge != 0.0 => {
                let arc = edge(piece.start, piece.end, bulge);
                let is_round = !arc.is_line() && arc.sweep().abs() >= SWEEP;
                let at = arc.center();
                is_round.then(|| GeomWithData::new([at.x, at.y], arc.radius().abs()))
            }
            _ => None,
        };
        let all = loops.iter().flat_map(|l| &l.pieces).filter_map(centre);
        Self {
            tree: RTree::bulk_load(all.collect()),
            reach,
        }
    }

    /// Whether an open chain is a line through a centre.
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
        is_straight && length > 0.0 && self.is_through_one(from, to)
    }

    fn is_through_one(&self, from: Point, to: Point) -> bool {
        let length = from.distance(to);
        let along = (to - from) * (1.0 / length);
        // All centres that the line may go through are within half of its length of its middle.
        let middle = from.midpoint(to);
        let half = 0.5 * length;
        let near = (self.tree).locate_within_distance([middle.x, middle.y], half * half);
        near.into_iter().any(|centre| {
            let [x, y] = *centre.geom();
            let off = Point::new(x, y) - from;
            let (past, aside) = (off.dot(along), off.cross(along).abs());
            let beyond = BEYOND * centre.data;
            aside <= self.reach && past >= beyond && length - past >= beyond
        })
    }
}

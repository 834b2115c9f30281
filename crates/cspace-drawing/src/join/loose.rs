//! Straight lines that are no outline: centre lines, and the stubs of dimensions.
//!
//! An open chain is left out without being asked where no other reading is likely: it is straight, its ends are far from all other open
//! ends, it does not lie beside another one as the sides of a slot do, and at most one of its ends lies on a closed outline, which a line
//! between two of its places would divide.

use cspace::Point;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::joined::{Chain, ChainPiece};
use super::pieces::Shape;
use crate::drawing::edge;

/// Another open end nearer than this share of a line may be where it goes on: arcs between them may be missing.
const GOES_ON: f64 = 0.25;

/// Why a loose line is left out.
pub(crate) const LOOSE: &str = "it is a line by itself: no outline goes on at its ends";

/// The pieces of closed outlines, by the places where they are.
pub(super) struct Outlined<'l> {
    pieces: Vec<&'l ChainPiece<'l>>,
    tree: RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>,
    /// Points nearer than this are one.
    reach: f64,
}

impl<'l> Outlined<'l> {
    pub(super) fn of(loops: &'l [Chain<'l>], reach: f64) -> Self {
        let pieces: Vec<&ChainPiece<'_>> = loops.iter().flat_map(|l| &l.pieces).collect();
        let boxed = pieces.iter().enumerate().map(|(i, piece)| {
            let bounds = piece.shape.bounds(piece.start, piece.end);
            let [lo, hi] = [bounds.min, bounds.max].map(|p| [p.x, p.y]);
            GeomWithData::new(Rectangle::from_corners(lo, hi), i)
        });
        Self {
            tree: RTree::bulk_load(boxed.collect()),
            pieces,
            reach,
        }
    }

    /// Whether a point lies on a closed outline; of a curve, in its box.
    fn has(&self, p: Point) -> bool {
        let [lo, hi] = [-self.reach, self.reach].map(|r| [p.x + r, p.y + r]);
        let near = self
            .tree
            .locate_in_envelope_intersecting(AABB::from_corners(lo, hi));
        near.map(|n| self.pieces[n.data])
            .any(|piece| match piece.shape {
                Shape::Curve(_) => true,
                Shape::Edge(bulge) => edge(piece.start, piece.end, bulge).distance(p) <= self.reach,
            })
    }

    /// Whether an open chain is a loose line, where the nearest other open ends are so far from its own. `beside` are the ends of another
    /// chain, if both are of one.
    pub(super) fn leaves_out(
        &self,
        chain: &Chain<'_>,
        apart: f64,
        least: f64,
        beside: Option<[Point; 2]>,
    ) -> bool {
        let (Some(first), Some(last)) = (chain.pieces.first(), chain.pieces.last()) else {
            return false;
        };
        let (from, to) = (first.start, last.end);
        let length = from.distance(to);
        if beside.is_some_and(|ends| apart <= length && !cross([from, to], ends)) {
            return false;
        }
        !self.pieces.is_empty()
            && apart > least.max(GOES_ON * length)
            && self.is_straight(chain, length)
            && !(self.has(from) && self.has(to))
    }

    fn is_straight(&self, chain: &Chain<'_>, length: f64) -> bool {
        let mut travelled = 0.0;
        for piece in &chain.pieces {
            if !matches!(piece.shape, Shape::Edge(0.0)) {
                return false;
            }
            travelled += piece.start.distance(piece.end);
        }
        travelled <= length + self.reach
    }
}

/// Whether two lines between points cross.
fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let side = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

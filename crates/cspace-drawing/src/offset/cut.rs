//! Curves cut where they meet, and which of the pieces have the distance from all of the part.

use core::f64::consts::PI;

use cspace::part::Bounds;
use cspace::{Edge, Point, Vector};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::crossing::{crossings, onto};
use super::raw::Raw;

/// A piece of a curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    /// The number of the curve that it is a piece of.
    pub(super) raw: usize,
    /// Curve with that number.
    pub(super) whole: Edge,
    pub(super) curve: Edge,
}

/// Piece of a curve between two places on it.
///
/// Its sweep is twice the angle from the curve's direction at its start to its chord: as exact as the places are,
/// wherever they lie.
pub(super) fn between(whole: &Edge, start: Point, end: Point) -> Edge {
    if (start, end) == (whole.start, whole.end) {
        return *whole;
    }
    let mut piece = Edge {
        start,
        end,
        ..*whole
    };
    if !whole.is_line() {
        let normal = whole.start_direction().left() - (start - whole.start) * whole.curvature();
        let half = half_turn(whole, normal.right(), end - start);
        piece.bulge = whole.bulge.signum() * (half / 2.0).tan();
    }
    piece
}

/// Curves in a tree of boxes, by number.
struct Boxes(RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>);

impl Boxes {
    fn new<'e>(edges: impl Iterator<Item = &'e Edge>) -> Self {
        let boxed = |(i, e): (usize, &Edge)| {
            let b = e.bounds();
            let corners = [b.min, b.max].map(|p| [p.x, p.y]);
            GeomWithData::new(Rectangle::from_corners(corners[0], corners[1]), i)
        };
        Self(RTree::bulk_load(edges.enumerate().map(boxed).collect()))
    }

    /// The curves whose boxes come within a distance of a box.
    fn near(&self, b: Bounds, distance: f64) -> impl Iterator<Item = usize> {
        let around = AABB::from_corners(
            [b.min.x - distance, b.min.y - distance],
            [b.max.x + distance, b.max.y + distance],
        );
        self.0
            .locate_in_envelope_intersecting(around)
            .map(|r| r.data)
    }
}

/// The curves in pieces between the places at which they meet one another.
pub(super) fn cut(raw: &[Raw], near: f64) -> Vec<Piece> {
    let boxes = Boxes::new(raw.iter().map(|r| &r.curve));
    let mut pieces = Vec::with_capacity(raw.len());
    let mut cuts: Vec<(f64, Point)> = Vec::new();
    for (i, Raw { curve, .. }) in raw.iter().enumerate() {
        cuts.clear();
        for j in boxes.near(curve.bounds(), near).filter(|&j| j != i) {
            // Both curves of a pair are cut at one place, to the last bit.
            let (first, second) = (&raw[i.min(j)].curve, &raw[i.max(j)].curve);
            let other = &raw[j].curve;
            let ends = [other.start, other.end].into_iter();
            let ends = ends
                .filter(|&p| curve.distance(p) <= near)
                .map(|p| onto(curve, p));
            let places = ends.chain(crossings(first, second, near));
            let inner =
                places.filter(|p| p.distance(curve.start) > near && p.distance(curve.end) > near);
            cuts.extend(inner.map(|p| (fraction(curve, p), p)));
        }
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        cuts.push((1.0, curve.end));
        let mut start = curve.start;
        for &(_, end) in &cuts {
            // Places that are one are cut once.
            if end.distance(start) > near || cuts.len() == 1 {
                pieces.push(Piece {
                    raw: i,
                    whole: *curve,
                    curve: between(curve, start, end),
                });
                start = end;
            }
        }
    }
    pieces
}

/// The fraction of a curve's length at a place on it.
fn fraction(curve: &Edge, p: Point) -> f64 {
    let way = p - curve.start;
    if curve.is_line() {
        let chord = curve.end - curve.start;
        return way.dot(chord) / chord.length_squared();
    }
    2.0 * half_turn(curve, curve.start_direction(), way) / curve.sweep().abs()
}

/// Half the turn of an arc along a chord: the angle from its initial direction to the chord.
fn half_turn(arc: &Edge, from: Vector, way: Vector) -> f64 {
    let angle = (arc.bulge.signum() * from.cross(way)).atan2(from.dot(way));
    let angle = angle.rem_euclid(PI);
    // Rounding of a short way may turn it backwards.
    let whole = arc.sweep().abs() / 2.0;
    if angle > (whole + PI) / 2.0 {
        0.0
    } else {
        angle
    }
}

/// The pieces that are nowhere nearer than the distance to any edge of the part.
pub(super) fn outermost(pieces: Vec<Piece>, edges: &[Edge], least: f64) -> Vec<Piece> {
    let boxes = Boxes::new(edges.iter());
    let is_far = |piece: &Piece| {
        let middle = piece.curve.at(0.5);
        boxes
            .near(Bounds::of(middle, middle), least)
            .all(|i| edges[i].distance(middle) >= least)
    };
    pieces.into_iter().filter(is_far).collect()
}

//! The pieces of all paths of a drawing, and which ends are one.

use cspace::Point;
use cspace::part::Bounds;

use crate::curve::Curve;
use crate::drawing::{Drawing, Piece, edge};

/// Rounding of coordinates in files, as a share of the drawing's size: points nearer than that are one place.
pub(crate) const ROUND: f64 = 1e-9;

/// An end of a piece: twice its number, and one more for where it ends.
pub(super) type End = u32;

/// Shape of a piece between its two ends.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Shape<'d> {
    /// A line or an arc of this bulge.
    Edge(f64),
    /// A curve, from its start to its end.
    Curve(&'d Curve),
}

impl Shape<'_> {
    /// The box of the shape between its ends.
    pub(super) fn bounds(&self, start: Point, end: Point) -> Bounds {
        match self {
            Self::Edge(bulge) => edge(start, end, *bulge).bounds(),
            Self::Curve(curve) => curve.bounds().union(Bounds::of(start, end)),
        }
    }
}

/// A piece of a path.
#[derive(Debug, Clone)]
pub(super) struct Segment<'d> {
    /// Start and end.
    pub(super) ends: [Point; 2],
    pub(super) shape: Shape<'d>,
    /// The entity of the drawing that it belongs to.
    pub(super) entity: u32,
    pub(super) is_removed: bool,
    /// The ends that its own are joined to.
    pub(super) links: [Option<End>; 2],
}

/// All pieces.
pub(super) struct Pieces<'d> {
    pub(super) segments: Vec<Segment<'d>>,
}

/// The end of a piece at its start (0) or end (1).
pub(super) fn end(piece: usize, side: usize) -> End {
    (2 * piece + side) as End
}

/// The piece of an end, and which of the two it is.
pub(super) fn of_end(end: End) -> (usize, usize) {
    ((end / 2) as usize, (end % 2) as usize)
}

impl<'d> Pieces<'d> {
    /// The pieces of all paths, joined as they are in their paths. A path that should be closed and ends elsewhere, by
    /// rounding, is closed.
    pub(super) fn new(drawing: &'d Drawing, size: f64) -> Self {
        let count = drawing.entities.iter().map(|e| e.path.pieces.len()).sum();
        let mut segments: Vec<Segment<'d>> = Vec::with_capacity(count);
        for (entity, from) in drawing.entities.iter().enumerate() {
            let first = segments.len();
            let mut start = from.path.start;
            for piece in &from.path.pieces {
                let before = segments.len().checked_sub(1).filter(|&b| b >= first);
                let number = segments.len();
                if let Some(before) = before {
                    segments[before].links[1] = Some(end(number, 0));
                }
                segments.push(Segment {
                    ends: [start, piece.end()],
                    shape: match piece {
                        Piece::Edge { bulge, .. } => Shape::Edge(*bulge),
                        Piece::Curve(curve) => Shape::Curve(curve),
                    },
                    entity: entity as u32,
                    is_removed: false,
                    links: [before.map(|b| end(b, 1)), None],
                });
                start = piece.end();
            }
            let path = &from.path;
            let closes = path.closed || path.end() == path.start;
            if closes && segments.len() > first && path.end().distance(path.start) <= ROUND * size {
                let last = segments.len() - 1;
                segments[last].links[1] = Some(end(first, 0));
                segments[first].links[0] = Some(end(last, 1));
                if !matches!(segments[last].shape, Shape::Curve(_)) {
                    segments[last].ends[1] = path.start;
                }
            }
        }
        Self { segments }
    }

    /// Removes pieces of no extent, and loose ones shorter than the distance at which ends are joined; returns their
    /// number, and the extent of the largest that has one. The ends that were joined to them are joined.
    pub(super) fn remove_tiny(&mut self, none: f64, join: f64) -> (usize, f64) {
        let mut removed = 0;
        let mut largest: f64 = 0.0;
        for i in 0..self.segments.len() {
            let segment = &self.segments[i];
            let is_loose = segment.links == [None; 2];
            let is_loop = segment.links[0] == Some(end(i, 1));
            let least = if is_loose { join } else { none };
            // A drawn piece may return to its start.
            let [start, end] = segment.ends;
            let extent = segment.shape.bounds(start, end).diagonal();
            if extent > least || (is_loop && extent > none) {
                continue;
            }
            removed += 1;
            if extent > none {
                largest = largest.max(extent);
            }
            let [before, after] = segment.links;
            self.segments[i].is_removed = true;
            match (before, after) {
                (Some(b), Some(a)) if of_end(b).0 != i => {
                    self.link(b, a);
                    self.move_end(a, self.point(b));
                }
                _ => {
                    for other in [before, after].into_iter().flatten() {
                        self.unlink(other);
                    }
                }
            }
        }
        (removed, largest)
    }

    pub(super) fn point(&self, end: End) -> Point {
        let (piece, side) = of_end(end);
        self.segments[piece].ends[side]
    }

    pub(super) fn linked(&self, end: End) -> Option<End> {
        let (piece, side) = of_end(end);
        self.segments[piece].links[side]
    }

    /// Whether a piece is joined at both ends.
    pub(super) fn is_held(&self, piece: usize) -> bool {
        self.segments[piece].links.iter().all(Option::is_some)
    }

    pub(super) fn link(&mut self, a: End, b: End) {
        for (a, b) in [(a, b), (b, a)] {
            let (piece, side) = of_end(a);
            self.segments[piece].links[side] = Some(b);
        }
    }

    pub(super) fn unlink(&mut self, end: End) {
        let (piece, side) = of_end(end);
        self.segments[piece].links[side] = None;
    }

    pub(super) fn move_end(&mut self, end: End, to: Point) {
        let (piece, side) = of_end(end);
        self.segments[piece].ends[side] = to;
    }

    /// Makes a circle of an arc whose ends coincide; false if it is not an arc of more than half a turn.
    pub(super) fn close_circle(&mut self, piece: usize) -> bool {
        let Segment {
            ends: [start, end_point],
            shape,
            entity,
            ..
        } = self.segments[piece];
        let Shape::Edge(bulge) = shape else {
            return false;
        };
        let arc = edge(start, end_point, bulge);
        if arc.bulge.abs() <= 1.0 {
            return false;
        }
        // The middle of the arc, and the point of its circle opposite to it, between the ends.
        let (middle, center) = (arc.middle(), arc.center());
        let opposite = center + (center - middle);
        let other = self.segments.len();
        let half = |ends: [Point; 2], neighbour: usize| Segment {
            ends,
            shape: Shape::Edge(bulge.signum()),
            entity,
            is_removed: false,
            links: [Some(end(neighbour, 1)), Some(end(neighbour, 0))],
        };
        self.segments[piece] = half([opposite, middle], other);
        self.segments.push(half([middle, opposite], piece));
        true
    }

    /// Removes a piece; the ends that were joined to it are loose.
    pub(super) fn remove(&mut self, piece: usize) {
        self.segments[piece].is_removed = true;
        for side in 0..2 {
            if let Some(other) = self.segments[piece].links[side].take()
                && of_end(other).0 != piece
            {
                self.unlink(other);
            }
        }
    }
}

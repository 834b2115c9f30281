//! Results of joining the entities of a drawing.

use cspace::Point;
use cspace::part::Bounds;

use super::pieces::Shape;
use crate::drawing::{Drawing, Origin, Problem};

/// Pieces end to end; of a closed chain, the last ends where the first starts.
#[derive(Debug)]
pub(crate) struct Chain<'d> {
    /// The end at which it is begun, by number: no two chains of a drawing have one in common.
    pub(crate) first: u32,
    pub(crate) pieces: Vec<ChainPiece<'d>>,
}

/// A piece in the direction in which its chain is travelled.
#[derive(Debug, Clone)]
pub(crate) struct ChainPiece<'d> {
    pub(crate) start: Point,
    pub(crate) end: Point,
    /// The shape, as drawn.
    pub(crate) shape: Shape<'d>,
    /// Whether it is travelled from its end to its start.
    pub(crate) is_backward: bool,
    pub(crate) entity: u32,
}

impl Chain<'_> {
    /// The box of all pieces.
    pub(super) fn bounds(&self) -> Bounds {
        let boxes = self.pieces.iter().map(|p| p.shape.bounds(p.start, p.end));
        boxes.fold(Bounds::EMPTY, Bounds::union)
    }

    /// The diagonal of that box.
    pub(crate) fn size(&self) -> f64 {
        self.bounds().diagonal()
    }

    /// Whether the chain goes forth and back on the same path.
    pub(super) fn encloses_nothing(&self, round: f64) -> bool {
        match &self.pieces[..] {
            [one] => !matches!(one.shape, Shape::Curve(_)),
            [a, b] => match (a.shape, b.shape) {
                (Shape::Edge(x), Shape::Edge(y)) => {
                    (x + y).abs() * a.start.distance(a.end) <= round
                }
                _ => false,
            },
            _ => false,
        }
    }
}

/// Loops and open chains of a drawing, and the changes made to join them.
#[derive(Debug, Default)]
pub(crate) struct Joined<'d> {
    pub(crate) loops: Vec<Chain<'d>>,
    /// Chains that are not closed.
    pub(crate) open: Vec<Chain<'d>>,
    /// The gaps that were closed, wider than rounding, and where.
    pub(crate) gaps: Vec<(f64, Point)>,
    /// Number of pieces that were drawn twice, or lay within others.
    pub(crate) duplicates: usize,
    /// Number of pieces that overlapped others and were merged with them.
    pub(crate) merged: usize,
    /// Number of pieces without length, or shorter than the joining distance.
    pub(crate) tiny: usize,
    /// The extent of the largest of them, 0 if none has any.
    pub(crate) largest_removed: f64,
    /// The entities of chains that are not closed.
    pub(crate) unused: Vec<u32>,
    /// The entities of centre lines, which are among them.
    pub(crate) centre_lines: Vec<u32>,
    /// The distance at which joining ends closes all that is open, where all gaps are small.
    pub(crate) closes: Option<f64>,
    /// How many problems are small gaps.
    pub(crate) small: usize,
    /// Problems: chains that are not closed, and ends that may be joined in several ways.
    pub(crate) problems: Vec<Problem>,
}

/// Origin of an entity in the file.
pub(super) fn origin_of(drawing: &Drawing, entity: u32) -> &Origin {
    &drawing.entities[entity as usize].origin
}

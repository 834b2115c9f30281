//! Results of fitting.

use cspace::{Point, Vertex};

/// Lines and arcs fitted to a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fitted {
    /// The start of every piece, with its bulge; the end of an open run is not among them.
    pub(crate) vertices: Vec<Vertex>,
    /// Where an open run ends.
    pub(crate) end: Point,
    /// How far the samples are from the pieces, at most.
    pub(crate) deviation: f64,
    /// The largest angle between two pieces, in radians.
    pub(crate) kink: f64,
}

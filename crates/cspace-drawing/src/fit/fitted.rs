//! Results of fitting.

use cspace::{Point, Vertex};

/// Lines and arcs fitted to a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fitted {
    /// The start of every piece, with its bulge; the end of an open run is not among them.
    pub(crate) vertices: Vec<Vertex>,
    /// End of an open run.
    pub(crate) end: Point,
    /// Largest distance of the samples from the pieces.
    pub(crate) deviation: f64,
    /// The largest angle between two pieces, in radians.
    pub(crate) kink: f64,
}

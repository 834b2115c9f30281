//! Traces: loops of many short edges along something smooth, by fewer lines and arcs.

use cspace::part::Edge;
use cspace::{Loop, Part};

use super::settings::DEFAULT_FIT;
use crate::drawing::edge;
use crate::fit::{self, Outline, Sided};
use crate::join::{Chain, Shape};

/// A loop of fewer edges is no trace: it is drawn edge by edge.
const FEWEST: usize = 64;

/// Large parts by fewer lines and arcs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traced {
    /// Tolerance of the lines and arcs.
    pub fit: f64,
    /// Number of lines and arcs of the resulting part.
    pub pieces: usize,
    /// Largest distance of these from the edges.
    pub deviation: f64,
}

/// The edges of a chain, if it may be a trace.
pub(super) fn edges(chain: &Chain<'_>) -> Option<Vec<Edge>> {
    let edges: Option<Vec<Edge>> = (chain.pieces.iter())
        .map(|piece| match piece.shape {
            Shape::Edge(bulge) => Some(edge(piece.start, piece.end, bulge)),
            Shape::Curve(_) => None,
        })
        .collect();
    edges.filter(|e| e.len() >= FEWEST)
}

/// Lines and arcs within a distance of a trace; `entity` is where it comes from.
pub(super) fn outline(edges: &[Edge], fit: f64, sided: Sided, entity: u32) -> Option<Outline> {
    fit::trace(edges, fit, sided, entity)
}

impl Traced {
    /// Largest part, in edges, that is not examined.
    pub const LARGE: usize = 100;

    /// The lines and arcs of a part of more than [`Traced::LARGE`] lines, all loops that may be traces fitted: within what its
    /// chords are off the curve that they trace, or else within the smallest of a few distances, that takes at most a third of its
    /// edges. None of other parts, and of parts with arcs.
    pub fn of(part: &Part) -> Option<Self> {
        /// The other distances tried, in units of the default of a fit; the larger ones of very large parts alone.
        const TRIED: [f64; 4] = [1.0, 3.0, 10.0, 30.0];
        const VERY_LARGE: usize = 400;
        const ENOUGH: usize = 3;
        /// Tolerance as a multiple of what the chords are off a curve: the rest is for the pieces.
        const ROOM: f64 = 1.25;
        /// Within what the chords of more edges are off a curve, pieces are too many to be of use, and take too long to find.
        const MOST: usize = 20_000;
        let edges = part.edges().count();
        // Points that were traced are joined by lines: what has arcs was drawn, as a gear is with its many teeth.
        if edges <= Self::LARGE || part.edges().any(|e| !e.is_line()) {
            return None;
        }
        let count = if edges > VERY_LARGE { TRIED.len() } else { 1 };
        let unit = DEFAULT_FIT * part.size();
        let of_chords = sagitta(part).filter(|_| edges <= MOST).map(|s| ROOM * s);
        let others = TRIED.iter().take(count).map(|by| by * unit);
        (of_chords.into_iter().chain(others))
            .map(rounded)
            .find_map(|fit| Self::within(part, fit).filter(|t| t.pieces * ENOUGH <= edges))
    }

    fn within(part: &Part, fit: f64) -> Option<Self> {
        let mut traced = Self {
            fit,
            pieces: 0,
            deviation: 0.0,
        };
        for ring in part.loops() {
            let edges: Vec<Edge> = ring.edges().collect();
            if edges.len() < FEWEST {
                traced.pieces += edges.len();
                continue;
            }
            let outline = outline(&edges, fit, Sided::Both, 0)?;
            traced.pieces += outline.vertices.len();
            traced.deviation = traced.deviation.max(outline.deviation);
        }
        Some(traced)
    }
}

/// Error of the chords of a part from the curves that they trace: that of the loop with the largest. `None` if most corners of each are
/// sharp.
fn sagitta(part: &Part) -> Option<f64> {
    let of = |ring: &Loop| fit::sagitta(&ring.edges().collect::<Vec<Edge>>());
    part.loops().iter().filter_map(of).max_by(f64::total_cmp)
}

/// A length with two digits, rounded up.
fn rounded(length: f64) -> f64 {
    let unit = 10.0_f64.powf(length.log10().floor() - 1.0);
    let rounded = (length / unit).ceil() * unit;
    // The nearest number with few digits, and not a multiple of a power of ten that has its own rounding.
    format!("{rounded:.1e}").parse().unwrap_or(rounded)
}

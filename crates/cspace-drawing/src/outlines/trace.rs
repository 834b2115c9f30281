//! Traces: loops of many short edges along something smooth, by fewer lines and arcs.

use cspace::part::Edge;
use cspace::{Part, Point};

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
    fit::profile(&points(edges), fit, sided, entity)
}

/// Points of all edges, so that what passes them keeps to long edges too.
fn points(edges: &[Edge]) -> Vec<Point> {
    /// Length of an edge, as a multiple of the median, from which it is divided into short ones, but not into more than
    /// `MOST`.
    const LONG: f64 = 4.0;
    const MOST: f64 = 64.0;
    let mut lengths: Vec<f64> = edges.iter().map(Edge::length).collect();
    lengths.sort_by(f64::total_cmp);
    let long = LONG * lengths[lengths.len() / 2];
    let cut = |e: &Edge| {
        let bends = if e.is_line() { 1.0 } else { 2.0 };
        let n = (e.length() / long).ceil().clamp(bends, MOST) as u32;
        let e = *e;
        (0..n).map(move |k| e.at(f64::from(k) / f64::from(n)))
    };
    edges.iter().flat_map(cut).collect()
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
        /// Within what the chords of more edges are off a curve, pieces are too many to be of use, and take too long to find.
        const MOST: usize = 20_000;
        let edges = part.edges().count();
        // Points that were traced are joined by lines: what has arcs was drawn, as a gear is with its many teeth.
        if edges <= Self::LARGE || part.edges().any(|e| !e.is_line()) {
            return None;
        }
        let count = if edges > VERY_LARGE { TRIED.len() } else { 1 };
        let unit = DEFAULT_FIT * part.size();
        let of_chords = sagitta(part).filter(|_| edges <= MOST);
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

/// Error of the chords of a part from the curve that they trace: the largest sagitta but for a few. `None` if most of
/// its corners are sharp.
fn sagitta(part: &Part) -> Option<f64> {
    /// Largest turn at a corner of a trace, in radians: a circle has 13 chords then.
    const SMOOTH: f64 = 0.5;
    /// The share of sagittas that are no larger: at a corner that is drawn chords are longer than on the curves beside it.
    const SHARE: f64 = 0.9;
    let mut sagittas: Vec<f64> = Vec::new();
    let mut corners = 0;
    for ring in part.loops() {
        let edges: Vec<Edge> = ring.edges().collect();
        for (a, b) in edges.iter().zip(edges.iter().cycle().skip(1)) {
            let (d, e) = (a.end - a.start, b.end - b.start);
            let turn = d.cross(e).atan2(d.dot(e)).abs();
            corners += 1;
            if turn > 0.0 && turn < SMOOTH {
                // The chord of an arc of the angle φ has the sagitta c/2 · tan(φ/4).
                sagittas.push(0.5 * a.length().min(b.length()) * (0.25 * turn).tan());
            }
        }
    }
    if 2 * sagittas.len() < corners {
        return None;
    }
    sagittas.sort_by(f64::total_cmp);
    let at = (SHARE * sagittas.len() as f64) as usize;
    sagittas
        .get(at.min(sagittas.len().saturating_sub(1)))
        .copied()
}

/// A length with one digit, as people give it.
fn rounded(length: f64) -> f64 {
    let unit = 10.0_f64.powf(length.log10().floor());
    let rounded = (length / unit).round() * unit;
    // The nearest number with few digits, and not a multiple of a power of ten that has its own rounding.
    format!("{rounded:.0e}").parse().unwrap_or(rounded)
}

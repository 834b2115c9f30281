//! Loops from loose pieces.
//!
//! All paths are taken apart into pieces that know their neighbours ([`pieces`]). Pieces that are drawn twice or overlap are
//! merged ([`overlaps`]), ends that nearly meet are joined, the nearest first ([`ends`]), and what is then closed is a loop
//! ([`chains`]).

mod chains;
mod ends;
mod overlaps;
mod pieces;

use cspace::Point;

pub(crate) use chains::{Chain, ChainPiece};
pub(crate) use pieces::Shape;

use crate::drawing::{Drawing, Origin, Problem};
use pieces::Pieces;

/// Rounding of coordinates in files, as a share of the drawing's size: what is nearer than that is one place.
pub(crate) const ROUND: f64 = 1e-9;

/// What was done to make loops of a drawing.
#[derive(Debug, Default)]
pub(crate) struct Joined<'d> {
    pub(crate) loops: Vec<Chain<'d>>,
    /// The gaps that were closed, wider than rounding, and where.
    pub(crate) gaps: Vec<(f64, Point)>,
    /// How many pieces were drawn twice, or lay within others.
    pub(crate) duplicates: usize,
    /// How many pieces overlapped others and were made one with them.
    pub(crate) merged: usize,
    /// How many pieces had no length, or less than would be joined.
    pub(crate) tiny: usize,
    /// The entities of chains that are not closed.
    pub(crate) unused: Vec<u32>,
    /// Chains that are not closed, and ends that may be joined in several ways.
    pub(crate) problems: Vec<Problem>,
}

/// The loops of a drawing. Ends at most `join` apart are one.
pub(crate) fn join(drawing: &Drawing, size: f64, join: f64) -> Joined<'_> {
    let mut joined = Joined::default();
    let mut pieces = Pieces::new(drawing, size);
    joined.tiny = pieces.remove_tiny(ROUND * size, join);
    // A profile that is measured may touch itself by its scatter.
    if !drawing.is_measured {
        overlaps::merge(&mut pieces, ROUND * size, &mut joined);
    }
    let ambiguous = ends::join(&mut pieces, drawing, ROUND * size, join, &mut joined);
    chains::collect(&pieces, drawing, &ambiguous, ROUND * size, &mut joined);
    joined
}

fn origin_of(drawing: &Drawing, entity: u32) -> &Origin {
    &drawing.entities[entity as usize].origin
}

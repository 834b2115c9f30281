//! Joining of loose pieces to loops.
//!
//! All paths are divided into pieces that know their neighbours ([`pieces`]). Pieces that are drawn twice or overlap
//! are merged ([`overlaps`]), ends that nearly meet are joined, the nearest first ([`ends`]), and closed chains become
//! loops ([`chains`]). If a piece is missing that another layer has, this is reported ([`bridges`]).

mod bridges;
mod centre_lines;
mod chains;
mod ends;
mod joined;

mod overlaps;
mod paths;
mod pieces;

pub(crate) use centre_lines::CENTRE_LINE;
pub(crate) use joined::{Chain, ChainPiece, Joined};
pub(crate) use pieces::{ROUND, Shape};

use crate::drawing::Drawing;
use pieces::Pieces;

/// The loops of a drawing. Ends at most `join` apart are one.
pub(crate) fn join(drawing: &Drawing, size: f64, join: f64) -> Joined<'_> {
    let mut joined = Joined::default();
    let mut pieces = Pieces::new(drawing, size);
    (joined.tiny, joined.largest_removed) = pieces.remove_tiny(ROUND * size, join);
    // A profile that is measured may touch itself by its scatter.
    if !drawing.is_measured {
        overlaps::merge(&mut pieces, ROUND * size, &mut joined);
    }
    let ambiguous = ends::join(&mut pieces, drawing, ROUND * size, join, &mut joined);
    chains::collect(
        &pieces,
        drawing,
        &ambiguous,
        [ROUND * size, join],
        &mut joined,
    );
    joined
}

//! The tolerances and limits of pairs on fixed axes that more than one step uses, each with its unit and reason.
//!
//! Lengths are in units of the pair's frame, in which both parts fit the unit disc. Bounds that one step alone uses stand there.

use crate::feature::tolerance::SAME_CARRIER;

/// The largest product of the parts' numbers of edges. Each pair of features is looked at, if only for whether it can touch:
/// about a minute.
pub(super) const MOST_EDGE_PAIRS: usize = 1 << 26;

/// The most meetings of two contact curves' boxes: a tenth of a gigabyte, and where all of them cross and make cells of their
/// own one gigabyte, and a minute.
pub(super) const MOST_MEETINGS: usize = 1 << 23;

/// Lengths, and sines of angles, below this do not matter: a condition that depends no more than this on a coordinate is
/// independent of it (a cam's arc about its own pivot). An eighth of what the fixed part is grown by.
pub(super) const INDEPENDENT: f64 = SAME_CARRIER;

/// How far a contact within the resolution may lie outside a cell's box: rounding of a root, and of crossings (radians or
/// length of the frame).
pub(super) const NEAR: f64 = 1e-9;

/// A section shorter than this (in x, radians or length) is not tested: near a turning y moves with the square root of x, and
/// so does its rounding.
pub(super) const SHORT: f64 = 1e-13;

/// Curves nearer to each other than this that face the same way are one, and what lies between them tells nothing (radians or
/// length of the frame): about what the first part is grown by.
pub(super) const COINCIDENT: f64 = 1e-11;

//! Tolerances and limits of pairs on fixed axes that more than one step uses, each with its unit and reason.
//!
//! Lengths are in units of the pair's frame, in which both parts fit the unit disc. Bounds used by a single step are defined there.

use crate::feature::tolerance::NEGLIGIBLE;

/// The largest product of the parts' numbers of edges. Each pair of features is examined, at least for whether it can touch: about a
/// minute.
pub(super) const MOST_EDGE_PAIRS: usize = 1 << 26;

/// The most meetings of two contact curves' boxes: a tenth of a gigabyte; and if all of them cross and make cells of their own, one
/// gigabyte and a minute.
pub(super) const MOST_MEETINGS: usize = 1 << 23;

/// Length, or sine of an angle, that is negligible: a condition that depends no more than this on a coordinate is independent of it (a
/// cam's arc about its own pivot). Outlines are grown here, and not perturbed.
pub(super) const INDEPENDENT: f64 = NEGLIGIBLE;

/// Distance by which a contact within the resolution may lie outside a cell's box: rounding of a root, and of crossings (radians or length
/// of the frame).
pub(super) const NEAR: f64 = 1e-9;

/// Length of a section (in x, radians or length) below which it is not tested: near a turning y moves with the square root of x, and so
/// does its rounding.
pub(super) const SHORT: f64 = 1e-13;

/// Distance of curves that face the same way below which they are one, and the space between them decides nothing (radians or length of the
/// frame): about the first part's growth.
pub(super) const COINCIDENT: f64 = 1e-11;

/// How much more a layer of the fixed part is grown than the one before it, and a layer of the moving part in these steps for every layer of
/// the fixed one (length of the frame): of flush sides one covers the other, and their curves are not one.
pub(super) const LAYER_APART: f64 = 8.0 * COINCIDENT;

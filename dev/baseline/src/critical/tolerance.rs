//! Tolerances of the search. Lengths are shares of the pair's size.
//!
//! All of them err on the same side: solutions within a tolerance count as realisable, so that superfluous orientations
//! are found rather than any missed.

/// Edges that meet at less than this angle (radians) are joined smoothly: as the library has it.
pub(super) const SMOOTH: f64 = 1.5e-8;

/// Orientations nearer than this (radians) are the same. Where two contacts become tangent, or a feature ends just beyond, an
/// orientation is known to some of [`BEYOND`] only, and to the square root of the rounding.
pub(super) const SAME: f64 = 4e-6;

/// Largest distance beyond its ends (a length, or radians of normals and orientations) at which a contact is still a
/// contact.
pub(super) const BEYOND: f64 = 1e-6;

/// Parts that overlap less deeply than this touch.
pub(super) const DEPTH: f64 = 1e-6;

/// A polynomial whose Bernstein coefficients are all below this is zero; its coefficients are of order one, and their rounding is
/// some units of 1e-15.
pub(super) const ZERO: f64 = 1e-13;

/// Sine of the angle between two carriers that is too small to cross them.
pub(super) const PARALLEL: f64 = 1e-7;

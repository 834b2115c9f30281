//! Slices: the boundary of free space at one orientation, computed from nothing but the two parts.
//!
//! ```text
//!      blocked   ╲   ╱  blocked          Contact curves of a pair at one orientation: blocked space on
//!   ───────────→──╳───→──────            the left of travel. They cross (╳) and are cut there into gaps
//!                ╱ ╲                     (`cut.rs`); a gap is on the boundary of free space as a whole
//!      free     ╱   ╲   blocked          or not at all, and gaps hang together in shells (`arrange.rs`).
//! ```
//!
//! Slices are computed in doubles, and independently of the contact space: each is a test of it. What doubles leave open is
//! decided by testing the parts for overlap beside a gap, or a slice says that it is doubtful. `curve_geometry.rs` and
//! `boundary.rs` have what the user sees.

mod arrange;
mod boundary;
mod coincident;
mod curve_geometry;
mod cut;
mod slicer;

pub use boundary::{Slice, SliceCurve};
pub use curve_geometry::CurveGeometry;
pub(crate) use curve_geometry::is_on_arc;
pub use slicer::Slicer;

#[cfg(test)]
mod tests;

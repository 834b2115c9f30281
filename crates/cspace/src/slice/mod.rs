//! Slices for users: the boundary of free space at one orientation.
//!
//! ```text
//!      blocked   ╲   ╱  blocked          The curves of a slice are pieces of contact curves, with blocked space on
//!   ───────────→──╳                      the left of travel and free space on the right. Where two of them
//!                ╱                       cross (╳) the boundary goes over from one to the other, and it comes
//!      free     ╱       blocked          back to where it began: `boundary.rs` has the loops.
//! ```
//!
//! `curve_geometry.rs` has the curves. Slices are made from patches (`space/slice.rs`): those of a contact space, or those that the general
//! method finds about one orientation (`general/slicer.rs`).

mod boundary;
mod curve_geometry;

pub use boundary::{Slice, SliceCurve};
pub use curve_geometry::CurveGeometry;
pub(crate) use curve_geometry::is_on_arc;

#[cfg(test)]
mod tests;

//! One slice of the contact space, computed from nothing but the two parts at one orientation.

mod arrange;
mod coincident;
mod cut;
mod slicer;
mod span;
mod types;

pub use slicer::Slicer;
pub(crate) use types::is_on_arc;
pub use types::{CurveGeometry, Slice, SliceCurve};

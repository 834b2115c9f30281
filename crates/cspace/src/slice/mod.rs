//! One slice of the contact space, computed from nothing but the two parts at one orientation.

mod arrange;
mod types;

pub use types::{CurveGeometry, Slice, SliceCurve};

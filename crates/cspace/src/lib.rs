//! Exact configuration spaces of planar parts bounded by line segments and circular arcs.

pub(crate) mod contact;
pub(crate) mod feature;
pub mod geometry;
pub mod part;
pub mod slice;
mod union_find;

pub use feature::{FeatureKind, FeatureName};
pub use geometry::{Configuration, Point, Rotation, Vector};
pub use part::{Edge, Loop, Part, PartError, Vertex};
pub use slice::{CurveGeometry, Slice, SliceCurve};

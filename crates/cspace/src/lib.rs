//! Exact configuration spaces of planar parts bounded by line segments and circular arcs.
//!
//! # Cargo features
//!
//! Both are on unless `default-features = false` is given.
//!
//! - `serde`: what is public and plain data can be written and read by `serde`, such as a
//!   [`SavedSpace`](space::SavedSpace).
//! - `rayon`: work is divided among the threads of the `rayon` pool from which it is called. Without it one thread, the
//!   caller's, does all of it. Results are the same with any number of threads.

// It reads no files and prints nothing.
#![warn(clippy::print_stdout, clippy::print_stderr)]

mod boxes;
pub(crate) mod contact;
pub(crate) mod feature;
pub mod fixed_axes;
#[cfg(feature = "fuzzing")]
#[doc(hidden)]
pub mod fuzzing;
pub(crate) mod general;
pub mod geometry;
pub(crate) mod number;
pub mod pair;
pub(crate) mod parallel;
pub mod part;
pub mod query;
pub mod slice;
pub mod space;
mod union_find;

pub use contact::{
    ContactFunction, ContactValue, FeatureShape, Placement, Spiral, Swing, Touching,
    contact_function, touching,
};
pub use feature::{FeatureKind, FeatureName};
pub use fixed_axes::{AxesError, Axis, AxisMotion, FixedAxesSpace};
pub use geometry::{Configuration, Point, Rotation, Vector};
pub use number::{Dual, Scalar, SecondOrder};
pub use pair::{
    ByDrawing, ByVertex, Coordinates, FeatureContact, FeatureId, LinkId, LinkKind, Location,
    LowerPair, Metric, PairClass, PairError, PairLink, PairPatch, PairRegion, PairSpace, PatchId,
    Projection, QueryError, RegionId, Relation, SmoothMotion, SmoothOutcome,
};
pub use part::{
    ArcSize, Direction, Edge, Loop, OutlineBuilder, OutlineError, Part, PartError, PartSymmetry,
    Vertex,
};
pub use query::{
    Classification, Classifier, FirstContact, MotionError, MotionOutcome, NearestContact,
};
pub use slice::{CurveGeometry, Slice, SliceCurve, Slicer};
pub use space::{
    Band, Boundary, BoundaryCurve, BoundaryKind, ComputeError, ContactSpace, Decisions,
    FeatureCounts, FreeRegion, LONGEST_WINDOW, Options, PairSymmetry, Patch, PatchRef, Progress,
    SideLink, Stage, StageSeconds, Statistics, Symmetry, VerticalLink, Window,
};

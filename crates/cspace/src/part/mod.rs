//! Planar parts: closed loops of line segments and circular arcs.
//!
//! A [`Part`] is made only by [`Part::new`], which checks that its loops bound a region; every function that takes a part can rely on this.
//! [`Part::polygon`], [`Part::circle`], [`Part::rectangle`] and [`Part::slot`] draw plain shapes, an [`OutlineBuilder`] draws a loop edge
//! by edge.

mod bounds;
mod check;
mod corner;
mod curve;
mod distance;
mod drawing;
mod edge;
mod error;
mod frame;
mod heights;
mod layer;
mod loops;
mod measure;
mod meeting;
mod moments;
mod names;
mod nearness;
mod outline;
mod part_feature;
mod status;
mod sweep;
mod symmetry;
mod together;
pub mod tolerance;
mod vertex;
#[cfg(feature = "serde")]
mod written;

pub use bounds::Bounds;
pub(crate) use distance::distance_of;
pub use drawing::{
    ArcError, ArcSize, CENTER_TOLERANCE, CHORD_TOLERANCE, Direction, Fillet, FilletError,
    OutlineBuilder, OutlineError, WHOLE_EDGE, bulge_about, bulge_through, bulge_with_radius,
    circle_loop, fillet, polygon_loop, rectangle_loop, slot_loop,
};
pub use edge::Edge;
pub use error::PartError;
pub(crate) use heights::{LoopHeights, MeetingLoops};
pub use layer::{Heights, Layer};
pub use loops::{Loop, Part};
pub(crate) use measure::Inside;
pub use moments::AreaMoments;
pub use part_feature::PartFeature;
pub(crate) use symmetry::{Corresponding, LoopImage, Symmetrized};
pub use symmetry::{PartSymmetry, SYMMETRIC};
pub use vertex::Vertex;

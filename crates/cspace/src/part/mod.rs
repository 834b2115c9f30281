//! Planar parts: closed loops of line segments and circular arcs.
//!
//! A [`Part`] is made only by [`Part::new`], which checks that its loops bound a region; every function that takes a part can rely on this.
//! [`Part::polygon`], [`Part::circle`], [`Part::rectangle`] and [`Part::slot`] draw plain shapes, an [`OutlineBuilder`] draws a loop edge
//! by edge.

mod arc;
mod bounds;
mod builder;
mod check;
mod corner;
mod curve;
mod distance;
mod edge;
mod error;
mod fillet;
mod frame;
mod loops;
mod measure;
mod meeting;
mod moments;
mod names;
mod nearness;
mod outline;
mod part_feature;
mod shapes;
mod status;
mod sweep;
mod symmetry;
pub mod tolerance;
mod vertex;
#[cfg(feature = "serde")]
mod written;

pub use arc::{
    ArcError, ArcSize, CENTER_TOLERANCE, CHORD_TOLERANCE, Direction, bulge_about, bulge_through,
    bulge_with_radius,
};
pub use bounds::Bounds;
pub use builder::{OutlineBuilder, OutlineError};
pub(crate) use distance::distance_of;
pub use edge::Edge;
pub use error::PartError;
pub use fillet::{Fillet, FilletError, WHOLE_EDGE, fillet};
pub use loops::{Loop, Part};
pub(crate) use measure::Inside;
pub use moments::AreaMoments;
pub use part_feature::PartFeature;
pub use shapes::{circle_loop, polygon_loop, rectangle_loop, slot_loop};
pub(crate) use symmetry::{Corresponding, LoopImage, Symmetrized};
pub use symmetry::{PartSymmetry, SYMMETRIC};
pub use vertex::Vertex;

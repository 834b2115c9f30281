//! Drawing of loops: plain shapes, outlines edge by edge, arcs from the data that drawings give, and rounded corners.

mod arc;
mod builder;
mod fillet;
mod shapes;

pub use arc::{
    ArcError, ArcSize, CENTER_TOLERANCE, CHORD_TOLERANCE, Direction, bulge_about, bulge_through,
    bulge_with_radius,
};
pub use builder::{OutlineBuilder, OutlineError};
pub use fillet::{Fillet, FilletError, WHOLE_EDGE, fillet};
pub use shapes::{circle_loop, polygon_loop, rectangle_loop, slot_loop};

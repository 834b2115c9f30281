//! Drawn parts for tests and benchmarks.

mod basic;
mod gear;
mod pen;
mod transform;

pub use basic::{
    annulus, circle, flatted_disc, half_disc, rectangle, regular_polygon, rounded_rectangle, square,
};
pub use gear::{gear, pawl, rack, ratchet};
pub use pen::{Pen, bulge_of, bulge_through, circle_loop, part, polar, rectangle_loop};
pub use transform::{backwards, mirrored, scaled, shifted, together, turned};

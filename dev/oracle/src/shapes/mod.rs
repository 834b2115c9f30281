//! Drawn parts for tests and benchmarks.

mod basic;
mod curved;
mod fits;
mod gear;
mod maze;
pub mod mechanisms;
pub mod notches;
pub mod pen;
mod random;
mod transform;

pub use basic::{
    annulus, circle, flatted_disc, half_disc, rectangle, regular_polygon, rounded_rectangle, square,
};
pub use curved::{c_shape, crescent, lens, ring_sector};
pub use fits::{peg, plate, rounded_peg, slotted_block, socket, three_holes, three_pegs};
pub use gear::{gear, pawl, rack, ratchet};
pub use maze::maze;
pub use pen::{
    Pen, bulge_of, bulge_through, circle_loop, part, polar, rectangle_loop, rounded_rectangle_loop,
};
pub use random::{random_part, random_pieces, random_ring};
pub use transform::{backwards, mirrored, scaled, shifted, together, turned};

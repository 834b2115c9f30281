//! From the contact space to a first path, whose legs are all free.
//!
//! ```text
//!            S        the straight way meets the surface S of free space at a and leaves it for good
//!   from ───a██b─── to    at b: a path goes to a, along S to b, and on. Every closed surface divides
//!           ╰──╯          the space, so the straight way comes back through each surface it enters.
//! ```
//!
//! `surfaces.rs` finds the surfaces in the way, `surface.rs` the way along one over patches and links, `above.rs` says where that
//! goes, a little off the surface, and `join.rs` makes legs of it. Pairs with fixed axes have gaps instead of surfaces (`gaps.rs`).

mod above;
mod gaps;
mod join;
mod piece;
mod planar;
mod station;
mod surface;
mod surfaces;

pub(crate) use gaps::Gaps;
pub(crate) use join::{Effort, join};
pub(crate) use piece::{Piece, along};
pub(crate) use planar::Planar;

//! From the contact space to a first path, whose legs are all free.
//!
//! ```text
//!            S        the straight way meets the surface S of free space at a and leaves it for good
//!   from ───a██b─── to    at b: a path goes to a, along S to b, and on. Every closed surface divides
//!           ╰──╯          the space, so the straight way comes back through each surface it enters.
//! ```
//!
//! `surface.rs` finds the way along S over patches and links, `piece.rs` says where it goes, a little off the surface, and
//! `join.rs` makes legs of it. Pairs with fixed axes have gaps instead of surfaces (`gaps.rs`).

mod gaps;
mod join;
mod lift;
mod piece;
mod planar;
mod surface;

pub(crate) use gaps::Gaps;
pub(crate) use join::join;
pub(crate) use lift::off_contact;
pub(crate) use planar::Planar;

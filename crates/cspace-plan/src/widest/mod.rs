//! The way whose least clearance is largest.
//!
//! Two configurations can be joined with a clearance of more than r if and only if they can be joined when the moving part is grown
//! by r. So the clearance that is possible is found by growing it, more and less, until the part passes and does not pass; a
//! path found on the way is moved to where it has most clearance, which is often all there is.

mod grow;
mod search;
mod shrink;

pub use grow::grown;
pub(crate) use search::{Between, Until, Wider, widen, with_moving};
pub use shrink::shrunk;

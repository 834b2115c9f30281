//! Pairs of all classes, through one type.
//!
//! | class | computed by | a configuration is |
//! |---|---|---|
//! | lower | table look-up ([`LowerPair`]) | (x, y, θ), on the joint |
//! | fixed axes | planar partition ([`FixedAxesSpace`](crate::FixedAxesSpace)) | (u, v) |
//! | symmetric | one slab and copies ([`ContactSpace`](crate::ContactSpace)) | (x, y, θ) |
//! | general | the general method ([`ContactSpace`](crate::ContactSpace)) | (x, y, θ) |

mod lower;
mod query;
mod relation;
mod saved;
mod space;

pub use lower::{Joint, LowerPair, PermanentContact, PermanentKind};
pub use query::{Neighbours, PairContact, PairMotion, PairNearest, QueryError};
pub use relation::{Coordinates, PairClass, Relation};
pub use saved::{SavedLower, SavedPair};
pub use space::{PairError, PairSpace};

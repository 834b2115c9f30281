//! Reference for the library's tests: brute force at single configurations, drawn shapes, and how much a test tries.
//!
//! Nothing here knows of configuration spaces, and of the library only the input types are used:
//! [`Oracle`] decides whether two parts overlap by intersecting their boundaries and testing points,
//! and works from the vertices as given, not from the edges the library derives from them.

// The shapes are constants of the tests: one that is no part is a mistake in this crate, to be heard at once.
#![allow(clippy::panic)]

pub mod effort;
pub mod families;
pub mod fill;
pub mod judge;
pub mod kept;
pub mod near;
pub mod pairs;
pub mod schema;
pub mod shapes;

pub use effort::{effort, is_long};
pub use families::{Case, Family, families};
pub use fill::{Compared, Fill};
pub use judge::{Oracle, Verdict, judge};
pub use near::{NearContact, near_contact, near_contact_about};
pub use pairs::{Pair, pair, pairs};
pub use schema::Schema;

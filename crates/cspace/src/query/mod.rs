//! Queries of configurations and motions, answered from the patches; and by tests of the parts themselves where the patches are in doubt.

pub(crate) mod classify;
mod contacts;
mod crossings;
mod farthest;
mod first_contact;
mod index;
mod location;
mod path;
mod project;
pub(crate) mod swept;
mod touch;

pub use contacts::NearestContact;
pub use farthest::Farthest;
pub use first_contact::{FirstContact, MotionOutcome};
pub use location::{Classification, Location};
pub use path::MotionError;

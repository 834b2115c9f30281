//! Queries of configurations and motions, answered from the patches; and by tests of the parts themselves where the patches are in doubt.

mod board;
mod cells;
mod centers;
mod classifier;
mod classify;
mod contacts;
mod crossings;
mod first_contact;
mod grid;
mod index;
mod nearby;
mod path;
mod project;
mod raster;
mod ray;
mod slab;
mod slot;
mod swept;
mod touch;
mod walk;

pub use classifier::Classifier;
pub use classify::Classification;
pub use contacts::NearestContact;
pub use first_contact::{FirstContact, MotionError, MotionOutcome};

//! Questions about single configurations, answered from the patches alone.

mod cells;
mod classifier;
mod classify;
mod contacts;
mod grid;
mod raster;
mod ray;
mod slot;
mod swept;
mod walk;

pub use classifier::Classifier;
pub use classify::Classification;
pub use contacts::NearestContact;

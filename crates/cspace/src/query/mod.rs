//! Questions about single configurations, answered from the patches alone.

mod classify;
mod contacts;

pub use classify::Classification;
pub use contacts::NearestContact;

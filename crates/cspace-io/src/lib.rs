//! File formats of `cspace`: reads models, writes and reads configuration spaces.
//!
//! [`read`] reads a file of either kind; [`model::read`] and [`saved::read`] read one kind. Every error is a
//! [`ModelError`]: it names the file, the line, the part, loop and vertex, and gives advice.
//!
//! Saved contact spaces are JSON; `docs/contact-space.schema.json` in the project's repository describes them field by
//! field. [`write`](mod@write) has meshes and pictures.

mod angle;
mod file;
pub mod model;
pub mod saved;
pub mod shown;
pub mod write;

pub use angle::parse_angle;
pub use cspace::LARGEST_ANGLE;
pub use file::{Host, Refused};
pub use model::{Model, ModelError};
pub use saved::{Document, SavedFile, read, read_from, read_from_hosted, read_hosted};

//! Models that are part of the program.

use cspace_io::Model;

use crate::failure::Failure;

/// A model that is part of the program.
pub(super) fn embedded(text: &str, name: &str) -> Result<Model, Failure> {
    Model::from_toml(text, name).map_err(Failure::work)
}

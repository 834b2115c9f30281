//! Models that are part of the program.

use cspace_io::model;
use cspace_mechanism::Mechanism;

use crate::failure::Failure;

/// A model that is part of the program.
pub(super) fn embedded(text: &str, name: &str) -> Result<Mechanism, Failure> {
    model::from_toml(text, name).map_err(Failure::new)
}

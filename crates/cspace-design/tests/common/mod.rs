//! What tests of designs have in common.
#![allow(clippy::unwrap_used)]

use cspace_io::Host;
use cspace_io::model::Template;

/// The template in the text of a model.
pub(crate) fn template(text: &str) -> Template {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("m.toml");
    std::fs::write(&file, text).unwrap();
    Template::read(&file, &Host::default()).unwrap()
}

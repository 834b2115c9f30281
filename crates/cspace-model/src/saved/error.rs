//! Errors for saved spaces that cannot be read.

use crate::ModelError;

/// Advice on how to replace a damaged or outdated file.
pub(super) const AGAIN: &str = "write the file again with `cspace export MODEL -o OUT.json`";

pub(super) fn wrong(message: &str, file: &str) -> ModelError {
    ModelError::of_file(message.to_owned())
        .with_help(AGAIN)
        .in_file(file)
}

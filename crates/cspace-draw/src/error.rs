//! Errors of pictures.

/// Why a picture cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// It has no dots, or more than can be written.
    #[error("a picture of {width} by {height} dots is not between 1 and 1.4e8 dots")]
    Size {
        /// The width asked for.
        width: f64,
        /// The height asked for.
        height: f64,
    },
    /// PNG could not be written.
    #[error("PNG: {0}")]
    Png(String),
}

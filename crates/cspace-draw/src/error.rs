//! Errors of pictures.

/// Why a picture cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The picture has no dots, or too many.
    #[error("a picture of {width} by {height} dots is not between 1 and 1.4e8 dots")]
    Size {
        /// Requested width.
        width: f64,
        /// Requested height.
        height: f64,
    },
    /// PNG could not be written.
    #[error("PNG: {0}")]
    Png(String),
}

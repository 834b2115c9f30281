//! Why a file cannot be read as DXF at all.

/// Error in the file, at a line of it (of a binary file, at a byte), or at [`DxfError::WHOLE`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct DxfError {
    pub(crate) line: usize,
    pub(crate) message: String,
    pub(crate) help: String,
}

pub(super) type Result<T> = core::result::Result<T, DxfError>;

impl DxfError {
    /// The line of an error that is at none.
    pub(crate) const WHOLE: usize = 0;

    pub(super) fn new(line: usize, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            line,
            message: message.into(),
            help: help.into(),
        }
    }

    /// The file ends in the middle of something.
    pub(super) fn cut_off(line: usize) -> Self {
        Self::new(
            line,
            "the file ends too early",
            "is it whole? copy or export it again",
        )
    }
}

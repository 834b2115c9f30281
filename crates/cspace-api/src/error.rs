//! Why a question has no answer.

use std::fmt::{self, Display};
use std::path::Path;

use cspace_model::ModelError;
use schemars::JsonSchema;
use serde::Serialize;

/// Why a question has no answer, and what to do about it.
///
/// ```
/// use cspace_api::Error;
/// let error = Error::new("there is no part \"pin\"").help("the parts are plate, rod");
/// assert_eq!(error.to_string(), "there is no part \"pin\"");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Error {
    /// The message, with its place.
    pub message: String,
    /// Advice.
    pub help: Option<String>,
    /// The file that is wrong.
    pub file: Option<String>,
    /// The line in it, counted from 1.
    pub line: Option<usize>,
    /// The column in it, counted from 1.
    pub column: Option<usize>,
}

impl Error {
    /// An error without advice, which is about no file.
    pub fn new(message: impl Display) -> Self {
        Self {
            message: message.to_string(),
            help: None,
            file: None,
            line: None,
            column: None,
        }
    }

    /// An error about a file, without advice.
    pub(crate) fn in_file(path: &Path, message: impl Display) -> Self {
        let file = path.display();
        Self {
            file: Some(file.to_string()),
            ..Self::new(format_args!("{file}: {message}"))
        }
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Display) -> Self {
        self.help = Some(help.to_string());
        self
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl core::error::Error for Error {}

impl From<ModelError> for Error {
    fn from(error: ModelError) -> Self {
        Self {
            help: error.help().map(str::to_owned),
            file: Some(error.file().to_owned()),
            line: error.line(),
            column: error.column(),
            ..Self::new(error)
        }
    }
}

/// An error as the answer.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(title = "What a command prints with `--json` where it has no answer")]
pub struct Failed<'a> {
    /// Why there is no answer.
    pub error: &'a Error,
}

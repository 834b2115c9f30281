//! The answers about several files, or why there is none.

use schemars::JsonSchema;
use serde::Serialize;

use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::outcome::outcomes;

outcomes! {
    /// How a question about several files came out.
    Outcome {
        /// All of them have an answer.
        Done = "done" is Yes,
        /// Some have none.
        Failed = "failed" is Open,
    }
}

/// The answers about several files.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Files<T: Content> {
    /// The answer about each file, or why there is none.
    pub files: Vec<FileAnswer<T>>,
}

impl<T: Content> Content for Files<T> {
    const COMMAND: &'static str = T::COMMAND;
    type Outcome = Outcome;
}

/// The answer about one of several files, or why there is none.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum FileAnswer<T: Content> {
    /// As about one file alone.
    Answered {
        /// The file.
        file: String,
        /// The answer.
        #[serde(flatten)]
        answer: Answer<T>,
    },
    /// Nothing is answered.
    Failed {
        /// The file.
        file: String,
        /// Why there is no answer.
        error: Error,
    },
}

impl<T: Content> Answer<Files<T>> {
    /// The answers about several files.
    pub fn of_files(files: Vec<FileAnswer<T>>) -> Self {
        let is_failed = |f: &FileAnswer<T>| matches!(f, FileAnswer::Failed { .. });
        let outcome = match files.iter().any(is_failed) {
            true => Outcome::Failed,
            false => Outcome::Done,
        };
        Self::new(None, outcome, Files { files })
    }
}

/// The answer of a command that takes one file, or several.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OneOrSeveral<T: Content> {
    /// About one file.
    One(Answer<T>),
    /// About several files.
    Several(Answer<Files<T>>),
}

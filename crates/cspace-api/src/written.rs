//! The answer of a command that writes a file: its name.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use crate::frame::{Answer, Content};
use crate::outcome::Done;

/// A picture that `cspace draw` wrote.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Picture {
    /// The file.
    pub written: PathBuf,
}

impl Content for Picture {
    const COMMAND: &'static str = "draw";
    type Outcome = Done;
}

/// A space, a mesh, a picture or a page that `cspace export` wrote.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Export {
    /// The file.
    pub written: PathBuf,
}

impl Content for Export {
    const COMMAND: &'static str = "export";
    type Outcome = Done;
}

/// The answer of a command that writes a file.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Written {
    /// By `cspace draw`.
    Picture(Answer<Picture>),
    /// By `cspace export`.
    Export(Answer<Export>),
}

//! Errors in a model file.

use core::fmt;

use super::place::Place;
use crate::shown;

/// Error in a file: its place, its description, and advice on how to correct it.
///
/// Displayed, it is one line without control characters, whatever the file's name and content.
///
/// ```
/// let text = "[[part]]\nname = \"pin\"\nloops = [[[0, 0], [1]]]\n";
/// let error = cspace_model::model::from_toml(text, "pin.toml").unwrap_err();
/// assert_eq!(error.line(), Some(3));
/// assert_eq!(error.place(), "part 0 \"pin\", loop 0, vertex 1");
/// assert_eq!(error.help(), Some("a vertex is [x, y] or [x, y, bulge]"));
/// assert_eq!(
///     error.to_string(),
///     "pin.toml:3:19: part 0 \"pin\", loop 0, vertex 1: a list of one item where a vertex is expected"
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModelError(Box<Inner>);

#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Inner {
    file: String,
    position: Option<(usize, usize)>,
    place: Place,
    /// Offset from the beginning of the place, in characters.
    further: usize,
    message: String,
    help: Option<String>,
}

impl ModelError {
    /// An error at a place of the file's tree of values.
    pub(crate) fn new(place: &Place, message: impl Into<String>) -> Self {
        Self(Box::new(Inner {
            place: place.clone(),
            message: message.into(),
            ..Inner::default()
        }))
    }

    /// An error of the file as a whole.
    pub(crate) fn of_file(message: impl Into<String>) -> Self {
        Self::new(&Place::default(), message)
    }

    pub(crate) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    pub(crate) fn in_file(mut self, file: &str) -> Self {
        file.clone_into(&mut self.0.file);
        self
    }

    /// Adds an offset from the beginning of its place, in characters.
    pub(super) fn further_by(mut self, characters: usize) -> Self {
        self.0.further = characters;
        self
    }

    /// Sets the line and column of its place, counted from 1.
    pub(crate) fn at(mut self, position: Option<(usize, usize)>) -> Self {
        self.0.position = position.map(|(line, column)| (line, column + self.0.further));
        self
    }

    /// Place in the tree of values.
    pub(super) fn tree_place(&self) -> &Place {
        &self.0.place
    }

    /// The file.
    pub fn file(&self) -> &str {
        &self.0.file
    }

    /// The line of the file, counted from 1; none if the error is of the file as a whole.
    pub fn line(&self) -> Option<usize> {
        self.0.position.map(|p| p.0)
    }

    /// The column of that line, counted from 1.
    pub fn column(&self) -> Option<usize> {
        self.0.position.map(|p| p.1)
    }

    /// Place in the model: the part, loop and vertex, the joint or pair; empty for the file as a whole.
    pub fn place(&self) -> &str {
        self.0.place.words()
    }

    /// Message: the error itself.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// Advice on how to correct the error.
    pub fn help(&self) -> Option<&str> {
        self.0.help.as_deref()
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&shown::text(&self.0.file))?;
        if let Some((line, column)) = self.0.position {
            write!(f, ":{line}:{column}")?;
        }
        f.write_str(": ")?;
        if !self.0.place.words().is_empty() {
            write!(f, "{}: ", self.0.place.words())?;
        }
        f.write_str(&shown::text(&self.0.message))
    }
}

impl core::error::Error for ModelError {}

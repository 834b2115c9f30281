//! Errors in a drawing.

use core::fmt;

use crate::drawing::{Origin, Problem};
use crate::shown;

/// Why a drawing makes no parts.
#[derive(Debug, Clone, PartialEq)]
pub enum DrawingError {
    /// The file cannot be read, or is no drawing of its kind.
    File {
        /// The line of the file, counted from 1; none for the file as a whole, and for one without lines.
        line: Option<usize>,
        /// Description of the error.
        message: String,
        /// Advice on how to correct it.
        help: String,
    },
    /// Entities cannot be used. There is at least one.
    Entities(Vec<Problem>),
}

impl DrawingError {
    pub(crate) fn file(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::File {
            line: None,
            message: message.into(),
            help: help.into(),
        }
    }

    /// Advice on how to correct the error, or the first of several.
    pub fn help(&self) -> &str {
        match self {
            Self::File { help, .. } => help,
            Self::Entities(problems) => problems.first().map_or("", |p| &p.help),
        }
    }
}

impl fmt::Display for DrawingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { line, message, .. } => {
                if let Some(line) = line {
                    write!(f, "line {line}: ")?;
                }
                f.write_str(message)
            }
            Self::Entities(problems) => {
                if let Some(first) = problems.first() {
                    first.fmt(f)?;
                }
                match problems.len() {
                    0 | 1 => Ok(()),
                    n => write!(f, "; and {} more such", n - 1),
                }
            }
        }
    }
}

impl core::error::Error for DrawingError {}

impl fmt::Display for Origin {
    /// `LINE 2F on layer "outline", line 120`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(shown::start(&self.kind).trim_matches('"'))?;
        if !self.handle.is_empty() {
            write!(f, " {}", shown::start(&self.handle).trim_matches('"'))?;
        }
        if !self.layer.is_empty() {
            write!(f, " on layer {}", shown::start(&self.layer))?;
        }
        if let Some(block) = self.blocks.last().filter(|b| **b != self.handle) {
            write!(f, " in block {}", shown::start(block))?;
        }
        if self.line > 0 {
            write!(f, " (line {})", self.line)?;
        }
        Ok(())
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        /// Largest number of entities that are named.
        const MOST: usize = 8;
        self.origin.fmt(f)?;
        for other in self.with.iter().take(MOST) {
            write!(f, ", {other}")?;
        }
        if self.with.len() > MOST {
            write!(f, " and {} more", self.with.len() - MOST)?;
        }
        if let Some(at) = self.at {
            write!(f, ", at {}", shown::point(at))?;
        }
        write!(f, ": {}", self.reason)
    }
}

//! Findings of a target.

use core::fmt;
use std::error::Error;

use cspace::Part;
use cspace_model::{Mechanism, PairEntry, PartEntry, model};

/// An answer that is wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Question, answer, and correct answer.
    pub what: String,
    /// Parts concerned, as the text of a model file.
    pub model: Option<String>,
}

impl Finding {
    pub(crate) fn new(what: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            model: None,
        }
    }

    pub(crate) fn about(self, fixed: &Part, moving: &Part, window: Option<(f64, f64)>) -> Self {
        let entry = |part: &Part| PartEntry::planar(part.clone());
        let model = Mechanism {
            name: "found by fuzzing".into(),
            parts: vec![entry(fixed), entry(moving)],
            pairs: vec![PairEntry {
                fixed: 0,
                moving: 1,
                window,
            }],
            ..Mechanism::default()
        };
        Self {
            model: Some(model::to_toml(&model)),
            ..self
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in self.what.lines() {
            writeln!(f, "# {line}")?;
        }
        f.write_str(self.model.as_deref().unwrap_or_default())
    }
}

impl Error for Finding {}

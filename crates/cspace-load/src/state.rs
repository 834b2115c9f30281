//! How far it went, in a file.

use std::io::Write;
use std::path::Path;

use cspace_load::Tally;
use serde::{Deserialize, Serialize};

/// What it takes to go on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct State {
    /// Which pairs.
    pub(crate) seed: u64,
    /// Of which family, if of one.
    #[serde(default)]
    pub(crate) family: Option<String>,
    /// The first pair that is not done.
    pub(crate) next: u64,
    /// What was found before it.
    pub(crate) tally: Tally,
}

impl State {
    pub(crate) fn new(seed: u64, family: Option<String>) -> Self {
        Self {
            seed,
            family,
            next: 0,
            tally: Tally::default(),
        }
    }

    pub(crate) fn read(path: &Path) -> Result<Self, String> {
        let failed = |e: &dyn core::fmt::Display| format!("{}: {e}", path.display());
        let text = std::fs::read_to_string(path).map_err(|e| failed(&e))?;
        serde_json::from_str(&text).map_err(|e| failed(&e))
    }

    /// Writes it whole, through a temporary file beside it.
    pub(crate) fn write(&self, path: &Path) -> Result<(), String> {
        let failed = |e: &dyn core::fmt::Display| format!("{}: {e}", path.display());
        let text = serde_json::to_string_pretty(self).map_err(|e| failed(&e))?;
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let mut file = tempfile::NamedTempFile::new_in(folder).map_err(|e| failed(&e))?;
        file.write_all(text.as_bytes()).map_err(|e| failed(&e))?;
        file.persist(path).map_err(|e| failed(&e))?;
        Ok(())
    }
}

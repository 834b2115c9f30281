//! State of a run, in a file.

use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

use cspace_load::Tally;
use serde::{Deserialize, Serialize};

/// Largest size of a state file, which has some twenty numbers.
const MOST_BYTES: u64 = 1 << 20;

/// State of an interrupted run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct State {
    /// Seed of the pairs.
    pub(crate) seed: u64,
    /// Family of the pairs, if they are of one.
    #[serde(default)]
    pub(crate) family: Option<String>,
    /// The first pair that is not done.
    pub(crate) next: u64,
    /// Counts of the pairs before it.
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
        // A pipe might never say anything, a device might never end.
        if !std::fs::metadata(path).map_err(|e| failed(&e))?.is_file() {
            return Err(failed(&"a state is a regular file"));
        }
        let file = File::open(path).map_err(|e| failed(&e))?;
        let mut text = String::new();
        let mut bounded = file.take(MOST_BYTES + 1);
        let length = bounded.read_to_string(&mut text).map_err(|e| failed(&e))?;
        if length as u64 > MOST_BYTES {
            return Err(failed(&"it is too large for a state"));
        }
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

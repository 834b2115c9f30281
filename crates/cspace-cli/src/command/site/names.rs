//! The names of a site's files.

use std::collections::BTreeSet;

/// Names that are taken, in lower case: on many disks names that differ only in case are one.
#[derive(Debug, Default)]
pub(super) struct Names(BTreeSet<String>);

impl Names {
    /// A name that no other file has: as wanted, of characters that have no special meaning for file systems and URLs, with a
    /// number if need be. `/` separates folders.
    pub(super) fn take(&mut self, wanted: &str, extension: &str) -> String {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_./".contains(c);
        let stem: String = (wanted.chars().map(|c| if plain(c) { c } else { '-' })).collect();
        let mut name = format!("{stem}{extension}");
        let mut number = 1;
        while !self.0.insert(name.to_ascii_lowercase()) {
            number += 1;
            name = format!("{stem}-{number}{extension}");
        }
        name
    }
}

//! Branches: crossings of two sheets, followed over the orientations at which they exist.

use crate::grouped::Grouped;

/// One crossing of two sheets from one cluster of events to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Branch {
    pub(crate) first: u32,
    pub(crate) second: u32,
    pub(crate) root: u8,
    /// Whether travel along the first enters the blocked side of the second.
    pub(crate) enters: bool,
    pub(crate) from: u32,
    pub(crate) to: u32,
}

impl Branch {
    /// The sheet that is not `sheet`.
    pub(crate) fn other(&self, sheet: u32) -> u32 {
        if self.first == sheet {
            self.second
        } else {
            self.first
        }
    }

    /// Whether travel along `sheet` enters the blocked side of the other.
    pub(crate) fn enters(&self, sheet: u32) -> bool {
        (self.first == sheet) == self.enters
    }
}

/// The branches on every sheet.
pub(crate) fn on_sheets(sheets: usize, branches: &[Branch]) -> Grouped {
    let numbered = (0u32..).zip(branches);
    Grouped::new(
        sheets,
        numbered.flat_map(|(i, b)| [(b.first, i), (b.second, i)]),
    )
}

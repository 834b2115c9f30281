//! Cells: sheets cut by the branches that cross them, and how cells continue where sheets lie on each other.

pub(crate) mod active;
pub(crate) mod cell;
pub(crate) mod extent;
pub(crate) mod gaps;
pub(crate) mod levels;
pub(crate) mod sweep;
pub(crate) mod track;

//! Links: chains of free cells become patches, with their neighbours, their copies by symmetry, and the regions of free
//! space that they bound.

pub(crate) mod assemble;
pub(crate) mod chains;
pub(crate) mod copies;
pub(crate) mod neighbours;
pub(crate) mod regions;

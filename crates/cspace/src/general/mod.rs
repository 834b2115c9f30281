//! The general method: the contact space of two parts over all orientations. Read `compute.rs` first.

pub(crate) mod broad;
pub(crate) mod cells;
pub(crate) mod compute;
pub(crate) mod events;
pub(crate) mod limits;
pub(crate) mod links;
pub(crate) mod symmetry;
pub(crate) mod verdict;

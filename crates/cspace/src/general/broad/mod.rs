//! Broad phase: which sheets may cross at all. Discs inside both parts block positions for certain, and what they cover
//! is left out.

pub(crate) mod candidates;
pub(crate) mod covering;
pub(crate) mod disc;
pub(crate) mod disc_table;
pub(crate) mod discs;
pub(crate) mod grid;
pub(crate) mod uncovered;

//! Verdicts: which cells bound free space, which of them the drawing does not have, and where the answer is in doubt.

pub(crate) mod contract;
pub(crate) mod doubt;
pub(crate) mod shells;

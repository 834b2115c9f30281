//! Sheets in double-double: what is decided again where doubles leave it open.
//!
//! A sheet is made anew from the features in double-double that it belongs to. Its curve at one orientation has places, ends and
//! crossings with others as curves in doubles have (`curve.rs`, `crossing.rs`), and the orientations at which crossings come and
//! go are roots of the conditions of `condition.rs`.

mod condition;
mod curve;
mod sheet;
mod turn;

pub(crate) use condition::Rough;
pub(crate) use curve::ExactCurve;
pub(crate) use sheet::{ExactSheet, exact_crossings};
pub(crate) use turn::ExactTurn;

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests;

//! Sheets in double-double: what is decided again where doubles leave it open.
//!
//! A sheet is made anew from the features in double-double that it belongs to. Lines and circles are all there is: large
//! circles need no form of their own, for with 106 bits a place near the parts is known about any centre. Its curve at one
//! orientation has places, ends and crossings with others as curves in doubles have (`curve.rs`, `crossing.rs`), and the
//! orientations at which crossings come and go are roots of the conditions of `condition.rs`.

mod carrier;
mod condition;
mod curve;
mod sheet;
mod spiral;

pub(crate) use carrier::ExactCarrier;
pub(crate) use condition::Rough;
pub(crate) use curve::ExactCurve;
pub(crate) use sheet::{ExactSheet, exact_crossings};
pub(crate) use spiral::ExactTurn;

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests;

//! Verdicts: which cells bound free space.
//!
//! Cells that continue each other around the outside of a pocket, or of a part, are a shell. A shell is free or blocked as a whole, because
//! only a crossing could change its class, and crossings are its ends:
//!
//! ```text
//!      ╭──cell──╮
//!    cell      cell     one test of overlap, beside a cell, decides for all
//!      ╰──cell──╯
//! ```
//!
//! `shells.rs` joins and tests. `contract.rs` removes structures that last less than the narrowest band, which come from growth and
//! perturbation, not from the drawing. `doubt.rs` finds the orientations at which the result is doubtful.

pub(crate) mod contract;
pub(crate) mod doubt;
pub(crate) mod shells;

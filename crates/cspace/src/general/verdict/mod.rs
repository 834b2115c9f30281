//! Verdicts: which cells bound free space.
//!
//! Cells that continue each other around the outside of a pocket, or of a part, are a shell. A shell is free or blocked as a
//! whole, because what would change it is a crossing, and crossings are its ends:
//!
//! ```text
//!      ╭──cell──╮
//!    cell      cell     one test of overlap, beside a cell, decides for all
//!      ╰──cell──╯
//! ```
//!
//! `shells.rs` joins and tests. `contract.rs` removes what lasts less than the narrowest band: growth and perturbation made it, not
//! the drawing. `doubt.rs` says where the answer is not relied upon.

pub(crate) mod contract;
pub(crate) mod doubt;
pub(crate) mod shells;

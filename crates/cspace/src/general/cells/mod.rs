//! Cells: sheets cut by the branches that cross them.
//!
//! ```text
//!   θ ↑  ┌──────┬─────────┐ end of the sheet
//!     │  │      ╲  cell   │
//!     │  │ cell  ╲────────┤ an event: the cell on the right begins anew
//!     │  │        ╲ cell  │
//!     │  └─────────╲──────┘
//!             branch
//! ```
//!
//! `sweep.rs` cuts, using the branches that exist at the moment (`active.rs`) in their order on the curve (`gaps.rs`). Where sheets lie on
//! each other at one orientation, `levels.rs` and `track.rs` find which cells share a stretch of the curve; `extent.rs` measures the shared
//! pieces.

pub(crate) mod active;
pub(crate) mod cell;
pub(crate) mod extent;
pub(crate) mod gaps;
pub(crate) mod levels;
pub(crate) mod sweep;
pub(crate) mod track;

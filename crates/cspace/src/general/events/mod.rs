//! Events: critical orientations, and orientations that may be critical.
//!
//! ```text
//!   θ ↑        ╲ ╱      ← passing: branches a and b exchange their order on a sheet, where three sheets meet
//!     │         ╳
//!     │      a ╱ ╲ b
//!     │  ─────●───┼────  ← event of a pair: the crossing a comes to be
//! ```
//!
//! `coming.rs` finds where crossings of two sheets appear and disappear (roots of α cos θ + β sin θ + γ), and `trace.rs` follows the
//! branches between, of which `buried.rs` drops those in blocked space; `swallowed.rs` tells which curve passes another with all its length. `triple.rs` and `passing.rs` find where branches pass each other.
//! `clusters.rs` gathers events whose order is not known, `gathered.rs` collects everything that happens at them. `placing.rs` computes the
//! place of a branch on its curve, and `order.rs` the order of branches.

pub(crate) mod branch;
pub(crate) mod buried;
pub(crate) mod clusters;
pub(crate) mod coming;
pub(crate) mod gathered;
pub(crate) mod meetings;
pub(crate) mod order;
pub(crate) mod passing;
pub(crate) mod placing;
pub(crate) mod swallowed;
pub(crate) mod trace;
pub(crate) mod triple;

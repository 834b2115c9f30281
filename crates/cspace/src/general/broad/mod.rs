//! Broad phase: which sheets may cross.
//!
//! A disc inside the fixed part and a disc inside the moving part overlap at all positions within a disc. Only the pieces of a contact
//! curve that no such disc covers can bound free space:
//!
//! ```text
//!        ╭───────╮
//!   ─────┼━━━━━━━┼──────────  a contact curve: ━ is covered, and so blocked; ─ is left open
//!        ╰───────╯
//! ```
//!
//! `discs.rs` makes the discs, `uncovered.rs` finds the uncovered pieces of a curve over an interval of orientations, and `candidates.rs`
//! collects the pairs of sheets whose uncovered pieces come near each other. Large pairs have more discs than can be tried: `disc_table.rs`
//! finds those that overlap at one configuration, for pieces of curves of parts with very many edges and for crossings (`events/buried.rs`).

pub(crate) mod candidates;
pub(crate) mod covering;
pub(crate) mod disc;
pub(crate) mod disc_table;
pub(crate) mod discs;
pub(crate) mod grid;
pub(crate) mod uncovered;

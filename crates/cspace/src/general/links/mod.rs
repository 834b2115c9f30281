//! Links: chains of free cells become patches with neighbours.
//!
//! ```text
//!   θ ↑      ┌─────────┐
//!     │      │ above   │        vertical link: across a critical orientation
//!     │  ┌───┴──┬──────┴─┐
//!     │  │ left │ right  │      side link: at a boundary curve
//!     │  └──────┴────────┘
//! ```
//!
//! `chains.rs` joins cells, `neighbours.rs` links patches, `copies.rs` repeats the period of a symmetric pair (Figure 4 of Sacks 1999),
//! `assemble.rs` makes the space and `regions.rs` finds which patches bound one region of free space.

pub(crate) mod assemble;
pub(crate) mod chains;
pub(crate) mod copies;
pub(crate) mod neighbours;
pub(crate) mod regions;

//! The general method: the contact space of two parts over all orientations. Read `compute.rs` first.
//!
//! ```text
//!   sheets (contact/)          a contact of two features over orientations, not yet cut
//!     │  broad/                which of them may cross; what lies deep in blocked space is left out
//!     ▼
//!   pairs of sheets
//!     │  events/               orientations at which crossings come, go and pass each other
//!     ▼
//!   branches, clusters         a branch is one crossing between two events; a cluster is a critical orientation at most
//!     │  cells/                sheets cut by branches
//!     ▼
//!   cells
//!     │  verdict/              which cells bound free space
//!     ▼
//!   free cells
//!     │  links/                chains of cells become patches; their neighbours, copies and regions
//!     ▼
//!   ContactSpace (space/)
//! ```

pub(crate) mod broad;
pub(crate) mod cells;
pub(crate) mod compute;
pub(crate) mod events;
pub(crate) mod limits;
pub(crate) mod links;
mod no_fit;
pub(crate) mod plan;
mod redrawn;
mod slicer;
pub(crate) mod verdict;

pub use no_fit::{NoFit, NoFitError};
pub use slicer::Slicer;

//! The contact space of a pair of parts, over all orientations.

mod active;
mod assemble;
mod branch;
mod candidates;
mod cells;
mod chains;
mod clusters;
mod compute;
mod core;
mod extent;
mod gaps;
mod graph;
mod levels;
mod lifts;
mod links;
mod meetings;
mod passing;
mod patch;
mod placing;
mod regions;
mod saved;
mod shells;
mod slice;
mod stats;
mod sweep;
mod symmetry;
mod triple;

pub use compute::{ComputeError, LONGEST_WINDOW, Options, Progress, Stage};
pub use graph::{Band, ContactSpace, FeatureCounts, FreeRegion, SideLink, VerticalLink, Window};
pub use patch::{Boundary, BoundaryCurve, BoundaryKind, Patch, PatchRef};
pub(crate) use saved::check_head;
pub use saved::{SAVED_VERSION, SavedError, SavedFrame, SavedPart, SavedSpace};
pub(crate) use slice::{PASSED_ENDS, sweep};
pub use stats::{Decisions, StageSeconds, Statistics};
pub(crate) use symmetry::as_drawn;
pub use symmetry::{PairSymmetry, Symmetry};

//! The contact space of a pair of parts, over all orientations.

mod assemble;
mod branch;
mod candidates;
mod cells;
mod chains;
mod clusters;
mod compute;
mod core;
mod gaps;
mod graph;
mod levels;
mod lifts;
mod links;
mod patch;
mod regions;
mod saved;
mod shells;
mod slice;
mod stats;
mod sweep;
mod symmetry;
mod triple;

pub use compute::{ComputeError, Options, Progress, Stage};
pub use graph::{Band, ContactSpace, FeatureCounts, FreeRegion, SideLink, VerticalLink, Window};
pub use patch::{Boundary, BoundaryCurve, BoundaryKind, Patch, PatchRef};
pub use saved::{SAVED_VERSION, SavedError, SavedFrame, SavedPart, SavedSpace};
pub(crate) use slice::sweep;
pub use stats::{StageSeconds, Statistics};
pub use symmetry::{PairSymmetry, Symmetry};

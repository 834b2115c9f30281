//! The contact space of a pair of parts: what was computed, as data, and what is read off it.

mod doubts;
mod graph;
mod options;
mod patch;
mod saved;
mod slice;
mod stats;
mod symmetry;

pub(crate) use doubts::{Doubts, union};
pub(crate) use graph::Walk;
pub use graph::{Band, ContactSpace, FeatureCounts, FreeRegion, SideLink, VerticalLink};
pub(crate) use options::WINDOW_SLACK;
pub use options::{ComputeError, LONGEST_WINDOW, Options, Progress, Stage, Window};
pub(crate) use patch::point_on;
pub use patch::{Boundary, BoundaryCurve, BoundaryKind, Patch, PatchRef};
pub(crate) use saved::check_head;
pub use saved::{SAVED_VERSION, SavedError, SavedFrame, SavedPart, SavedSpace};
pub(crate) use slice::{PASSED_ENDS, sweep};
pub use stats::{Decisions, StageSeconds, Statistics};
pub use symmetry::{PairSymmetry, Symmetry};

//! The contact space of a pair of parts: the computed data, and its slices, bands and links.

mod alive;
mod band;
mod check;
mod data;
mod doubts;
mod fit;
mod graph;
mod options;
mod patch;
mod slice;
mod stats;
mod symmetry;
mod walk;

pub use band::Band;
pub(crate) use band::bands;
pub use check::DataError;
pub(crate) use check::check_head;
pub(crate) use data::FORMAT;
pub use data::{FeatureCounts, FreeRegion, SAVED_VERSION, SideLink, SpaceData, VerticalLink};
pub(crate) use doubts::{in_window, union};
pub use graph::ContactSpace;
pub(crate) use options::WINDOW_SLACK;
pub use options::{ComputeError, LONGEST_WINDOW, Options, Progress, Silent, Stage, Window};
pub use patch::{Boundary, BoundaryCurve, BoundaryKind, Patch, PatchRef};
pub(crate) use slice::{PASSED_ENDS, Surface, on_cycle, sweep};
pub use stats::{Decisions, StageSeconds, Statistics};
pub use symmetry::{PairSymmetry, Symmetry};
pub(crate) use walk::Walk;

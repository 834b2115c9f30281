//! Pairs on fixed axes: each part turns about a point, slides along a direction, or does not move.

mod arrange;
mod axis;
mod bands;
mod body;
mod build;
mod chain;
mod classify;
mod condition;
mod cross;
mod domain;
mod equation;
mod first;
mod judge;
mod motion;
mod nodes;
mod patch;
mod picture;
mod piece;
mod saved;
mod space;

pub use axis::{AxesError, Axis, AxisMotion, Role};
pub use patch::{AxesBranch, AxesPatch, BranchForm};
pub use saved::SavedAxes;
pub use space::{AxesRegion, AxesStatistics, FixedAxesSpace};

//! Paths between configurations of planar parts, or the proof that there is none.
//!
//! A contact space knows whether two configurations can be joined: they can if and only if they are in the same free region.
//! [`Planner`] answers with a path whose legs are motions of constant rates, each with a clearance that is certain ([`legs`]), or
//! with what keeps the two apart. [`proof`] writes the latter so that anyone can
//! check it. [`modes`] are the free regions of three parts on fixed axes, [`nest`] says where a
//! part goes in a container.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod answer;
mod apart;
pub mod assembly;
mod centers;
mod check;
pub mod clash;
mod ends;
pub mod escape;
mod exact_fit;
mod farthest;
pub mod fits;
pub mod legs;
pub mod modes;
pub mod nest;
mod off_contact;
mod open;
mod out;
mod path;
mod planner;
pub mod proof;
mod push;
pub mod ranges;
mod route;
pub mod slide;
mod straight;
mod widest;

pub use answer::{Answer, Blocked, Bottleneck, Enclosed, Narrow, Path, Verdict};
pub use check::{Checked, Meeting, check, touches};
pub use exact_fit::{fits_exactly, touching_distance, with_gap, with_room};
pub use farthest::farthest;
pub use off_contact::off_contacts;
pub use path::Prefer;
pub use planner::{Clearance, PlanError, Planner, Wishes};
pub use straight::straight;
pub use widest::{grown, shrunk};

//! Contacts: the surfaces of the configuration space on which a feature of one part touches a feature of the other.
//!
//! # One orientation
//!
//! The positions at which two features touch form a curve, a piece of a line or circle, its cycle:
//!
//! ```text
//!                 n ↑                    free space
//!    end ←──────────┼────────── start    the curve of the contact
//!                   │ r
//!    ═══════════════╪══════════          a line of the fixed part, touched by an arc of radius r
//!                   │                    blocked space
//! ```
//!
//! The normal n is outward from the fixed part and points to the free side; travel is to the left of it, so that blocked space is on the
//! left of travel. A circle is traversed counter-clockwise if its radius is positive: the radius is the sum of the signed radii of the two
//! features, those of concave arcs being negative. `function.rs` has the equations.
//!
//! # All orientations
//!
//! As θ grows the curve moves, and its ends move along spirals u + R w (`spiral.rs`): an end is where one of the features ends
//! at a joint, and the normal there is that of the joint, fixed or turning. A sheet is such a surface over an interval of
//! orientations in which both ends keep their joints:
//!
//! ```text
//!    θ ↑    end ●────────● start    top: two lines become parallel, or an end moves to another joint
//!      │        │ sheet  │          ends: each is shared with the sheet of the next feature (`end_names.rs`)
//!      │    end ●────────● start    bottom
//! ```
//!
//! `build.rs` makes all sheets of a pair; `shared.rs` and `tangent.rs` find what two sheets share by construction. Other crossings of two
//! curves appear and disappear only at roots of α cos θ + β sin θ + γ (`condition.rs`). If parts are symmetric, only the sheets of one
//! period are made (`symmetry.rs`).
//!
//! # Levels of precision
//!
//! All lines and circles are cycles (`cycle.rs`); how they move with orientation is written once, as carriers (`carrier.rs`). A sheet has
//! its locus (`locus.rs`), a carrier with the ends of the curve on it, in f64, and in double-double for decisions that f64 leaves open;
//! curves, crossings and conditions are written once for both. The parts have been changed so that nothing coincides in double-double (see
//! the features). A cycle whose centre is far from the parts is written by a point near them, so that no number in it is
//! large.

mod build;
mod carrier;
mod condition;
mod contacts;
mod crossing;
mod curve;
mod cycle;
mod drawn;
mod end_names;
mod function;
mod locus;
mod orientation;
mod overlap;
mod pair;
mod placement;
mod shared;
mod sheet;
mod spiral;
mod symmetry;
mod tangent;

pub(crate) use carrier::{Carrier, SheetKind};
pub(crate) use condition::conditions;
pub(crate) use crossing::crossings;
pub(crate) use curve::Curve;
pub(crate) use cycle::{Cycle, PLACE_ERROR};
pub use drawn::{
    ContactValue, FeatureShape, Touching, TouchingPlace, contact_function, touching, touching_place,
};
pub use function::ContactFunction;
#[cfg(feature = "fuzzing")]
pub(crate) use locus::Locus;
pub(crate) use orientation::Orientation;
pub(crate) use overlap::{Body, overlap};
pub use pair::overlap_as_drawn;
pub(crate) use pair::{Bodies, Exact, Fit, Geometry, Placed, Precision};
pub use placement::Placement;
pub(crate) use sheet::{Seam, Sheet};
pub use spiral::{Spiral, Swing};
pub(crate) use symmetry::{Permutation, SlabMotion, Steps};

//! Contacts: the sheets that pairs of features sweep out, their ends, and the curves they show at one orientation.

mod build;
mod carrier;
mod condition;
mod crossing;
mod curve;
mod drawn;
mod end_names;
mod exact;
mod flat_arc;
mod function;
mod overlap;
mod pair;
mod period;
mod placement;
mod shared;
mod sheet;
mod spiral;
mod tangent;

pub(crate) use carrier::{Carrier, PLACE_ERROR, place_error, place_on};
pub(crate) use condition::conditions;
pub(crate) use crossing::{Crossing, crossing, roots};
pub(crate) use curve::{Curve, CurveShape};
pub use drawn::{ContactValue, FeatureShape, Touching, contact_function, touching};
pub(crate) use exact::{ExactCurve, ExactSheet, ExactTurn, Rough, exact_crossings};
pub(crate) use flat_arc::FlatArc;
pub use function::ContactFunction;
pub(crate) use overlap::{Body, overlap};
pub(crate) use pair::{Bodies, Geometry, Placed, growths};
pub(crate) use period::{Permutation, SlabMotion, Steps};
pub use placement::Placement;
pub(crate) use shared::SharedEnds;
#[cfg(feature = "fuzzing")]
pub(crate) use sheet::{EndAngle, EndAt, SheetKind};
pub(crate) use sheet::{Seam, Sheet};
pub use spiral::{Spiral, Swing};

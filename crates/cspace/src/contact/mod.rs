//! Contacts: the sheets that pairs of features sweep out, their ends, and the curves they show at one orientation.

mod bow;
mod bow_events;
mod build;
mod carrier;
mod condition;
mod crossing;
mod curve;
mod doubled;
mod drawn;
mod exact;
mod function;
mod names;
mod overlap;
mod pair;
mod placement;
mod sheet;
mod span;
mod spiral;
mod sums;
mod twist;

pub(crate) use bow::{Bow, Level};
pub(crate) use carrier::{Carrier, PLACE_ERROR, place_error, place_on};
pub(crate) use condition::conditions;
pub(crate) use crossing::{Crossing, crossing, roots};
pub(crate) use curve::{Curve, CurveShape, wrap};
pub use drawn::{ContactValue, FeatureShape, Touching, contact_function, touching};
pub(crate) use exact::{ExactCurve, ExactSheet, ExactTurn, Rough, exact_crossings};
pub use function::ContactFunction;
pub(crate) use overlap::{Body, overlap};
pub(crate) use pair::{Bodies, Geometry, Placed, growths};
pub use placement::Placement;
#[cfg(feature = "fuzzing")]
pub(crate) use sheet::{EndAngle, EndAt, SheetKind};
pub(crate) use sheet::{Seam, SharedEnds, Sheet, WIDEST_SAGITTA};
pub use spiral::{Spiral, Swing};
pub(crate) use twist::{Permutation, Steps, Twist};

//! Contacts: the sheets that pairs of features sweep out, their ends, and the curves they show at one orientation.

mod build;
mod crossing;
mod curve;
mod overlap;
mod pair;
mod sheet;

pub(crate) use build::{Contacts, Span};
pub(crate) use crossing::{Crossing, crossing, roots};
pub(crate) use curve::{Curve, CurveShape};
pub(crate) use overlap::{Body, overlap};
pub(crate) use pair::Geometry;
pub(crate) use sheet::{EndAngle, Seam, Sheet, SheetKind, Spiral};

//! Lines and arcs within a tolerance of smooth curves and of measured points, tangent to each other.
//!
//! A smooth run of samples is divided into as few tangent pieces as can be, each a line or an arc between two samples that
//! passes all samples between within the tolerance ([`divide`]). At ends whose direction is given, and where a closed run
//! comes back, a small kink is left; moving the joints and changing the arcs by as little as possible takes it away
//! ([`tangent`]). What then deviates too far ([`deviation`]) is divided anew for a narrower band.
//!
//! Joints on the curve itself lose nothing: along a curve whose curvature changes at the rate k an arc of length L between
//! points of the curve deviates by k L³ / (72 √3) or more, and a chain of tangent arcs reaches that.

mod bulges;
mod chain;
mod deviation;
mod divide;
mod fitted;
mod part;
mod pieces;
mod profile;
mod run;
mod tangent;
#[cfg(test)]
mod tests;

pub(crate) use chain::{NotFitted, Outline, Sided, outline};
pub(crate) use profile::{profile, sagitta, scatter, trace};

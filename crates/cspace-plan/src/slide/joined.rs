//! Parts that a joint keeps in contact: they move along it.

use cspace::pair::{Joint, LowerPair};
use cspace::{Configuration, Vector};

/// The configuration of the joint that is as far along it as another, within its limits.
pub(super) fn along_joint(pair: &LowerPair, to: Configuration) -> Configuration {
    let asked = match pair.joint() {
        Joint::Revolute { .. } => to.theta,
        Joint::Prismatic { direction, .. } => direction.unit().dot(Vector::new(to.x, to.y)),
    };
    let t = match pair.limits() {
        Some((lo, hi)) => asked.clamp(lo, hi),
        None => asked,
    };
    pair.configuration(t)
}

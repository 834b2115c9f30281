//! Features in contact.

use cspace::pair::PairContact;
use cspace::{Coordinates, FeatureName, NearFeatures, PairSpace, PatchId, QueryError};

use crate::motion::Motion;

/// Features of the fixed and of the moving part that touch each other.
pub type FeaturePair = (FeatureName, FeatureName);

/// How much earlier than a contact is looked for what else touches, as a share of the motion: beyond a jam nothing does.
const BEFORE: f64 = 1e-9;

/// The features of a patch.
fn features(space: &PairSpace, patch: PatchId) -> Result<FeaturePair, QueryError> {
    let (fixed, moving) = space.patch(patch)?.features()?;
    Ok((fixed.name, moving.name))
}

/// The features that are near each other, by name.
pub fn pair_of(near: &NearFeatures) -> FeaturePair {
    (near.fixed.name, near.moving.name)
}

/// Names of a pair of features.
pub fn texts(space: &PairSpace, (fixed, moving): FeaturePair) -> [String; 2] {
    [
        space.fixed().feature_text(fixed),
        space.moving().feature_text(moving),
    ]
}

/// How far a point of the moving part that may touch is from its origin, at most.
fn arm(space: &PairSpace) -> f64 {
    let drawn = space.moving().bounds();
    let corners = [drawn.min, drawn.max].map(|p| p.to_vector().length());
    corners[0].max(corners[1]) + space.fixed().size() + space.moving().size()
}

/// Features in contact where a motion from a configuration at constant rates has met a contact: the features of its patch first, then
/// those that a moment before are nearer than they come in it.
pub fn touching(
    space: &PairSpace,
    motion: &Motion,
    contact: &PairContact,
) -> Result<Vec<FeaturePair>, QueryError> {
    let (before, within) = just_before(space, motion, contact.time);
    let mut all = vec![features(space, contact.patch)?];
    for near in space.near_features(before, within)? {
        let pair = pair_of(&near);
        if !all.contains(&pair) {
            all.push(pair);
        }
    }
    Ok(all)
}

/// The configuration a moment before a time of a motion, and how far features may be apart there that touch then: a point of the
/// moving part comes no farther in that moment, or in as little an orientation.
fn just_before(space: &PairSpace, motion: &Motion, time: f64) -> (Coordinates, f64) {
    let t = (time - BEFORE).max(0.0);
    let within = match motion.rates {
        Coordinates::Planar(d) => {
            let arm = arm(space) + motion.about.length();
            let speed = d.x.hypot(d.y) + arm * d.theta.abs();
            speed * (time - t) + arm * BEFORE
        }
        Coordinates::Axes { u, v } => {
            // A radian moves what is in reach of contact by no more than both parts together are large.
            let size = space.fixed().size() + space.moving().size();
            (u.abs() + v.abs()) * size.max(1.0) * (time - t)
        }
    };
    (motion.at(t), within + 4.0 * space.resolution())
}

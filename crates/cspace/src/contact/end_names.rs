//! Names of the ends of contact curves: equal for the curves that share an end.

use crate::feature::Outline;

use super::symmetry::Period;

/// Numbering of ends, from the numbers of features and joints of the parts.
#[derive(Debug, Clone, Copy)]
pub(super) struct EndNames {
    fixed_features: u32,
    fixed_joints: u32,
    moving_features: u32,
    moving_joints: u32,
}

impl EndNames {
    pub(super) fn new(fixed: &Outline, moving: &Outline) -> Self {
        Self {
            fixed_features: fixed.features.len() as u32,
            fixed_joints: fixed.joints.len() as u32,
            moving_features: moving.features.len() as u32,
            moving_joints: moving.joints.len() as u32,
        }
    }

    /// A joint of the fixed part on a feature of the moving part.
    pub(super) fn fixed_joint(&self, joint: u32, feature: u32) -> u32 {
        joint * self.moving_features + feature
    }

    /// A feature of the fixed part on a joint of the moving part.
    pub(super) fn moving_joint(&self, feature: u32, joint: u32) -> u32 {
        self.fixed_joints * self.moving_features + feature * self.moving_joints + joint
    }

    pub(super) fn first_vertex(&self) -> u32 {
        self.moving_joint(self.fixed_features, 0)
    }

    pub(super) fn vertices(&self, fixed: u32, moving: u32) -> u32 {
        self.first_vertex() + fixed * self.moving_features + moving
    }

    /// The name of the corresponding end one period lower.
    pub(super) fn name_below(&self, name: u32, period: &Period) -> u32 {
        let (fixed, moving) = (&period.fixed_back, &period.moving_back);
        let split = |n: u32, by: u32| ((n / by) as usize, (n % by) as usize);
        if name < self.moving_joint(0, 0) {
            let (joint, feature) = split(name, self.moving_features);
            self.fixed_joint(fixed.joints[joint], moving.features[feature])
        } else if name < self.first_vertex() {
            let (feature, joint) = split(name - self.moving_joint(0, 0), self.moving_joints);
            self.moving_joint(fixed.features[feature], moving.joints[joint])
        } else {
            let (a, b) = split(name - self.first_vertex(), self.moving_features);
            self.vertices(fixed.features[a], moving.features[b])
        }
    }
}

#[cfg(test)]
mod tests;

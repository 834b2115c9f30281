//! Names of the ends of contact curves: equal for the curves that share an end.

use std::collections::HashMap;

use crate::feature::Outline;

use super::twist::Carried;

/// How many features and joints there are, by which names of ends are made.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes {
    fixed_features: u32,
    fixed_joints: u32,
    moving_features: u32,
    moving_joints: u32,
}

impl Sizes {
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

    /// The name of the same end one slab lower.
    pub(super) fn name_below(&self, name: u32, carried: &Carried) -> u32 {
        let (fixed, moving) = (&carried.fixed_back, &carried.moving_back);
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

/// Contact curves that are points: an arc in a fillet that it just fits.
///
/// The curves before and after such a one would cross at a distance below rounding. They share the point as an end
/// instead, as curves do where two vertices touch; so its four ends get one name, one of two vertices.
#[derive(Debug, Default)]
pub(super) struct Points {
    names: HashMap<u32, u32>,
}

impl Points {
    /// Gives the ends of the curve of two features one name, and all that have been given one together with them.
    pub(super) fn unite(&mut self, point: u32, ends: [u32; 4]) {
        let known = ends.map(|e| self.names.get(&e).copied());
        let name = known.into_iter().flatten().fold(point, u32::min);
        for n in self.names.values_mut() {
            if known.contains(&Some(*n)) {
                *n = name;
            }
        }
        self.names.extend(ends.map(|e| (e, name)));
        self.names.insert(point, name);
    }

    /// The name by which an end is known.
    pub(super) fn name(&self, end: u32) -> u32 {
        self.names.get(&end).copied().unwrap_or(end)
    }
}

#[cfg(test)]
mod tests;

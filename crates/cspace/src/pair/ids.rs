//! A feature of one of two parts, by name.

use crate::feature::FeatureName;
use crate::fixed_axes::Role;

/// A feature of one of the two parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FeatureId {
    /// Part that has the feature.
    pub part: Role,
    /// Kind, loop and vertex of the feature.
    pub name: FeatureName,
}

impl FeatureId {
    /// A feature of the fixed part.
    pub const fn of_fixed(name: FeatureName) -> Self {
        Self {
            part: Role::Fixed,
            name,
        }
    }

    /// A feature of the moving part.
    pub const fn of_moving(name: FeatureName) -> Self {
        Self {
            part: Role::Moving,
            name,
        }
    }
}

/// Text such as `line 3 of loop 0 of the fixed part`.
impl core::fmt::Display for FeatureId {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} of the {} part", self.name, self.part)
    }
}

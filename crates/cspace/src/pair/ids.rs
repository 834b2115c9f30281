//! Numbers of the elements of a space. Each kind has its own type, so that they cannot be confused.

use crate::feature::FeatureName;
use crate::fixed_axes::Role;

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(transparent))]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub struct $name(pub u32);

        impl $name {
            /// The number as an index, from 0.
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl core::fmt::Display for $name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}

id! {
    /// The number of a contact patch, in the order of [`PairSpace::patches`](crate::PairSpace::patches).
    PatchId
}
id! {
    /// The number of a free region, in the order of [`PairSpace::regions`](crate::PairSpace::regions).
    RegionId
}
id! {
    /// The number of a link between two patches, in the order of [`PairSpace::links`](crate::PairSpace::links).
    LinkId
}

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

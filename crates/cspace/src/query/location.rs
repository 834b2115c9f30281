//! Where a configuration is: its class, or its free region, contact, blocked, or outside what was computed.

use crate::ids::RegionId;

/// Class of a configuration: free, blocked or in contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Classification {
    /// The parts do not overlap.
    Free,
    /// Their interiors meet.
    Blocked,
    /// They touch, within the resolution.
    Contact,
}

/// Location of a configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Location {
    /// The parts are apart, in this free region.
    Free(RegionId),
    /// The parts touch, within the resolution.
    Contact,
    /// The parts overlap.
    Blocked,
    /// The configuration is not finite, or outside the window of orientations or the ranges of motion: nothing was computed there.
    Outside,
}

impl Location {
    /// The class of the configuration; `None` outside.
    pub const fn class(self) -> Option<Classification> {
        match self {
            Self::Free(_) => Some(Classification::Free),
            Self::Contact => Some(Classification::Contact),
            Self::Blocked => Some(Classification::Blocked),
            Self::Outside => None,
        }
    }

    /// The free region; `None` where the parts touch or overlap, and outside.
    pub const fn region(self) -> Option<RegionId> {
        match self {
            Self::Free(region) => Some(region),
            _ => None,
        }
    }
}

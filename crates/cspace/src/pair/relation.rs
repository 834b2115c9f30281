//! Relation of two parts, and the class of pair that follows from it.

use crate::fixed_axes::Axis;
use crate::geometry::Configuration;

use super::lower::Joint;

/// The classes of pairs, by the method that computes them (section 3.2 of Sacks 1999).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum PairClass {
    /// A joint connects the two parts: their relative motion does not come from contact.
    Lower,
    /// Each part turns about a fixed point, slides along a fixed line or does not move.
    FixedAxes,
    /// At least one part is planar, and one of the two parts has a rotational symmetry.
    Symmetric,
    /// At least one part is planar.
    General,
}

impl PairClass {
    /// The class as printed: `lower`, `fixed-axes`, `symmetric` or `general`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lower => "lower",
            Self::FixedAxes => "fixed-axes",
            Self::Symmetric => "symmetric",
            Self::General => "general",
        }
    }
}

impl core::fmt::Display for PairClass {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

/// Possible motion of the two parts of a pair relative to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Relation {
    /// Motion by a joint, within limits (radians or the model's unit of length) if there are any.
    Joint(Joint, Option<(f64, f64)>),
    /// Motion of each part on its own axis.
    Axes {
        /// Axis of the fixed part.
        fixed: Axis,
        /// Axis of the moving part.
        moving: Axis,
    },
    /// Motion in the plane, with three degrees of freedom.
    Planar,
}

/// A configuration, or its rates, in the coordinates of a pair's class.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(untagged))]
pub enum Coordinates {
    /// Position and orientation of the moving part in the fixed part's frame: lower, symmetric and general pairs.
    Planar(Configuration),
    /// The motions of the fixed and of the moving part: pairs with fixed axes.
    Axes {
        /// Motion of the fixed part, radians or the model's unit of length.
        u: f64,
        /// Motion of the moving part, radians or the model's unit of length.
        v: f64,
    },
}

impl Coordinates {
    /// The motions of the fixed and of the moving part.
    pub(super) const fn of_axes((u, v): (f64, f64)) -> Self {
        Self::Axes { u, v }
    }

    /// Names of the coordinates.
    pub const fn names(self) -> &'static str {
        match self {
            Self::Planar(_) => "x, y and theta",
            Self::Axes { .. } => "u and v",
        }
    }
}

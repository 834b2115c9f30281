//! Contact curves as patches of the one band a fixed-axes pair has.

use crate::feature::FeatureName;

/// A contact curve: where one pair of features touches, on the boundary of free space.
///
/// It is travelled with blocked space on its left and free space on its right in the (u, v) plane. It has no upper or lower
/// neighbours; where it ends without a neighbour, a motion is at its limit (section 3.2 of Sacks 1999).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesPatch {
    /// The feature of the fixed part.
    pub fixed: FeatureName,
    /// The feature of the moving part.
    pub moving: FeatureName,
    /// Its branches, indices into [`FixedAxesSpace::branches`](super::FixedAxesSpace::branches), in order of travel.
    pub branches: core::ops::Range<u32>,
    /// The contact curve before it, on its left side.
    pub previous: Option<u32>,
    /// The contact curve after it.
    pub next: Option<u32>,
    /// The free region it bounds.
    pub region: Option<u32>,
}

/// What is a function of what on a branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum BranchForm {
    /// v is a monotone function of u, or constant.
    VOfU,
    /// u is a monotone function of v, or constant.
    UOfV,
}

/// A piece of a contact curve on which one coordinate is a monotone function of the other, in closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesBranch {
    /// The contact curve it belongs to.
    pub patch: u32,
    /// What is a function of what.
    pub form: BranchForm,
    /// The configuration (u, v) at which travel along it begins; v and u are continuous along the branch.
    pub start: (f64, f64),
    /// Where it ends.
    pub end: (f64, f64),
    /// The cell of the arrangement.
    pub(super) cell: u32,
}

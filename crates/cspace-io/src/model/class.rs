//! How the parts of a pair can move relative to each other.

use super::{Model, Motion, Pair};

/// What kind of contact space a pair has, by the freedoms the model gives its parts.
///
/// Symmetry of the outlines refines [`PairClass::General`]; it is not looked at here.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PairClass {
    /// A joint connects the two parts: their relative motion does not come from contact.
    Lower,
    /// Each part turns about a fixed point, slides along a fixed line or does not move.
    FixedAxes,
    /// At least one part is planar.
    General,
}

impl PairClass {
    /// The class as printed: `lower`, `fixed-axes` or `general`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lower => "lower",
            Self::FixedAxes => "fixed-axes",
            Self::General => "general",
        }
    }
}

impl core::fmt::Display for PairClass {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

impl Model {
    /// The class of a pair: lower if a joint names both parts, in either order; otherwise general if
    /// either is planar; otherwise fixed-axes.
    ///
    /// Only a joint between the two parts themselves counts, not a chain of joints. An index that
    /// is no part's counts as planar.
    ///
    /// ```
    /// use cspace_io::{Model, PairClass};
    /// let model = Model::from_toml(
    ///     r#"
    ///     [[part]]
    ///     name = "frame"
    ///     loops = [[[0, 0], [4, 0], [0, 4]]]
    ///     motion = { type = "fixed" }
    ///     [[part]]
    ///     name = "wheel"
    ///     loops = [[[6, 0, 1], [8, 0, 1]]]
    ///     motion = { type = "revolute", center = [7, 0] }
    ///     "#,
    ///     "wheel.toml",
    /// )?;
    /// assert_eq!(model.pair_class(&model.pairs[0]), PairClass::FixedAxes);
    /// # Ok::<(), cspace_io::ModelError>(())
    /// ```
    pub fn pair_class(&self, pair: &Pair) -> PairClass {
        let (a, b) = (pair.fixed, pair.moving);
        if (self.joints.iter()).any(|j| j.parts == (a, b) || j.parts == (b, a)) {
            return PairClass::Lower;
        }
        let planar = |i: usize| self.parts.get(i).is_none_or(|p| p.motion == Motion::Planar);
        if planar(a) || planar(b) {
            PairClass::General
        } else {
            PairClass::FixedAxes
        }
    }
}

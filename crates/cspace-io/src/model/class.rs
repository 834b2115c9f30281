//! How the parts of a pair can move relative to each other.

use cspace::fixed_axes::{Axis, AxisMotion};
use cspace::pair::Joint;
use cspace::{LowerPair, PairClass, Point, Relation};

use super::{JointKind, Model, Motion, Pair};

impl Model {
    /// How the parts of a pair are related: by a joint if one names both, in either order; otherwise in the plane if either
    /// is planar; otherwise each on its own axis.
    ///
    /// Only a joint between the two parts themselves counts, not a chain of joints. An index that is no part's counts as
    /// planar. The limits of a joint are those that follow from the parts' own ranges of motion.
    ///
    /// ```
    /// use cspace::{PairClass, Relation};
    /// use cspace_io::Model;
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
    /// assert!(matches!(model.relation(&model.pairs[0]), Relation::Axes { .. }));
    /// assert_eq!(model.pair_class(&model.pairs[0]), PairClass::FixedAxes);
    /// # Ok::<(), cspace_io::ModelError>(())
    /// ```
    pub fn relation(&self, pair: &Pair) -> Relation {
        let (a, b) = (pair.fixed, pair.moving);
        let axis = |i: usize| self.parts.get(i).and_then(|p| axis(&p.motion));
        let (fixed, moving) = (axis(a), axis(b));
        if let Some(j) = (self.joints.iter()).find(|j| j.parts == (a, b) || j.parts == (b, a)) {
            let joint = match j.kind {
                JointKind::Revolute { at } => Joint::Revolute { at },
                JointKind::Prismatic { direction, at } => Joint::Prismatic {
                    direction,
                    at: at.unwrap_or(Point::ORIGIN),
                },
                JointKind::Rigid => Joint::Rigid,
            };
            let limits = fixed
                .zip(moving)
                .and_then(|(f, m)| LowerPair::limits_from_axes(&joint, &f, &m));
            return Relation::Joint(joint, limits);
        }
        match (fixed, moving) {
            (Some(fixed), Some(moving)) => Relation::Axes { fixed, moving },
            _ => Relation::Planar,
        }
    }

    /// The class of a pair by its [`relation`](Self::relation). Symmetry of the outlines, which makes a general pair
    /// symmetric, is not looked at here.
    pub fn pair_class(&self, pair: &Pair) -> PairClass {
        match self.relation(pair) {
            Relation::Joint(..) => PairClass::Lower,
            Relation::Axes { .. } => PairClass::FixedAxes,
            Relation::Planar => PairClass::General,
        }
    }
}

/// The axis of a motion; `None` for a part that is planar.
pub(super) fn axis(motion: &Motion) -> Option<Axis> {
    let (motion, range) = match *motion {
        Motion::Fixed => (AxisMotion::Fixed, None),
        Motion::Revolute { center, range } => (AxisMotion::Revolute { center }, range),
        Motion::Prismatic { direction, range } => (AxisMotion::Prismatic { direction }, range),
        Motion::Planar => return None,
    };
    Some(Axis { motion, range })
}

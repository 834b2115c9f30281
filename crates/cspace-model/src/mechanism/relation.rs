//! Relation of the parts of a pair.

use cspace::fixed_axes::Axis;
use cspace::pair::{LowerPair, PairClass, PairError, PairSpace, Relation};
use cspace::part::Part;
use cspace::space::{Options, Progress, Silent};

use super::check::MechanismError;
use super::entries::{JointEntry, Mechanism, PairEntry};

/// A way to come by the configuration space of two parts: to compute it, or to read what was computed before.
pub type Compute<'a> =
    dyn Fn(&Part, &Part, Relation, &Options) -> Result<PairSpace, PairError> + Sync + 'a;

/// The [`Compute`] that computes every space, with a report of every stage to `progress`.
pub fn compute_anew(
    progress: &dyn Progress,
) -> impl Fn(&Part, &Part, Relation, &Options) -> Result<PairSpace, PairError> + Sync {
    move |fixed, moving, relation, options| {
        PairSpace::compute_with(fixed, moving, relation, options, progress)
    }
}

impl Mechanism {
    /// The joint that connects two parts, by their numbers.
    pub fn joint(&self, a: usize, b: usize) -> Option<&JointEntry> {
        let mut joints = self.joints.iter();
        joints.find(|j| j.parts == (a, b) || j.parts == (b, a))
    }

    /// Relation of the parts of a pair: by a joint if one names both, in either order; otherwise in the plane if either is planar;
    /// otherwise each on its own axis.
    ///
    /// Only a joint between the two parts themselves counts, not a chain of joints. An index without a part counts as planar. The limits of
    /// a joint follow from the parts' own ranges of motion.
    ///
    /// ```
    /// use cspace::pair::Joint;
    /// use cspace::{Part, Point, Relation};
    /// use cspace_model::{JointEntry, Mechanism, PairEntry, PartEntry};
    /// let mut mechanism = Mechanism::new("wheel in a frame");
    /// mechanism.parts.push(PartEntry::fixed(Part::rectangle("frame", (0.0, 0.0), 4.0, 4.0)?));
    /// mechanism.parts.push(PartEntry::revolute(Part::circle("wheel", (7.0, 0.0), 1.0)?, (7.0, 0.0)));
    /// let pair = PairEntry { fixed: 0, moving: 1, window: None };
    /// assert!(matches!(mechanism.relation(&pair), Relation::Axes { .. }));
    /// let joint = Joint::Revolute { at: Point::new(7.0, 0.0) };
    /// mechanism.joints.push(JointEntry { joint, parts: (0, 1) });
    /// assert!(matches!(mechanism.relation(&pair), Relation::Joint(..)));
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn relation(&self, pair: &PairEntry) -> Relation {
        let (a, b) = (pair.fixed, pair.moving);
        let axis = |i: usize| -> Option<Axis> { self.parts.get(i).and_then(|p| p.axis) };
        let (fixed, moving) = (axis(a), axis(b));
        if let Some(j) = self.joint(a, b) {
            let limits = fixed
                .zip(moving)
                .and_then(|(f, m)| LowerPair::limits_from_axes(&j.joint, &f, &m));
            return Relation::Joint(j.joint, limits);
        }
        match (fixed, moving) {
            (Some(fixed), Some(moving)) => Relation::Axes { fixed, moving },
            _ => Relation::Planar,
        }
    }

    /// The class of a pair by its [`relation`](Self::relation). Symmetry of the outlines, which makes a general pair symmetric, is ignored
    /// here.
    pub fn pair_class(&self, pair: &PairEntry) -> PairClass {
        match self.relation(pair) {
            Relation::Joint(..) => PairClass::Lower,
            Relation::Axes { .. } => PairClass::FixedAxes,
            Relation::Planar => PairClass::General,
        }
    }

    /// Computes the configuration space of a pair by the method of its class, over the pair's window unless the options
    /// have one.
    ///
    /// # Errors
    /// If an index has no part; and as [`PairSpace::compute`].
    pub fn compute(
        &self,
        pair: &PairEntry,
        options: &Options,
    ) -> Result<PairSpace, MechanismError> {
        self.compute_with(pair, options, &Silent)
    }

    /// As [`compute`](Self::compute), with a report of every stage of the general method to `progress`.
    ///
    /// # Errors
    /// As [`compute`](Self::compute); and errors returned by `progress`.
    pub fn compute_with(
        &self,
        pair: &PairEntry,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<PairSpace, MechanismError> {
        self.compute_by(pair, options, &compute_anew(progress))
    }

    /// As [`compute`](Self::compute), with the space from elsewhere.
    ///
    /// # Errors
    /// If an index is no part's; and what `compute` returns.
    pub fn compute_by(
        &self,
        pair: &PairEntry,
        options: &Options,
        compute: &Compute<'_>,
    ) -> Result<PairSpace, MechanismError> {
        let [fixed, moving] = [pair.fixed, pair.moving].map(|i| self.parts.get(i));
        let (Some(fixed), Some(moving)) = (fixed, moving) else {
            return Err(MechanismError::NoSuchPart {
                part: pair.fixed.max(pair.moving),
                parts: self.parts.len(),
            });
        };
        let relation = self.relation(pair);
        let window = match relation {
            Relation::Planar => options.window.or(pair.window),
            _ => options.window,
        };
        let options = Options { window, ..*options };
        let space = compute(&fixed.part, &moving.part, relation, &options);
        space.map_err(|error: PairError| MechanismError::Pair {
            fixed: fixed.part.name().to_owned(),
            moving: moving.part.name().to_owned(),
            error,
        })
    }
}

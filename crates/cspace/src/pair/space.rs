//! The configuration space of a pair of any class.

use std::sync::Arc;

use crate::fixed_axes::{AxesError, FixedAxesSpace};
use crate::part::Part;
use crate::space::{ComputeError, ContactSpace, FeatureCounts, Options, Progress, Silent};

use super::lower::LowerPair;
use super::relation::{PairClass, Relation};

/// The configuration space of two parts, computed by the method of their class.
///
/// ```
/// use cspace::fixed_axes::{Axis, AxisMotion};
/// use cspace::pair::{Coordinates, PairClass, PairSpace, Relation};
/// use cspace::{Classification, Options, Part, Point, Vector, Vertex};
/// let square = |name: &str, x: f64| {
///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// // A block that turns about its centre, and another that slides towards it.
/// let relation = Relation::Axes {
///     fixed: Axis::revolute(Point::ORIGIN),
///     moving: Axis::prismatic(Vector::new(-1.0, 0.0)),
/// };
/// let space = PairSpace::compute(&square("turner", 0.0)?, &square("slider", 5.0)?, relation, &Options::default())?;
/// assert_eq!(space.class(), PairClass::FixedAxes);
/// let at = |u, v| space.classify(Coordinates::Axes { u, v });
/// assert_eq!(at(0.0, 2.9)?, Classification::Free);
/// assert_eq!(at(std::f64::consts::FRAC_PI_4, 2.9)?, Classification::Blocked);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub enum PairSpace {
    /// Space of a lower pair.
    Lower(Box<LowerPair>),
    /// Space of a pair with fixed axes.
    FixedAxes(Box<FixedAxesSpace>),
    /// Space of a general pair, computed with or without symmetry.
    Planar(Arc<ContactSpace>),
}

/// Reasons for which the configuration space of a pair cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PairError {
    /// An axis of a part is invalid.
    #[error(transparent)]
    Axes(#[from] AxesError),
    /// The contact space cannot be computed.
    #[error(transparent)]
    Compute(#[from] ComputeError),
    /// A window of orientations was given for a pair without orientation as a coordinate.
    #[error("a window of orientations has no meaning for a {class} pair")]
    Window {
        /// The class.
        class: PairClass,
    },
}

impl PairSpace {
    /// Computes the configuration space of two parts by the method of their class.
    ///
    /// # Errors
    /// If axes or options are invalid for the pair, or a contact space is too large.
    pub fn compute(
        fixed: &Part,
        moving: &Part,
        relation: Relation,
        options: &Options,
    ) -> Result<Self, PairError> {
        Self::compute_with(fixed, moving, relation, options, &Silent)
    }

    /// As [`compute`](Self::compute), with a report of every stage of the general method to `progress`.
    ///
    /// # Errors
    /// As [`compute`](Self::compute); and errors returned by `progress`.
    pub fn compute_with(
        fixed: &Part,
        moving: &Part,
        relation: Relation,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<Self, PairError> {
        let class = match relation {
            Relation::Joint(..) => PairClass::Lower,
            Relation::Axes { .. } => PairClass::FixedAxes,
            Relation::Planar => PairClass::General,
        };
        if options.window.is_some() && class != PairClass::General {
            return Err(PairError::Window { class });
        }
        Ok(match relation {
            Relation::Joint(joint, limits) => {
                Self::Lower(Box::new(LowerPair::new(fixed, moving, joint, limits)))
            }
            Relation::Axes {
                fixed: a,
                moving: b,
            } => Self::FixedAxes(Box::new(FixedAxesSpace::compute(fixed, a, moving, b)?)),
            Relation::Planar => Self::Planar(Arc::new(ContactSpace::compute_with(
                fixed, moving, options, progress,
            )?)),
        })
    }

    /// The class of the pair. A pair is symmetric if symmetry was looked for and found, even if it saved no work: see
    /// [`PairSymmetry::slabs`](crate::PairSymmetry::slabs).
    pub fn class(&self) -> PairClass {
        match self {
            Self::Lower(_) => PairClass::Lower,
            Self::FixedAxes(_) => PairClass::FixedAxes,
            Self::Planar(space) if space.symmetry().is_any() => PairClass::Symmetric,
            Self::Planar(_) => PairClass::General,
        }
    }

    /// The fixed part.
    pub fn fixed(&self) -> &Part {
        match self {
            Self::Lower(pair) => pair.fixed(),
            Self::FixedAxes(space) => space.fixed(),
            Self::Planar(space) => space.fixed(),
        }
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        match self {
            Self::Lower(pair) => pair.moving(),
            Self::FixedAxes(space) => space.moving(),
            Self::Planar(space) => space.moving(),
        }
    }

    /// Lines, arcs and vertices that are not smooth joints, of both parts.
    pub fn features(&self) -> FeatureCounts {
        match self {
            Self::Planar(space) => space.features(),
            _ => FeatureCounts::of(self.fixed(), self.moving()),
        }
    }

    /// The minimum clearance, in the model's unit of length: a smaller clearance counts as none.
    pub fn least_clearance(&self) -> f64 {
        match self {
            Self::Planar(space) => space.least_clearance(),
            _ => self.resolution(),
        }
    }

    /// The resolution in the model's unit of length: the accuracy of contacts.
    pub fn resolution(&self) -> f64 {
        match self {
            Self::Lower(pair) => pair.resolution(),
            Self::FixedAxes(space) => space.resolution(),
            Self::Planar(space) => space.resolution(),
        }
    }

    /// Distance from a contact below which [`classify`](Self::classify) returns contact, in the model's unit of length. It is the
    /// [`resolution`](Self::resolution) or less: the resolution includes the displacement of contacts by the growth of sharp corners; this
    /// distance is measured from the contact as computed.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Classification, Options, PairSpace, Part, Relation};
    /// let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
    /// let coin = Part::circle("coin", (0.0, 0.0), 1.0)?;
    /// let space = PairSpace::compute(&table, &coin, Relation::Planar, &Options::default())?;
    /// let away = |d| space.classify(Coordinates::Planar(Configuration::new(3.0 + d, 0.0, 0.0)));
    /// let near = space.contact_distance();
    /// assert!(near <= space.resolution());
    /// assert_eq!(away(0.5 * near)?, Classification::Contact);
    /// assert_eq!(away(2.0 * near)?, Classification::Free);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn contact_distance(&self) -> f64 {
        match self {
            Self::Lower(pair) => pair.resolution(),
            Self::FixedAxes(space) => space.contact_distance(),
            Self::Planar(space) => space.contact_distance(),
        }
    }

    /// Number of contact patches; for a lower pair, of permanent contacts.
    pub fn patch_count(&self) -> usize {
        match self {
            Self::Lower(pair) => pair.contacts().len(),
            Self::FixedAxes(space) => space.patches().len(),
            Self::Planar(space) => space.patches().len(),
        }
    }

    /// Number of bands; 1 for a space without orientations.
    pub fn band_count(&self) -> usize {
        match self {
            Self::Planar(space) => space.bands().len(),
            _ => 1,
        }
    }

    /// Number of connected components of free space; 0 for a lower pair, whose configurations are all in contact.
    pub fn region_count(&self) -> usize {
        match self {
            Self::Lower(_) => 0,
            Self::FixedAxes(space) => space.regions().len(),
            Self::Planar(space) => space.free_regions().len(),
        }
    }
}

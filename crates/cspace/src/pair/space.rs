//! The configuration space of a pair of any class, how it is computed, and its plain properties.

use std::sync::Arc;

use crate::fixed_axes::{AxesError, FixedAxesSpace};
use crate::geometry::Configuration;
use crate::parallel;
use crate::part::Part;
use crate::space::{ComputeError, ContactSpace, FeatureCounts, Options, Progress, Silent};

use super::answers::QueryError;
use super::data::PairData;
use super::lower::LowerPair;
use super::relation::{Coordinates, PairClass, Relation};

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

/// A space by its class, and a configuration in its coordinates.
pub(super) enum ByClass<'a> {
    Lower(&'a LowerPair, Configuration),
    Axes(&'a FixedAxesSpace, f64, f64),
    Planar(&'a ContactSpace, Configuration),
}

impl ByClass<'_> {
    /// Placement of the moving part in the fixed part's frame.
    pub(super) fn placed(&self) -> Configuration {
        match *self {
            Self::Axes(space, u, v) => space.configuration(u, v),
            Self::Planar(_, c) | Self::Lower(_, c) => c,
        }
    }
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

    /// Computes the spaces of many pairs, passes each with the pair's number to `then`, and returns the results of `then`, in the order of
    /// the pairs.
    ///
    /// It is meant for many small pairs, such as the variants of a tolerance study: pairs go to the threads of the `rayon` pool from which
    /// it is called, and each is computed by a single thread, which is faster than dividing every one of them. A space is dropped after
    /// `then` unless `then` keeps it, so that memory does not grow with the number of pairs. The spaces are those of
    /// [`compute`](Self::compute), and the results do not depend on the number of threads.
    ///
    /// ```
    /// use cspace::{Options, PairSpace, Part, Relation};
    /// // How large a play does a pin need to be free in a hole, among 0, 0.1 and 0.2?
    /// let plate = |play: f64| {
    ///     let hole = Part::circle("hole", (0.0, 0.0), 1.0 + play)?.loops()[0].vertices().to_vec();
    ///     let edge = Part::rectangle("edge", (0.0, 0.0), 4.0, 4.0)?.loops()[0].vertices().to_vec();
    ///     Part::new("plate", vec![edge, hole])
    /// };
    /// let pin = Part::circle("pin", (0.0, 0.0), 1.0)?;
    /// let plates = [plate(0.0)?, plate(0.1)?, plate(0.2)?];
    /// let pairs: Vec<_> = plates.iter().map(|p| (p, &pin, Relation::Planar)).collect();
    /// let regions = PairSpace::compute_each(&pairs, &Options::default(), |_, space| {
    ///     space.map(|s| s.region_count())
    /// });
    /// // Beside the region outside there is one in the hole, where there is play.
    /// assert_eq!(regions, [Ok(1), Ok(2), Ok(2)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compute_each<R: Send>(
        pairs: &[(&Part, &Part, Relation)],
        options: &Options,
        then: impl Fn(usize, Result<Self, PairError>) -> R + Sync + Send,
    ) -> Vec<R> {
        parallel::each(pairs, |i, &(fixed, moving, relation)| {
            then(i, Self::compute(fixed, moving, relation, options))
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

    /// The space by its class, with a configuration in its own coordinates.
    pub(super) fn by_class(&self, at: Coordinates) -> Result<ByClass<'_>, QueryError> {
        match (self, at) {
            (Self::Lower(pair), Coordinates::Planar(c)) => Ok(ByClass::Lower(pair, c)),
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => Ok(ByClass::Axes(space, u, v)),
            (Self::Planar(space), Coordinates::Planar(c)) => Ok(ByClass::Planar(space, c)),
            _ => Err(QueryError::coordinates(self.class(), at)),
        }
    }

    /// As [`by_class`](Self::by_class), for a configuration for which something was computed.
    pub(super) fn covered(&self, at: Coordinates) -> Result<ByClass<'_>, QueryError> {
        let here = self.by_class(at)?;
        let covered = match here {
            ByClass::Lower(_, c) => c.position().is_finite() && c.theta.is_finite(),
            ByClass::Axes(space, u, v) => space.covers(u, v),
            ByClass::Planar(space, c) => space.covers(c),
        };
        covered.then_some(here).ok_or(QueryError::Outside)
    }

    /// The space of a pair with orientation as a coordinate.
    pub(super) fn oriented(&self) -> Result<&ContactSpace, QueryError> {
        match self {
            Self::Planar(space) => Ok(space),
            _ => {
                let class = self.class();
                Err(QueryError::NoOrientation { class })
            }
        }
    }

    /// Returns an error for a lower pair, which is in permanent contact.
    pub(super) fn refuse_lower(&self) -> Result<(), QueryError> {
        match self {
            Self::Lower(_) => Err(QueryError::Permanent),
            _ => Ok(()),
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
        self.bands().map_or(1, |bands| bands.len())
    }

    /// The space as plain data.
    pub fn data(&self) -> PairData<'_> {
        match self {
            Self::Planar(space) => PairData::Planar(space.data()),
            Self::FixedAxes(space) => PairData::FixedAxes(space.data()),
            Self::Lower(pair) => PairData::Lower(Box::new(pair.data())),
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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::part::Vertex;

    /// Spaces are equal, and in order, on one thread, on several, and one by one.
    #[test]
    fn batches_are_spaces_one_by_one() {
        let star = |points: u32, inner: f64| {
            let at = |k: u32| {
                let angle = core::f64::consts::PI * f64::from(k) / f64::from(points);
                let r = if k.is_multiple_of(2) { 1.0 } else { inner };
                Vertex::new(r * angle.cos(), r * angle.sin(), 0.1 * inner)
            };
            Part::new("star", vec![(0..2 * points).map(at).collect()]).unwrap()
        };
        let parts: Vec<Part> = (0..12)
            .map(|k| star(2 + k % 4, 0.4 + 0.03 * f64::from(k)))
            .collect();
        let pairs: Vec<_> = (parts.windows(2))
            .map(|w| (&w[0], &w[1], Relation::Planar))
            .collect();
        let options = Options::default();
        let patches = |space: Result<PairSpace, PairError>| match space.unwrap() {
            PairSpace::Planar(space) => space.patches().to_vec(),
            _ => unreachable!(),
        };
        let one_by_one: Vec<_> = (pairs.iter().enumerate())
            .map(|(i, p)| (i, patches(PairSpace::compute(p.0, p.1, p.2, &options))))
            .collect();
        for threads in [1, 3] {
            let run = || PairSpace::compute_each(&pairs, &options, |i, space| (i, patches(space)));
            #[cfg(feature = "rayon")]
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            #[cfg(feature = "rayon")]
            let all = pool.build().unwrap().install(run);
            #[cfg(not(feature = "rayon"))]
            let (_, all) = (threads, run());
            assert!(all == one_by_one);
        }
    }
}

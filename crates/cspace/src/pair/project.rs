//! The configuration of a patch that is nearest to a given one.

use super::space::ByClass;
use super::{Coordinates, PairSpace, QueryError};
use crate::ids::PatchId;

/// Metric on configurations.
///
/// | class | distance² |
/// |---|---|
/// | general, symmetric | Δx² + Δy² + (ρ Δθ)² |
/// | fixed axes | (aᵤ Δu)² + (aᵥ Δv)², with a = ρ for a part that turns and a = 1 for one that slides |
///
/// Angles are in radians; ρ is a length, for example the distance of the moving part's outline from its centre of rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Metric {
    /// ρ: the length that a radian counts, in the model's unit. Positive.
    pub length_per_radian: f64,
}

/// The nearest configuration of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Projection {
    /// The configuration in contact.
    pub at: Coordinates,
    /// Its distance by the metric, in the model's unit of length.
    pub distance: f64,
}

impl PairSpace {
    /// The configuration of a patch that is nearest to a given one by a [`Metric`].
    ///
    /// The given configuration may be free, blocked, or outside the window or the ranges of motion. Orientations, and coordinates of parts
    /// on fixed axes that turn without limits, are taken modulo a turn: the result has the image nearest to the given one; for a space with
    /// a window, the image in the window.
    ///
    /// No configuration of the patch is nearer by more than 2⁻³⁷ ≈ 7·10⁻¹² of the pair's size and 10⁻¹² of the distance. This is certain,
    /// not sampled: over intervals of orientation, or of a coordinate, the distance and its derivative are enclosed, and intervals are
    /// halved until none can contain a nearer configuration. Where an end of the patch is itself known less accurately, because two
    /// contacts are almost tangent there, so is the result.
    ///
    /// # Errors
    /// If there is no such patch, the metric is not positive and finite, the configuration is in the coordinates of another class or not
    /// finite, or a part that does not move is not at 0; and for a lower pair, which is in permanent contact.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Metric, Options, PairSpace, Part, PatchId, Relation};
    /// let (table, coin) = (Part::circle("table", [0.0, 0.0], 2.0)?, Part::circle("coin", [0.5, 0.0], 1.0)?);
    /// let space = PairSpace::compute(&table, &coin, Relation::Planar, &Options::default())?;
    /// // The coin, which is drawn half a unit off its origin, above the table.
    /// let at = Coordinates::Planar(Configuration::new(0.0, 5.0, 0.0));
    /// let metric = Metric { length_per_radian: 0.1 };
    /// let projections = (0..space.patch_count() as u32).map(|i| space.project(at, PatchId(i), metric));
    /// let all: Vec<_> = projections.collect::<Result<_, _>>()?;
    /// let nearest = all.iter().map(|p| p.distance).fold(f64::INFINITY, f64::min);
    /// // To move down without turning is farther than to turn its centre down a little on the way.
    /// let straight = space.nearest_contact(at)?.ok_or("there is one")?.distance;
    /// assert!(nearest < straight && straight - nearest < 0.6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn project(
        &self,
        at: Coordinates,
        onto: PatchId,
        metric: Metric,
    ) -> Result<Projection, QueryError> {
        self.patch(onto)?;
        let here = self.measured(at, metric)?;
        let found = here.project(onto, metric.length_per_radian, f64::INFINITY);
        found.ok_or(QueryError::Outside)
    }

    /// The patch that comes nearest to a configuration by a [`Metric`], and its nearest configuration, as given by
    /// [`project`](Self::project); `None` if there is no patch.
    ///
    /// This takes far less time than projecting to all patches: patches that are farther than another are excluded early.
    ///
    /// # Errors
    /// As [`project`](Self::project).
    pub fn nearest_patch(
        &self,
        at: Coordinates,
        metric: Metric,
    ) -> Result<Option<(PatchId, Projection)>, QueryError> {
        let here = self.measured(at, metric)?;
        let rho = metric.length_per_radian;
        // Patches that seem near come first, so that the others are excluded quickly.
        let order = match here {
            ByClass::Planar(space, c) => space.patches_by_distance(c, rho),
            _ => (0..self.patch_count() as u32).map(PatchId).collect(),
        };
        let mut nearest: Option<(PatchId, Projection)> = None;
        for patch in order {
            let known = nearest.map_or(f64::INFINITY, |(_, found)| found.distance);
            let found = here.project(patch, rho, known);
            nearest = found.map(|found| (patch, found)).or(nearest);
        }
        Ok(nearest)
    }

    /// The space with a configuration that can be projected with a metric.
    fn measured(&self, at: Coordinates, metric: Metric) -> Result<ByClass<'_>, QueryError> {
        let rho = metric.length_per_radian;
        if !(rho > 0.0 && (rho * rho).is_normal()) {
            return Err(QueryError::Metric);
        }
        self.refuse_lower()?;
        let here = self.by_class(at)?;
        let numbers = match here {
            ByClass::Axes(_, u, v) => [u, v, 0.0],
            ByClass::Planar(_, c) | ByClass::Lower(_, c) => [c.x, c.y, c.theta],
        };
        let finite = numbers.iter().all(|n| (n * n).is_finite());
        finite.then_some(here).ok_or(QueryError::Outside)
    }
}

impl ByClass<'_> {
    /// The nearest configuration of a patch, if there is one nearer than `known`; a radian counts as the length `rho`.
    fn project(&self, patch: PatchId, rho: f64, known: f64) -> Option<Projection> {
        let (at, distance) = match *self {
            Self::Lower(..) => return None,
            Self::Axes(space, u, v) => {
                let (at, distance) = space.project((u, v), patch, rho, known)?;
                (Coordinates::of_axes(at), distance)
            }
            Self::Planar(space, c) => {
                let (c, distance) = space.project(c, patch, rho, known)?;
                (Coordinates::Planar(c), distance)
            }
        };
        Some(Projection { at, distance })
    }
}

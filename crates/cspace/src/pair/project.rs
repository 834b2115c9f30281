//! The configuration of a patch that is nearest to a given one.

use super::answers::QueryError;
use super::ids::PatchId;
use super::relation::Coordinates;
use super::space::PairSpace;

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
        self.check_projected(at, metric)?;
        let found = self.project_below(at, onto.index(), metric, f64::INFINITY);
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
        self.check_projected(at, metric)?;
        if let (Self::Planar(space), Coordinates::Planar(c)) = (self, at) {
            let found = space.nearest_patch(c, metric.length_per_radian);
            return Ok(found.map(|(patch, c, distance)| {
                let at = Coordinates::Planar(c);
                (PatchId(patch as u32), Projection { at, distance })
            }));
        }
        let mut nearest: Option<(PatchId, Projection)> = None;
        for patch in 0..self.patch_count() {
            let known = nearest.map_or(f64::INFINITY, |(_, found)| found.distance);
            if let Some(found) = self.project_below(at, patch, metric, known) {
                nearest = Some((PatchId(patch as u32), found));
            }
        }
        Ok(nearest)
    }

    /// Checks that a configuration can be projected with a metric.
    fn check_projected(&self, at: Coordinates, metric: Metric) -> Result<(), QueryError> {
        let rho = metric.length_per_radian;
        if !(rho > 0.0 && (rho * rho).is_normal()) {
            return Err(QueryError::Metric);
        }
        let numbers = match (self, at) {
            (Self::Lower(_), _) => return Err(QueryError::Permanent),
            (Self::FixedAxes(_), Coordinates::Axes { u, v }) => [u, v, 0.0],
            (Self::Planar(_), Coordinates::Planar(c)) => [c.x, c.y, c.theta],
            _ => return Err(self.wrong(at)),
        };
        let has_square = |n: f64| (n * n).is_finite();
        match numbers.into_iter().all(has_square) {
            true => Ok(()),
            false => Err(QueryError::Outside),
        }
    }

    /// The nearest configuration of a patch, if there is one nearer than `known`.
    fn project_below(
        &self,
        at: Coordinates,
        patch: usize,
        metric: Metric,
        known: f64,
    ) -> Option<Projection> {
        let rho = metric.length_per_radian;
        let (at, distance) = match (self, at) {
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => {
                let ((u, v), distance) = space.project((u, v), patch, rho, known)?;
                (Coordinates::Axes { u, v }, distance)
            }
            (Self::Planar(space), Coordinates::Planar(c)) => {
                let patch = space.patches().get(patch)?;
                let (c, distance) = space.project(c, patch, rho, known)?;
                (Coordinates::Planar(c), distance)
            }
            _ => return None,
        };
        Some(Projection { at, distance })
    }
}

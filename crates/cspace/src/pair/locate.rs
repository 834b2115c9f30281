//! Location of a configuration: its free region, blocked, or outside the computed range; and the clearance of the parts.

use crate::geometry::Configuration;
use crate::part::distance_of;

use super::answers::QueryError;
use super::ids::RegionId;
use super::relation::Coordinates;
use super::space::PairSpace;
use crate::query::Classification;

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

impl PairSpace {
    /// Location of a configuration.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Location, Options, PairSpace, Part, Relation, Vertex};
    /// let square = |r: f64| -> Vec<Vertex> {
    ///     [(-r, -r), (r, -r), (r, r), (-r, r)].iter().map(|&(x, y)| Vertex::line(x, y)).collect()
    /// };
    /// let ring = Part::new("ring", vec![square(3.0), square(2.0)])?;
    /// let block = Part::new("block", vec![square(1.0)])?;
    /// let space = PairSpace::compute(&ring, &block, Relation::Planar, &Options::default())?;
    /// let at = |x| Coordinates::Planar(Configuration::new(x, 0.0, 0.0));
    /// assert!(matches!(space.locate(at(0.0))?, Location::Free(_)));
    /// assert_ne!(space.locate(at(0.0))?, space.locate(at(9.0))?);
    /// assert_eq!(space.locate(at(2.5))?, Location::Blocked);
    /// assert!(!space.connected(at(0.0), at(9.0))?);
    /// assert!((space.clearance(at(0.3))? - 0.7).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn locate(&self, at: Coordinates) -> Result<Location, QueryError> {
        let class = match self.classify(at) {
            Err(QueryError::Outside) => return Ok(Location::Outside),
            class => class?,
        };
        let region = match (self, at) {
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => space.region_at(u, v),
            (Self::Planar(space), Coordinates::Planar(c)) => space.region_at(c),
            _ => None,
        };
        Ok(match (class, region) {
            (Classification::Contact, _) => Location::Contact,
            (Classification::Free, Some(region)) => Location::Free(RegionId(region)),
            _ => Location::Blocked,
        })
    }

    /// Whether two configurations are free and in one region, so that a motion without overlap leads from one to the other.
    ///
    /// # Errors
    /// If one is in the coordinates of another class.
    pub fn connected(&self, a: Coordinates, b: Coordinates) -> Result<bool, QueryError> {
        let (a, b) = (self.locate(a)?, self.locate(b)?);
        Ok(matches!(a, Location::Free(_)) && a == b)
    }

    /// Clearance of the parts at a configuration: the minimum distance of their boundaries, in the model's unit of length; 0 where they
    /// touch.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class or outside, or the parts overlap there.
    pub fn clearance(&self, at: Coordinates) -> Result<f64, QueryError> {
        match self.classify(at)? {
            Classification::Contact => Ok(0.0),
            Classification::Blocked => Err(QueryError::Blocked),
            Classification::Free => Ok(distance_of(self.fixed(), self.moving(), self.placed(at)?)),
        }
    }

    /// Placement of the moving part in the fixed part's frame.
    pub(super) fn placed(&self, at: Coordinates) -> Result<Configuration, QueryError> {
        match (self, at) {
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => Ok(space.configuration(u, v)),
            (Self::Planar(_) | Self::Lower(_), Coordinates::Planar(c)) => Ok(c),
            _ => Err(self.wrong(at)),
        }
    }
}

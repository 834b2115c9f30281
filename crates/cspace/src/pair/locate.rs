//! Location of a configuration: its free region, blocked, or outside the computed range; the clearance of the parts, and their contacts.

use crate::ids::PatchId;
use crate::part::distance_of;
use crate::query::{Classification, Location};

use super::space::ByClass;
use super::{Coordinates, PairNearest, PairSpace, QueryError};

/// Location of a configuration, and the clearance of the parts.
impl PairSpace {
    /// Whether a configuration is free, blocked or in contact.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion.
    pub fn classify(&self, at: Coordinates) -> Result<Classification, QueryError> {
        self.locate(at)?.class().ok_or(QueryError::Outside)
    }

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
        Ok(match self.by_class(at)? {
            ByClass::Lower(pair, c) => pair.locate(c),
            ByClass::Axes(space, u, v) => space.locate(u, v),
            ByClass::Planar(space, c) => space.locate(c),
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
        match self.locate(at)? {
            Location::Contact => Ok(0.0),
            Location::Blocked => Err(QueryError::Blocked),
            Location::Outside => Err(QueryError::Outside),
            Location::Free(_) => Ok(self.distance(&self.by_class(at)?)),
        }
    }

    /// Distance of the parts' boundaries: their clearance, where they are known not to overlap.
    pub(super) fn distance(&self, at: &ByClass<'_>) -> f64 {
        distance_of(self.fixed(), self.moving(), at.placed())
    }
}

/// Contacts at a configuration, and the nearest one.
impl PairSpace {
    /// The patches whose contact is within `tolerance` (model length) at a configuration, with the distances; the nearest first.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion.
    pub fn contacts(
        &self,
        at: Coordinates,
        tolerance: f64,
    ) -> Result<Vec<(PatchId, f64)>, QueryError> {
        Ok(match self.covered(at)? {
            ByClass::Lower(pair, c) => ((0..).map(PatchId).zip(pair.contacts()))
                .map(|(i, contact)| (i, contact.function.value(c.position(), c.theta).abs()))
                .filter(|&(_, off)| off <= tolerance)
                .collect(),
            ByClass::Axes(space, u, v) => space.contacts(u, v, tolerance),
            ByClass::Planar(space, c) => space.contacts(c, tolerance),
        })
    }

    /// Whether the contact of one patch is within `tolerance` (model length) at a configuration: as [`contacts`](Self::contacts), for a
    /// single patch. False outside the window or the ranges of motion, and if there is no such patch.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class.
    pub fn is_on(
        &self,
        patch: PatchId,
        at: Coordinates,
        tolerance: f64,
    ) -> Result<bool, QueryError> {
        Ok(match self.by_class(at)? {
            ByClass::Lower(..) => (self.contacts(at, tolerance)?.iter()).any(|c| c.0 == patch),
            ByClass::Axes(space, u, v) => space.is_on(patch, u, v, tolerance),
            ByClass::Planar(space, c) => space.covers(c) && space.is_on(patch, c, tolerance),
        })
    }

    /// The contact nearest to a configuration: for a planar pair by translation alone, for a pair with fixed axes by the motion of the
    /// moving part alone ([`FixedAxesSpace::nearest_contact`]). `None` if no such motion leads to a contact.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion, or the parts
    /// are a lower pair, which is in permanent contact.
    ///
    /// [`FixedAxesSpace::nearest_contact`]: crate::FixedAxesSpace::nearest_contact
    pub fn nearest_contact(&self, at: Coordinates) -> Result<Option<PairNearest>, QueryError> {
        let nearest = |patch, at, distance| PairNearest {
            patch,
            at,
            distance,
        };
        Ok(match self.covered(at)? {
            ByClass::Lower(..) => return Err(QueryError::Permanent),
            ByClass::Axes(space, u, v) => (space.nearest_contact(u, v))
                .map(|n| nearest(n.patch, Coordinates::of_axes(n.at), n.distance)),
            ByClass::Planar(space, c) => (space.nearest_contact(c))
                .map(|n| nearest(n.patch, Coordinates::Planar(n.configuration), n.distance)),
        })
    }
}

//! All that the configuration space of a pair of any class can be asked, and its elements; how it is computed is in `space.rs`.

use crate::feature::FeatureName;
use crate::geometry::Vector;
use crate::ids::PatchId;
use crate::query::{Classification, Location};
use crate::space::Band;

use super::space::ByClass;
use super::{
    Coordinates, FeatureContact, Metric, NearFeatures, Neighbours, PairCrossing, PairData,
    PairLink, PairMotion, PairNearest, PairPatch, PairRegion, PairSpace, Projection, QueryError,
    SmoothMotion, SmoothOutcome, graph, locate, motion, near, patch, project,
};

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
        locate::locate(self, at)
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
        locate::clearance(self, at)
    }
}

/// Contacts at a configuration, and those nearest to it.
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
        locate::contacts(self, at, tolerance)
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
        locate::nearest_contact(self, at)
    }

    /// The pairs of features that face each other at a configuration with a distance, or a depth of overlap, of at most `within` (model
    /// length); the nearest first.
    ///
    /// While the parts do not overlap, the distance of the first pair is that of the parts ([`clearance`](Self::clearance)). Both points of
    /// a pair lie on its features: on line segments, arcs and convex vertices, not on their extensions. Patches are not used, so critical
    /// and doubtful orientations make no difference.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, or outside; and for lower pairs, which are in permanent contact.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};
    /// let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
    /// let coin = Part::circle("coin", (0.0, 0.0), 1.0)?;
    /// let space = PairSpace::compute(&table, &coin, Relation::Planar, &Options::default())?;
    /// // Beside the table's corner (2, 2): 5 − 1 from it, and beyond the ends of both sides.
    /// let near = space.near_features(Coordinates::Planar(Configuration::new(5.0, 6.0, 0.0)), 10.0)?;
    /// assert_eq!(near[0].fixed.name.to_string(), "vertex 2 of loop 0");
    /// assert!((near[0].distance - 4.0).abs() < 1e-12);
    /// assert!((near[0].touching.normal.x - 0.6).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn near_features(
        &self,
        at: Coordinates,
        within: f64,
    ) -> Result<Vec<NearFeatures>, QueryError> {
        near::near_features(self, at, within)
    }

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
        project::check(self, at, metric)?;
        let found = project::project_below(self, at, onto, metric, f64::INFINITY);
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
        project::nearest_patch(self, at, metric)
    }
}

/// Contacts along a motion.
impl PairSpace {
    /// The first contact when the configuration moves from `from` at constant `rates` at times from 0 to `duration`.
    ///
    /// # Errors
    /// If coordinates are of another class, numbers are not finite, the motion begins where the parts overlap or outside the space, or the
    /// parts are a lower pair, which is in permanent contact.
    pub fn first_contact(
        &self,
        from: Coordinates,
        rates: Coordinates,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        self.first_contact_about(from, rates, Vector::ZERO, duration)
    }

    /// The first contact of a motion along which the moving part's point `about`, in the part's frame, moves on a straight line: see
    /// [`ContactSpace::first_contact_about`](crate::ContactSpace::first_contact_about). Parts on fixed axes move as their axes let them,
    /// whatever `about` is.
    ///
    /// # Errors
    /// As [`first_contact`](Self::first_contact).
    pub fn first_contact_about(
        &self,
        from: Coordinates,
        rates: Coordinates,
        about: Vector,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        motion::first_contact_about(self, (from, rates), about, duration)
    }

    /// All contacts that a motion of constant rates crosses at times from 0 to `duration`, also where the parts overlap, in order of time.
    ///
    /// # Errors
    /// If coordinates are of another class, numbers are not finite, the motion begins outside the space, or the parts are a
    /// lower pair.
    pub fn crossings(
        &self,
        from: Coordinates,
        rates: Coordinates,
        duration: f64,
    ) -> Result<Vec<PairCrossing>, QueryError> {
        motion::crossings(self, (from, rates), duration)
    }

    /// The first contact along a smooth motion, at times from 0 to `duration`.
    ///
    /// In a time dt, no point of the moving part can come nearer to the fixed part than by dt times a bound on its speed: for a planar
    /// configuration |(ẋ, ẏ)| + ρ |θ̇|, with ρ the largest distance of the part's boundary from its origin; for fixed axes the sum of both
    /// parts' speeds. So the [clearance](Self::clearance) divided by that bound is a time without contact, and steps of such times approach
    /// the first contact without ever passing through one.
    ///
    /// A contact is where the clearance is less than `tolerance` (model length), which is raised to the [resolution](Self::resolution) if
    /// it is smaller.
    ///
    /// # Errors
    /// If coordinates are of another class, or the motion begins where the parts overlap or outside the space, or the parts
    /// are a lower pair.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation, SmoothMotion, SmoothOutcome, Vertex};
    /// let disc = |r: f64| Part::new("disc", vec![vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)]]);
    /// let space = PairSpace::compute(&disc(2.0)?, &disc(1.0)?, Relation::Planar, &Options::default())?;
    /// /// Along the parabola y = x², from the far left.
    /// struct Parabola;
    /// impl SmoothMotion for Parabola {
    ///     fn at(&self, t: f64) -> Coordinates {
    ///         Coordinates::Planar(Configuration::new(t - 3.0, (t - 3.0).powi(2), 0.0))
    ///     }
    ///     fn rate_bounds(&self, from: f64, to: f64) -> [f64; 3] {
    ///         [1.0, 2.0 * (from - 3.0).abs().max((to - 3.0).abs()), 0.0]
    ///     }
    /// }
    /// let SmoothOutcome::Contact { time, .. } = space.first_contact_along(&Parabola, 6.0, 1e-9)? else {
    ///     panic!("it should touch");
    /// };
    /// // x² + x⁴ = 9.
    /// let x = -((37.0_f64.sqrt() - 1.0) / 2.0).sqrt();
    /// assert!((time - 3.0 - x).abs() < 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn first_contact_along(
        &self,
        motion: &impl SmoothMotion,
        duration: f64,
        tolerance: f64,
    ) -> Result<SmoothOutcome, QueryError> {
        motion::first_contact_along(self, motion, duration, tolerance)
    }
}

/// Elements of the space: patches, their links, bands and free regions.
impl PairSpace {
    /// The contact patches, in the order of their numbers; for a lower pair, its permanent contacts.
    pub fn patches(&self) -> impl Iterator<Item = PairPatch<'_>> {
        (0..self.patch_count() as u32).map(|i| PairPatch::new(self, PatchId(i)))
    }

    /// A patch.
    ///
    /// # Errors
    /// If there is no such patch.
    pub fn patch(&self, id: PatchId) -> Result<PairPatch<'_>, QueryError> {
        let count = self.patch_count();
        if id.index() >= count {
            return Err(QueryError::NoPatch {
                patch: id,
                last: PatchId((count as u32).saturating_sub(1)),
            });
        }
        Ok(PairPatch::new(self, id))
    }

    /// The neighbours of a patch. Permanent contacts have none.
    ///
    /// # Errors
    /// If there is no such patch.
    pub fn neighbours(&self, patch: PatchId) -> Result<Neighbours, QueryError> {
        self.patch(patch).map(|p| p.neighbours())
    }

    /// The links between patches, in the order of their numbers. Permanent contacts have none.
    pub fn links(&self) -> Vec<PairLink> {
        graph::links(self)
    }

    /// The bands: intervals between critical orientations, in which only lengths change.
    ///
    /// # Errors
    /// If the pair has no orientation as a coordinate: lower pairs and pairs with fixed axes.
    pub fn bands(&self) -> Result<Vec<Band>, QueryError> {
        Ok(self.oriented()?.bands())
    }

    /// The connected components of free space, in the order of their numbers. A lower pair has none.
    pub fn regions(&self) -> Vec<PairRegion> {
        graph::regions(self)
    }

    /// The contact of a feature of the fixed part with one of the moving part, whether or not they ever touch.
    ///
    /// # Errors
    /// If the pair is a lower pair, or a part has no such feature.
    pub fn contact_of(
        &self,
        fixed: FeatureName,
        moving: FeatureName,
    ) -> Result<FeatureContact, QueryError> {
        patch::contact_of(self, fixed, moving)
    }

    /// The space as plain data.
    pub fn data(&self) -> PairData<'_> {
        match self {
            Self::Planar(space) => PairData::Planar(space.data()),
            Self::FixedAxes(space) => PairData::FixedAxes(space.data()),
            Self::Lower(pair) => PairData::Lower(Box::new(pair.data())),
        }
    }
}

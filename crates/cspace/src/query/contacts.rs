//! Contacts at a configuration, and the contact nearest to it.

use core::cmp;

use crate::geometry::Configuration;
use crate::ids::PatchId;
use crate::space::ContactSpace;

/// The contact that is nearest to a configuration by translation alone.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NearestContact {
    /// Patch of the contact.
    pub patch: PatchId,
    /// The configuration in contact, of the same orientation.
    pub configuration: Configuration,
    /// The distance to it, in the model's unit of length.
    pub distance: f64,
}

impl ContactSpace {
    /// The patches whose contact curves at the configuration's orientation pass within `tolerance` (model length) of
    /// its position, with the distances; the nearest first.
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Options, Part, Vertex};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
    /// let nearest = space.nearest_contact(Configuration::new(5.0, 0.0, 0.1)).ok_or("there is one")?;
    /// // The block's corner meets the table's side: 2 + cos 0.1 + sin 0.1 from the middle.
    /// assert!((nearest.configuration.x - (2.0 + 0.1_f64.cos() + 0.1_f64.sin())).abs() < 1e-9);
    /// assert_eq!(space.contacts(nearest.configuration, 1e-9)[0].0, nearest.patch);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn contacts(&self, c: Configuration, tolerance: f64) -> Vec<(PatchId, f64)> {
        let mut found = Vec::new();
        self.visit_near(c, tolerance, |patch, _, distance| {
            if distance <= tolerance {
                found.push((patch, distance));
            }
            tolerance
        });
        found.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        found.dedup();
        found
    }

    /// Whether the contact curve of one patch at the configuration's orientation passes within `tolerance` (model length) of its position.
    /// A program that follows a contact can test its patch by this instead of all patches. False if there is no such patch.
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Options, Part};
    /// let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
    /// let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0)?;
    /// let space = ContactSpace::compute(&table, &block, &Options::default())?;
    /// let nearest = space.nearest_contact(Configuration::new(5.0, 0.0, 0.1)).ok_or("there is one")?;
    /// assert!(space.is_on(nearest.patch, nearest.configuration, 1e-9));
    /// assert!(!space.is_on(nearest.patch, Configuration::new(5.0, 0.0, 0.1), 1e-9));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn is_on(&self, patch: PatchId, c: Configuration, tolerance: f64) -> bool {
        let distance = self.distance_to(patch, c);
        distance.is_some_and(|distance| distance <= tolerance)
    }

    /// Distance of a configuration from the contact curve of a patch at its orientation; `None` if the patch does not exist there.
    // The classifier's loop seldom comes here.
    #[cold]
    pub(crate) fn distance_to(&self, patch: PatchId, c: Configuration) -> Option<f64> {
        let (surface, p) = (self.surface(), c.position());
        let patch = self.data.patches.get(patch.index())?;
        let t = surface.alive(patch, surface.settled(c.theta))?;
        let curve = surface.curve_as_at(patch, t, c.theta);
        Some(curve.nearest(p).distance(p))
    }

    /// The nearest contact at the configuration's orientation; `None` if nothing touches at that orientation.
    pub fn nearest_contact(&self, c: Configuration) -> Option<NearestContact> {
        let mut nearest: Option<NearestContact> = None;
        self.visit_near(c, f64::INFINITY, |patch, p, distance| {
            let found = NearestContact {
                patch,
                configuration: Configuration::new(p.x, p.y, c.theta),
                distance,
            };
            let order = |a: &NearestContact, b: &NearestContact| {
                let nearer = a.distance.total_cmp(&b.distance);
                nearer.then(a.patch.cmp(&b.patch))
            };
            let least = nearest.map_or(found, |n| cmp::min_by(found, n, order));
            nearest = Some(least);
            least.distance
        });
        nearest
    }
}

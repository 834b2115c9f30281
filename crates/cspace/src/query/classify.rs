//! Classification of a configuration: free, blocked or in contact.

use core::f64::consts::TAU;

use crate::geometry::{Configuration, Point, Vector};
use crate::ids::{PatchId, RegionId};
use crate::space::ContactSpace;

use super::{Classification, Location};

/// Accuracy to which ends of curves are known (length of the pair's frame, about 1.9e-6): next to a tangency they move with the square root
/// of rounding, and critical orientations are known to 1e-6 at worst.
///
/// A ray that passes an end at a smaller distance is not used; neither is one that meets two curves closer together than this.
pub(crate) const END_ERROR: f64 = 1.0 / (1u64 << 19) as f64;

impl ContactSpace {
    /// Classifies a configuration: contact if a contact curve of its slice is within 2⁻³⁷ of the size of the pair, otherwise by the side
    /// from which a ray meets the first contact curve. At [`doubtful_orientations`](Self::doubtful_orientations) the parts themselves are
    /// tested for overlap instead, and a contact must also be confirmed by tests just beside it. `None` outside the window, or if the
    /// configuration is not finite. For millions of configurations there is [`Classifier`](crate::Classifier).
    ///
    /// ```
    /// use cspace::{Classification, Configuration, ContactSpace, Options, Part, Vertex};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
    /// let at = |x| space.classify(Configuration::new(x, 0.0, 1e-3));
    /// assert_eq!(at(4.0), Some(Classification::Free));
    /// assert_eq!(at(2.0), Some(Classification::Blocked));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn classify(&self, c: Configuration) -> Option<Classification> {
        self.locate(c).class()
    }

    /// Classifies a configuration, as [`classify`](Self::classify) says, with the free region that contains a free one: two free
    /// configurations can be joined by a motion if and only if they are in one region.
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Location, Options, Part, Vertex};
    /// let square = |r: f64| -> Vec<Vertex> {
    ///     [(-r, -r), (r, -r), (r, r), (-r, r)].iter().map(|&(x, y)| Vertex::line(x, y)).collect()
    /// };
    /// let ring = Part::new("ring", vec![square(3.0), square(2.0)])?;
    /// let block = Part::new("block", vec![square(1.0)])?;
    /// let space = ContactSpace::compute(&ring, &block, &Options::default())?;
    /// let at = |x, theta| space.locate(Configuration::new(x, 0.0, theta));
    /// // It can turn within the ring, but not get out.
    /// assert_eq!(at(0.0, 0.0), at(0.1, 1.6));
    /// assert_ne!(at(0.0, 0.0), at(9.0, 0.0));
    /// assert_eq!(at(2.5, 0.0), Location::Blocked);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn locate(&self, c: Configuration) -> Location {
        if !self.covers(c) {
            return Location::Outside;
        }
        self.plainly(c).unwrap_or_else(|| self.by_slice(c))
    }

    /// Locates a configuration by the nearest contact curve, without the slice: contact if the curve is near, otherwise by the side of
    /// the curve on which the configuration is, since the segment to the nearest point meets no other curve. `None` where this is in doubt,
    /// or would take as long as the slice.
    fn plainly(&self, c: Configuration) -> Option<Location> {
        /// Curves closer to each other than this may be in the other order; the ends of curves are known to this accuracy (length of the
        /// pair's frame).
        const CLEAR: f64 = 2.0 * END_ERROR;
        self.places.made()?;
        let surface = self.surface();
        let settled = surface.settled(c.theta);
        if surface.doubts().hold(settled) {
            return None;
        }
        let clear = self.data.frame.outer_length(CLEAR);
        let near = self.contact_distance();
        let mut nearest: Option<(PatchId, Point, f64)> = None;
        let mut next = f64::INFINITY;
        self.visit_near(c, f64::INFINITY, |patch, q, distance| {
            match nearest {
                Some((first, ..)) if first == patch => {}
                Some((_, _, least)) if distance >= least => next = next.min(distance),
                _ => {
                    next = nearest.map_or(next, |n| n.2);
                    nearest = Some((patch, q, distance));
                }
            }
            match nearest {
                // A contact needs no second curve.
                Some((_, _, least)) if least <= near => -1.0,
                Some((_, _, least)) => least + clear,
                None => f64::INFINITY,
            }
        });
        let (patch, q, distance) = nearest?;
        if distance <= near {
            return Some(Location::Contact);
        }
        let patch = &self.data.patches[patch.index()];
        let curve = surface.curve(patch, surface.alive(patch, settled)?);
        let ends = [0.0, 1.0].map(|s| curve.point(s));
        if next <= distance + clear || ends.iter().any(|e| e.distance(q) <= clear) {
            return None;
        }
        let above = (patch.function).value(self.data.frame.inner_from_outer(c), c.theta) > 0.0;
        Some(match above {
            true => Location::Free(patch.region),
            false => Location::Blocked,
        })
    }

    /// Whether a configuration is finite and within the window.
    pub(crate) fn covers(&self, c: Configuration) -> bool {
        let window = self.window();
        let within = window.full_turn || (window.lo..=window.hi).contains(&c.theta);
        c.position().is_finite() && c.theta.is_finite() && within
    }

    /// Locates a configuration by its slice; its region is bounded by the curve that decides the class.
    fn by_slice(&self, c: Configuration) -> Location {
        /// Region of a position from which a ray meets nothing.
        const UNBOUNDED: RegionId = RegionId(0);
        let slice = self.slice(c.theta);
        let p = c.position();
        let nearest = slice.nearest(p);
        let near = nearest.is_some_and(|(_, q)| q.distance(p) <= self.contact_distance())
            && (!slice.doubtful || self.touches(c));
        if near {
            return Location::Contact;
        }
        let met = slice.first_met(p);
        let by_slice = met.is_none_or(|m| m.from_free);
        let free = match slice.doubtful {
            true => !self.overlaps(c),
            false => by_slice,
        };
        if !free {
            return Location::Blocked;
        }
        let bounding = if free == by_slice {
            met.map(|m| &slice.curves[m.curve])
        } else {
            nearest.map(|n| n.0)
        };
        let patch = bounding.and_then(|curve| curve.patch);
        let region = patch.map_or(UNBOUNDED, |p| self.patches()[p.index()].region);
        Location::Free(region)
    }

    /// Whether, of some positions at twice the contact distance, some overlap and some do not.
    fn touches(&self, c: Configuration) -> bool {
        const DIRECTIONS: u32 = 8;
        let distance = 2.0 * self.contact_distance();
        let overlaps = |k: u32| {
            let by = Vector::from_angle(TAU / f64::from(DIRECTIONS) * f64::from(k)) * distance;
            self.overlaps(Configuration::new(c.x + by.x, c.y + by.y, c.theta))
        };
        let first = overlaps(0);
        (1..DIRECTIONS).any(|k| overlaps(k) != first)
    }
}

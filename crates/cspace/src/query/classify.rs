//! Is a configuration free?

use serde::{Deserialize, Serialize};

use crate::geometry::Configuration;
use crate::space::ContactSpace;

/// What a configuration is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Classification {
    /// The parts do not overlap.
    Free,
    /// Their interiors meet.
    Blocked,
    /// They touch, within the resolution.
    Contact,
}

impl ContactSpace {
    /// Classifies a configuration: contact if a contact curve of its slice is within [`resolution`](Self::resolution),
    /// otherwise by the side from which a ray meets the first contact curve. `None` outside the window, or if the
    /// configuration is not finite. For millions of configurations prepare a [`classifier`](Self::classifier).
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
        let window = self.window();
        if !(c.position().is_finite() && c.theta.is_finite()) {
            return None;
        }
        if !window.full_turn && !(window.lo..=window.hi).contains(&c.theta) {
            return None;
        }
        let slice = self.slice(c.theta);
        let near = slice.curves.iter().any(|curve| {
            curve.geometry.nearest(c.position()).distance(c.position()) <= self.resolution()
        });
        Some(if near {
            Classification::Contact
        } else if slice.is_free(c.position()) {
            Classification::Free
        } else {
            Classification::Blocked
        })
    }
}

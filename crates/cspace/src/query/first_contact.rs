//! The first contact along a motion of constant rates.

use crate::geometry::{Configuration, Vector};
use crate::ids::PatchId;
use crate::space::ContactSpace;

use super::Classification;
use super::path::{Approach, MotionError, Path};
use super::touch::{Search, Touch};

/// First contact along a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FirstContact {
    /// Time of contact, in the unit of time of the rates.
    pub time: f64,
    /// Configuration at that time. Its orientation is not reduced by turns.
    pub configuration: Configuration,
    /// Patch that is touched; one of them, if several are.
    pub patch: PatchId,
}

/// Outcome of a motion: free to the end, first contact, or end of the window.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum MotionOutcome {
    /// The motion is free to the end.
    Free,
    /// The motion touches a patch.
    Contact(FirstContact),
    /// The motion is free until its orientation leaves the window of the space, at this time.
    LeavesWindow {
        /// Time at which it leaves.
        time: f64,
    },
}

impl MotionOutcome {
    /// The contact, if there is one.
    pub fn contact(&self) -> Option<FirstContact> {
        match *self {
            Self::Contact(contact) => Some(contact),
            _ => None,
        }
    }
}

impl MotionOutcome {
    /// The outcome with times counted from `time` earlier.
    fn later_by(self, time: f64) -> Self {
        match self {
            Self::Free => Self::Free,
            Self::Contact(contact) => Self::Contact(FirstContact {
                time: contact.time + time,
                ..contact
            }),
            Self::LeavesWindow { time: t } => Self::LeavesWindow { time: t + time },
        }
    }
}

impl ContactSpace {
    /// The first contact of the moving part when it moves from `from` at constant rates (dx/dt, dy/dt, dθ/dt), angles in radians, at times
    /// from 0 to `duration`.
    ///
    /// Along the motion p(t), θ(t) the contact function f(p(t), θ(t)) of each patch is a function of time. Its value and its derivative are
    /// enclosed over intervals of time; an interval without a root is dropped, one with a single root is narrowed to rounding, and others
    /// are halved. A root counts if the position is on the patch, within the [`resolution`](Self::resolution) and the uncertainty of the
    /// root. No contact is found by sampling, so none is missed, however thin. Contact is that of the space, which comes an eighth of the
    /// resolution early; apart from this, time and configuration are right to rounding where the motion is not tangent to the contact.
    ///
    /// *Grazing* to a depth below the resolution may count as touching, or not; anything deeper does count.
    ///
    /// A start within the resolution of contact is a contact at time 0 if the motion continues into blocked space. Otherwise the motion
    /// continues, also along the contact, and touches where it becomes deeper than twice the resolution; the reported time is then that at
    /// which it came to the patch.
    ///
    /// The time this takes grows with the number of turns made while contact is possible.
    ///
    /// # Errors
    /// If numbers are not finite, the motion begins in blocked space or outside the window, or it turns farther than
    /// [`LARGEST_ANGLE`](crate::LARGEST_ANGLE) before it touches.
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Options, Part, Vertex};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
    /// // From 10 to the side of the table, which the block's side meets at 3.
    /// let motion = space.first_contact(Configuration::new(10.0, 0.0, 0.0), [-2.0, 0.0, 0.0], 5.0)?;
    /// let contact = motion.contact().ok_or("it should touch")?;
    /// assert!((contact.time - 3.5).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn first_contact(
        &self,
        from: Configuration,
        rates: [f64; 3],
        duration: f64,
    ) -> Result<MotionOutcome, MotionError> {
        self.first_contact_about(from, rates, Vector::ZERO, duration)
    }

    /// The first contact of the moving part when one of its points moves on a straight line while the part turns, at times from 0 to
    /// `duration`.
    ///
    /// `about` is that point b, in the part's frame, and `rates` are its velocity v and the part's rate of turning ω. From
    /// (p₀, θ₀) on the part's orientation is θ(t) = θ₀ + ω t and its position
    ///
    /// p(t) = p₀ + R(θ₀) b + v t − R(θ(t)) b.
    ///
    /// With b = 0 this is the motion of [`first_contact`](Self::first_contact), and everything stated there holds: nothing is sampled. A
    /// part that is drawn far from its origin, and turns, is better moved about its middle than about the origin.
    ///
    /// # Errors
    /// As [`first_contact`](Self::first_contact).
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Options, Part, Vector};
    /// use core::f64::consts::PI;
    /// let wall = Part::rectangle("wall", (10.0, 0.0), 2.0, 40.0)?;
    /// // A rod 6 long, drawn from its end: its middle is at (3, 0).
    /// let rod = Part::rectangle("rod", (3.0, 0.0), 6.0, 0.5)?;
    /// let space = ContactSpace::compute(&wall, &rod, &Options::default())?;
    /// // Upright; it turns by half a turn about its middle, which stays 1 from the wall.
    /// let from = Configuration::new(8.0, -3.0, 0.5 * PI);
    /// let motion = space.first_contact_about(from, [0.0, 0.0, PI], Vector::new(3.0, 0.0), 1.0)?;
    /// let contact = motion.contact().ok_or("it should touch")?;
    /// // A corner at (3, 0.25) from the middle is as far from it as the wall when 3 sin φ + 0.25 cos φ = 1.
    /// let turned = PI * contact.time;
    /// assert!((3.0 * turned.sin() + 0.25 * turned.cos() - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn first_contact_about(
        &self,
        from: Configuration,
        rates: [f64; 3],
        about: Vector,
        duration: f64,
    ) -> Result<MotionOutcome, MotionError> {
        let path = Path::new(self, from, rates, about, duration)?;
        let starts_in_contact = match self.classify(from) {
            None => return Err(MotionError::StartsOutside),
            Some(Classification::Blocked) => return Err(MotionError::StartsBlocked),
            Some(class) => class == Classification::Contact,
        };
        let leaves = path.time_in_window(self.window());
        let leaves = leaves.filter(|&time| time < duration);
        let end = leaves.unwrap_or(duration);
        let without_contact = match leaves {
            Some(time) => MotionOutcome::LeavesWindow { time },
            None => MotionOutcome::Free,
        };
        match path.approach() {
            Approach::Near => {}
            Approach::At(time) if time < end => {
                let from = path.outer_at(time);
                let outcome = self.first_contact_about(from, rates, about, duration - time)?;
                return Ok(outcome.later_by(time));
            }
            Approach::At(_) | Approach::Never => return Ok(without_contact),
        }
        let found = Search::new(self, path, starts_in_contact).first(end);
        if found.is_none() && path.turns_too_far(end) {
            return Err(MotionError::TurnsTooFar);
        }
        if starts_in_contact && let Some(patch) = self.enters_at_once(&path, found.as_ref(), end) {
            return Ok(MotionOutcome::Contact(FirstContact {
                time: 0.0,
                configuration: from,
                patch,
            }));
        }
        Ok(found.map_or(without_contact, |touch| {
            MotionOutcome::Contact(FirstContact {
                time: touch.time,
                configuration: path.outer_at(touch.time),
                patch: touch.patch,
            })
        }))
    }

    /// Whether a motion that starts in contact enters blocked space there although it crosses no patch: where all contacts at a position
    /// end at one orientation, as for a part that is clamped between two corners, the motion leaves them by turning further. Until the next
    /// contact the motion is free or blocked as a whole, so one configuration on it decides. Returns a patch that touches at the start.
    fn enters_at_once(&self, path: &Path, found: Option<&Touch>, end: f64) -> Option<PatchId> {
        /// Largest depth of a grazing motion, in contact distances: twice the resolution, and room for rounding.
        const DEEP: f64 = 8.0;
        let middle = path.outer_at(0.5 * found.map_or(end, |touch| touch.time));
        if self.classify(middle) != Some(Classification::Blocked) {
            return None;
        }
        let slice = self.slice(middle.theta);
        let p = middle.position();
        let deep = DEEP * self.contact_distance();
        let is_deep = (slice.curves.iter()).all(|c| c.geometry.nearest(p).distance(p) > deep);
        let at_start = || self.nearest_contact(path.outer_at(0.0)).map(|n| n.patch);
        is_deep.then(at_start).flatten()
    }
}

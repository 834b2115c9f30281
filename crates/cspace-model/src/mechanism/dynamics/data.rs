//! Dynamic data of a mechanism, in addition to its parts.

use cspace::geometry::{Point, Vector};
use serde::{Deserialize, Serialize};

use super::force::{Load, Spring};
use super::mass::Mass;
use super::motion::{Drive, PartPosition, PartVelocity};

/// Data for the motion of a mechanism: masses, gravity, drives, loads, springs, and the surfaces of pairs.
///
/// Parts are referred to by index. Configuration spaces do not depend on any of these data.
///
/// ```
/// use cspace::{Part, Vector};
/// use cspace_model::{Drive, DriveMotion, Mass, Mechanism, PartEntry};
/// let mut mechanism = Mechanism::new("wheel and ball");
/// mechanism.parts.push(PartEntry::revolute(Part::circle("wheel", (0.0, 0.0), 2.0)?, (0.5, 0.0)));
/// mechanism.parts.push(PartEntry::planar(Part::circle("ball", (0.0, 3.0), 1.0)?));
/// mechanism.dynamics.gravity = Vector::new(0.0, -9810.0);
/// mechanism.dynamics.drives.push(Drive { part: 0, motion: DriveMotion::Rate(1.0) });
/// mechanism.dynamics.part_mut(1).mass = Some(Mass::Density(1e-3));
/// mechanism.check()?;
/// let ball = mechanism.mass_properties(1).ok_or("it has a mass")?;
/// assert!((ball.mass - 1e-3 * core::f64::consts::PI).abs() < 1e-17);
/// assert_eq!(mechanism.mass_properties(0), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Dynamics {
    /// The acceleration of gravity, in the assembly's frame, unit/s².
    pub gravity: Vector,
    /// The coefficient of friction of pairs that have none of their own: 0 or more.
    pub friction: f64,
    /// The coefficient of restitution of pairs that have none of their own: from 0, no bounce, to 1, no loss.
    pub restitution: f64,
    /// Dynamic data of the parts, in their order; parts beyond the end have none.
    pub parts: Vec<PartDynamics>,
    /// Pairs with a friction or restitution of their own.
    pub pairs: Vec<PairSurface>,
    /// Prescribed motions, at most one for a part.
    pub drives: Vec<Drive>,
    /// Constant forces and torques.
    pub loads: Vec<Load>,
    /// Springs and dampers.
    pub springs: Vec<Spring>,
}

/// The mass of a part, and its motion at the start.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct PartDynamics {
    /// The mass, or the mass per area.
    pub mass: Option<Mass>,
    /// The moment of inertia about the centre of mass, kg·unit²; from the outline if there is none.
    pub inertia: Option<f64>,
    /// The centre of mass in the part's frame; the outline's centroid if there is none.
    pub center_of_mass: Option<Point>,
    /// Position of the part at the start; at zero motion if it is not given.
    pub start: Option<PartPosition>,
    /// Velocity of the part at the start; zero if it is not given.
    pub rate: Option<PartVelocity>,
}

/// Friction and restitution of a pair's contacts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PairSurface {
    /// The indices of the two parts, in either order.
    pub parts: (usize, usize),
    /// The coefficient of friction; that of all pairs if there is none.
    pub friction: Option<f64>,
    /// The coefficient of restitution; that of all pairs if there is none.
    pub restitution: Option<f64>,
}

impl Dynamics {
    /// Whether there are no dynamic data.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Dynamic data of a part, by its index.
    pub fn part(&self, part: usize) -> PartDynamics {
        self.parts.get(part).copied().unwrap_or_default()
    }

    /// Dynamic data of a part, mutable; the list is extended if necessary.
    pub fn part_mut(&mut self, part: usize) -> &mut PartDynamics {
        if self.parts.len() <= part {
            self.parts.resize(part + 1, PartDynamics::default());
        }
        &mut self.parts[part]
    }

    /// The coefficient of friction where two parts touch, given by their indices in either order.
    ///
    /// ```
    /// use cspace_model::{Dynamics, PairSurface};
    /// let own = PairSurface { parts: (0, 2), friction: Some(0.3), restitution: None };
    /// let dynamics = Dynamics { friction: 0.1, pairs: vec![own], ..Dynamics::default() };
    /// assert_eq!(dynamics.friction_between(2, 0), 0.3);
    /// assert_eq!(dynamics.friction_between(1, 0), 0.1);
    /// ```
    pub fn friction_between(&self, a: usize, b: usize) -> f64 {
        self.surface(a, b)
            .and_then(|s| s.friction)
            .unwrap_or(self.friction)
    }

    /// The coefficient of restitution where two parts meet, given by their indices in either order.
    pub fn restitution_between(&self, a: usize, b: usize) -> f64 {
        self.surface(a, b)
            .and_then(|s| s.restitution)
            .unwrap_or(self.restitution)
    }

    /// Friction and restitution that two parts have of their own.
    pub fn surface(&self, a: usize, b: usize) -> Option<&PairSurface> {
        (self.pairs.iter()).find(|s| s.parts == (a, b) || s.parts == (b, a))
    }

    /// The prescribed motion of a part, if it has one.
    pub fn drive_of(&self, part: usize) -> Option<&Drive> {
        self.drives.iter().find(|d| d.part == part)
    }
}

//! Motions of constant rates.

use cspace::pair::PairMotion;
use cspace::{Configuration, Coordinates, PairSpace, QueryError, Rotation, Vector};

/// A motion from a configuration at constant rates of all coordinates; of a part in the plane, x and y are those of the point `about`
/// of the moving part, in its frame: θ(t) = θ₀ + ω t, p(t) = p₀ + R(θ₀) b + v t − R(θ(t)) b.
///
/// ```
/// use core::f64::consts::PI;
/// use cspace::{Configuration, Coordinates, Vector};
/// use cspace_design::Motion;
/// let planar = |x, y, theta| Coordinates::Planar(Configuration::new(x, y, theta));
/// // Half a turn about a point 3 from the origin, which comes to the other side of it.
/// let motion = Motion::new(planar(0.0, 0.0, 0.0), planar(0.0, 0.0, PI)).about(Vector::new(3.0, 0.0));
/// let Coordinates::Planar(end) = motion.at(1.0) else { panic!("in the plane") };
/// assert!((end.x - 6.0).abs() < 1e-12 && end.y.abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Where it begins.
    pub from: Coordinates,
    /// The rates, per unit of time.
    pub rates: Coordinates,
    /// The point of the moving part that goes straight, in its frame.
    pub about: Vector,
}

impl Motion {
    /// A motion of constant rates of the coordinates themselves.
    pub const fn new(from: Coordinates, rates: Coordinates) -> Self {
        Self {
            from,
            rates,
            about: Vector::ZERO,
        }
    }

    /// Replaces the point of the moving part to which the rates refer.
    #[must_use]
    pub const fn about(self, about: Vector) -> Self {
        Self { about, ..self }
    }

    /// The configuration at a time.
    pub fn at(&self, time: f64) -> Coordinates {
        match (self.from, self.rates) {
            (Coordinates::Planar(c), Coordinates::Planar(d)) => {
                let theta = c.theta + time * d.theta;
                let (x, y) = (c.x + time * d.x, c.y + time * d.y);
                if self.about == Vector::ZERO {
                    return Coordinates::Planar(Configuration::new(x, y, theta));
                }
                let by = Rotation::by(c.theta) * self.about - Rotation::by(theta) * self.about;
                Coordinates::Planar(Configuration::new(x + by.x, y + by.y, theta))
            }
            (Coordinates::Axes { u, v }, Coordinates::Axes { u: du, v: dv }) => Coordinates::Axes {
                u: u + time * du,
                v: v + time * dv,
            },
            _ => self.from,
        }
    }

    /// Its first contact, for times from 0 to `duration`.
    ///
    /// # Errors
    /// As [`PairSpace::first_contact`].
    pub fn first_contact(
        &self,
        space: &PairSpace,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        space.first_contact_about(self.from, self.rates, self.about, duration)
    }
}

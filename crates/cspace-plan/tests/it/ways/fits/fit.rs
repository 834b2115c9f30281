//! A pair with two configurations, and the same elsewhere.

use cspace::{Configuration, Part, Rotation, Vector};
use cspace_oracle::shapes::{shifted, turned};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// x, y, θ.
pub(super) type Place = (f64, f64, f64);

/// A pair with little play, and two configurations.
pub(super) struct Fit {
    pub(super) fixed: Part,
    pub(super) moving: Part,
    pub(super) from: Configuration,
    pub(super) to: Configuration,
    /// No way has more clearance.
    pub(super) most: f64,
}

impl Fit {
    pub(super) fn new(parts: (Part, Part), from: Place, to: Place, most: f64) -> Self {
        let (fixed, moving) = parts;
        let at = |(x, y, theta)| Configuration::new(x, y, theta);
        let (from, to) = (at(from), at(to));
        Self {
            fixed,
            moving,
            from,
            to,
            most,
        }
    }

    /// As before, drawn elsewhere: nothing is parallel to an axis, and no origin is at a notable place.
    pub(super) fn moved(self, rng: &mut ChaCha8Rng) -> Self {
        let mut any = |most: f64| rng.random_range(-most..most);
        let (turns, f, m) = (
            [any(3.0), any(3.0)],
            [any(2.0), any(2.0)],
            [any(1.0), any(1.0)],
        );
        let elsewhere = |c: Configuration| {
            let theta = c.theta + turns[0] - turns[1];
            let at = Rotation::by(turns[0]) * c.position() + Vector::new(f[0], f[1])
                - Rotation::by(theta) * Vector::new(m[0], m[1]);
            Configuration::new(at.x, at.y, theta)
        };
        Self {
            fixed: shifted(&turned(&self.fixed, turns[0]), f[0], f[1]),
            moving: shifted(&turned(&self.moving, turns[1]), m[0], m[1]),
            from: elsewhere(self.from),
            to: elsewhere(self.to),
            most: self.most,
        }
    }
}

//! Functions that are linear in rates: of opening, sliding and violations.
//!
//! All are combinations of the velocity of a point of a part along a direction,
//!
//! ```text
//! d · ṗ = d · (ẋ, ẏ) + θ̇ d · left(p − c)      of a part with its coordinates x, y at c
//!       = u̇ d · left(p − c)                   of one that turns about c
//!       = u̇ d · e                             of one that slides along the unit vector e
//! ```
//!
//! in numbers that carry how they change along the motion: the coefficients r of the rates v come with ṙ, so that (r · v)˙ = r · v̇ + ṙ · v.

use cspace::{AxisMotion, Dual, Real};

use crate::system::PartCoordinates;

/// A number with its derivative by time.
pub(super) type InTime = Dual<1>;

/// A number that does not change.
pub(super) fn still(value: f64) -> InTime {
    InTime::constant(value)
}

/// Coefficients of the rates of the coordinates of two parts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rates {
    entries: [(usize, InTime); 6],
    count: usize,
}

impl Rates {
    pub(super) fn none() -> Self {
        Self {
            entries: [(0, still(0.0)); 6],
            count: 0,
        }
    }

    pub(super) fn entries(&self) -> &[(usize, InTime)] {
        &self.entries[..self.count]
    }

    /// Adds a multiple of the rate of a coordinate.
    pub(super) fn add(&mut self, coordinate: usize, by: InTime) {
        if let Some(entry) = (self.entries[..self.count].iter_mut()).find(|e| e.0 == coordinate) {
            entry.1 = entry.1 + by;
        } else if let Some(entry) = self.entries.get_mut(self.count) {
            *entry = (coordinate, by);
            self.count += 1;
        }
    }

    /// Adds the velocity along a direction d of the point of a part that is at p, both in the assembly's frame.
    pub(super) fn add_point(
        &mut self,
        part: &PartCoordinates,
        q: &[f64],
        v: &[f64],
        p: [InTime; 2],
        d: [InTime; 2],
    ) {
        let about = |c: [InTime; 2]| d[1] * (p[0] - c[0]) - d[0] * (p[1] - c[1]);
        match *part {
            PartCoordinates::Fixed => {}
            PartCoordinates::Axis { first, motion, .. } => match motion {
                AxisMotion::Fixed => {}
                AxisMotion::Revolute { center } => {
                    self.add(first, about([still(center.x), still(center.y)]));
                }
                AxisMotion::Prismatic { direction } => {
                    let e = direction.unit();
                    self.add(first, d[0] * still(e.x) + d[1] * still(e.y));
                }
            },
            PartCoordinates::Planar { first, .. } => {
                let at = |i: usize| InTime {
                    value: q[i],
                    slope: [v[i]],
                };
                self.add(first, d[0]);
                self.add(first + 1, d[1]);
                self.add(first + 2, about([at(first), at(first + 1)]));
            }
        }
    }

    /// r · v.
    pub(super) fn rate(&self, v: &[f64]) -> f64 {
        self.entries().iter().map(|(i, r)| r.value * v[*i]).sum()
    }

    /// ṙ · v + r · a.
    pub(super) fn change(&self, v: &[f64], a: &[f64]) -> f64 {
        (self.entries().iter())
            .map(|(i, r)| r.slope[0] * v[*i] + r.value * a[*i])
            .sum()
    }
}

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

use crate::system::{PartCoordinates, Row};

/// A number with its derivative by time.
pub(super) type InTime = Dual<1>;

/// A number that does not change.
pub(super) fn still(value: f64) -> InTime {
    InTime::constant(value)
}

impl Row<InTime> {
    /// Adds the velocity along a direction d of the point of a part that is at p, both in the assembly's frame.
    pub(super) fn add_point(
        &mut self,
        part: &PartCoordinates,
        q: &[InTime],
        p: [InTime; 2],
        d: [InTime; 2],
    ) {
        let about = |c: [InTime; 2]| d[1] * (p[0] - c[0]) - d[0] * (p[1] - c[1]);
        match *part {
            PartCoordinates::Fixed => {}
            PartCoordinates::Axis { first, motion, .. } => match motion {
                AxisMotion::Fixed => {}
                AxisMotion::Revolute { center } => {
                    self.push(first, about([still(center.x), still(center.y)]));
                }
                AxisMotion::Prismatic { direction } => {
                    let e = direction.unit();
                    self.push(first, d[0] * still(e.x) + d[1] * still(e.y));
                }
            },
            PartCoordinates::Planar { first, .. } => {
                self.push(first, d[0]);
                self.push(first + 1, d[1]);
                self.push(first + 2, about([q[first], q[first + 1]]));
            }
        }
    }

    /// ṙ · v + r · a.
    pub(super) fn change(&self, v: &[f64], a: &[f64]) -> f64 {
        (self.entries().iter())
            .map(|(i, r)| r.slope[0] * v[*i] + r.value * a[*i])
            .sum()
    }
}

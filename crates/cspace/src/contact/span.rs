//! The interval of orientations over which sheets are made.

use core::f64::consts::{PI, TAU};

use crate::feature::Outline;
use crate::number::Dd;

/// The window of orientations, in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Whether it is a full turn, or one slab of it, and what is at one end goes on at the other.
    pub(crate) full: bool,
}

impl Span {
    /// Where it begins and ends, in double-double.
    pub(crate) fn from(&self) -> Dd {
        Dd::from(self.lo)
    }

    pub(crate) fn to(&self) -> Dd {
        Dd::from(self.hi)
    }

    /// The first of so many equal slabs of the full turn, not cut at an orientation where two normals oppose each other.
    pub(crate) fn slab(fixed: &Outline, moving: &Outline, slabs: u32) -> Self {
        const CLEAR: f64 = 1e-7;
        // Irrational steps: some cut is clear unless the normals are dense on that scale.
        let cuts = (0..64).map(|i| -PI + 0.01234 + 0.000_761_3 * f64::from(i));
        let clear = |cut: f64| {
            fixed.joints.iter().all(|a| {
                moving.joints.iter().all(|b| {
                    let t = (a.angle - b.angle - PI - cut) / TAU;
                    (t - t.round()).abs() * TAU > CLEAR
                })
            })
        };
        let lo = cuts.clone().find(|&c| clear(c)).unwrap_or(-PI + 0.01234);
        Self {
            lo,
            hi: lo + TAU / f64::from(slabs),
            full: true,
        }
    }
}

#[cfg(test)]
mod tests;

//! Above a patch: a little off the surface of the contact space, in free space.

use cspace::Vector;

use crate::legs::Coords;

use super::piece::{Lifted, Piece};
use super::planar::Planar;
use super::station::{Across, Station};

/// The clearance above a patch is at least this share of the height.
const KEPT: f64 = 0.9;
/// Heights are at most this share of the parts' size.
const HIGHEST: f64 = 0.25;
/// And at least this share: below lies what rounding does to contacts.
const LOWEST: f64 = 1e-14;

/// A way above a patch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Above<'a> {
    pub(super) planar: &'a Planar<'a>,
    pub(super) across: Across,
}

impl Piece for Above<'_> {
    fn at(&self, s: f64) -> Lifted {
        self.lifted(self.station(s))
    }
}

impl Above<'_> {
    /// From the entry to the middle of the patch and to the exit: the edges of a patch are places where little is free.
    fn station(&self, s: f64) -> Station {
        /// The middle keeps this share of the orientations away from both ends.
        const MARGIN: f64 = 0.1;
        let patch = &self.planar.space().patches()[self.across.patch.index()];
        let Across { entry, exit, .. } = self.across;
        let margin = MARGIN * (patch.hi - patch.lo);
        let middle = Station {
            theta: (0.5 * (entry.theta + exit.theta)).clamp(patch.lo + margin, patch.hi - margin),
            share: 0.5,
        };
        let (a, b, t) = if s <= 0.5 {
            (entry, middle, 2.0 * s)
        } else {
            (middle, exit, 2.0 * s - 1.0)
        };
        Station {
            theta: a.theta + (b.theta - a.theta) * t,
            share: a.share + (b.share - a.share) * t,
        }
    }

    /// The configuration above a station: along the normal, as high as the patch itself stays the nearest contact.
    fn lifted(&self, station: Station) -> Lifted {
        let theta = station.theta + self.across.turn;
        let Some(curve) = self.planar.curve(self.across.patch, station.theta) else {
            let nowhere = [f64::NAN; 3];
            return Lifted {
                low: nowhere,
                high: nowhere,
            };
        };
        let (p, normal) = (curve.point(station.share), curve.free_normal(station.share));
        let above = |h: f64| self.planar.numbers(p + normal * h, theta);
        Lifted {
            low: above(0.0),
            high: above(self.height(normal, above)),
        }
    }

    /// Goes up by the clearance there is, which passes through nothing: distances have no sign.
    fn height(&self, normal: Vector, above: impl Fn(f64) -> Coords) -> f64 {
        if normal == Vector::ZERO {
            return 0.0;
        }
        let scene = &self.planar.scene;
        let (lowest, highest) = (LOWEST * scene.size(), HIGHEST * scene.size());
        // Half way to what else is there, this contact is the nearest.
        let others = scene.nearest_but(above(0.0), self.planar.features(self.across.patch));
        let mut height = (0.5 * KEPT * others.distance).clamp(lowest, highest);
        while height < highest {
            let next = (height * (1.0 + KEPT)).min(highest);
            if scene.clearance(above(next)) < KEPT * next {
                break;
            }
            height = next;
        }
        height
    }
}

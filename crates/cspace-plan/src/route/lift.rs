//! Off the surface of the contact space, into free space.

use cspace::Vector;

use crate::legs::{Coords, Scene};
use crate::push::ascent;

use super::piece::{Across, Station};
use super::planar::Planar;

/// The clearance above a patch is at least this share of the height.
const KEPT: f64 = 0.9;
/// Heights are at most this share of the parts' size.
const HIGHEST: f64 = 0.25;
/// And are halved at most so often: below lies what rounding does to contacts.
const HALVINGS: u32 = 44;

impl Planar<'_> {
    /// The configuration above a station: along the normal, as high as the patch itself stays the nearest contact, times a
    /// share.
    pub(super) fn lifted(&self, across: &Across, station: Station, share: f64) -> Coords {
        let theta = station.theta + across.turn;
        let Some(curve) = self.curve(across.patch, station.theta) else {
            return [f64::NAN; 3];
        };
        let (p, normal) = (curve.point(station.share), curve.free_normal(station.share));
        let above = |h: f64| [p.x + normal.x * h, p.y + normal.y * h, theta];
        above(share * self.height(normal, above))
    }

    fn height(&self, normal: Vector, above: impl Fn(f64) -> Coords) -> f64 {
        if normal == Vector::ZERO {
            return 0.0;
        }
        let mut height = HIGHEST * self.scene.size();
        for _ in 0..HALVINGS {
            if self.scene.clearance(above(height)) >= KEPT * height {
                return height;
            }
            height *= 0.5;
        }
        height
    }
}

/// A configuration near one in contact that is free, with the leg between them free but for its start.
pub(crate) fn off_contact(scene: &Scene, at: Coords, touching: f64) -> Option<Coords> {
    let mut step = HIGHEST * scene.size();
    let mut best: Option<(f64, Coords)> = None;
    let direction = ascent(&scene.near(at, 4.0 * touching), scene.levers(), f64::INFINITY)?;
    for _ in 0..HALVINGS {
        let to: Coords = core::array::from_fn(|k| at[k] + direction[k] * step);
        let clearance = scene.clearance(to);
        let near: Coords = core::array::from_fn(|k| at[k] + direction[k] * step * 1e-3);
        if best.is_none_or(|b| clearance > b.0)
            && clearance > 2.0 * touching
            && scene.is_apart(near, to, 1e-4 * clearance)
        {
            best = Some((clearance, to));
        }
        step *= 0.5;
    }
    best.map(|b| b.1)
}

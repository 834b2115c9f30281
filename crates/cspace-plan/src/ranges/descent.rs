//! The way down to a configuration at which two parts are nearest among those around.
//!
//! The distance of two parts is the least of many smooth functions of (u, v), one for each two points: where it has a local minimum it is
//! smooth, so that Newton's method ends there. Its value is right to rounding; that no other place is lower is not decided here.

use crate::legs::{Coords, Scene};

/// A configuration, and the distance of the parts there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Low {
    pub(super) at: [f64; 2],
    pub(super) distance: f64,
}

/// How a distance changes by lengths: each coordinate times how far a point of its part moves for a unit of it.
type Slope = [f64; 2];

/// The most steps of one descent: each of Newton's doubles the digits, the others cross a distance that is a share of the parts' size.
const MOST_STEPS: usize = 200;
/// The longest step as a share of the parts' size.
const LONGEST: f64 = 0.25;
/// Differences of gradients are taken over this share of the size: about the cube root of rounding.
const APART: f64 = 1e-6;
/// A step is taken if the distance falls by this share of what the gradient promises.
const ENOUGH: f64 = 1e-4;
/// A step that promises less than this share of the parts' size gains nothing but rounding.
const LEAST_GAIN: f64 = 1e-15;
/// A step is halved so often before another direction is tried.
const HALVINGS: u32 = 40;
/// Slopes below this are none: a step of the size of the parts would gain as little as rounding.
const FLAT: f64 = 1e-14;
/// More than rounding of a distance, as a share of it: the nearest pieces are found again within it.
const SLACK: f64 = 1e-9;

/// Two parts whose distance is to become least, and the limits of their motions.
pub(super) struct Descent<'a> {
    scene: &'a Scene,
    limits: [(f64, f64); 2],
    levers: [f64; 2],
}

impl<'a> Descent<'a> {
    pub(super) fn new(scene: &'a Scene) -> Self {
        let [u, v, _] = scene.limits();
        let [a, b, _] = scene.levers();
        Self {
            scene,
            limits: [u, v],
            levers: [a, b],
        }
    }

    /// The distance at a configuration.
    pub(super) fn there(&self, at: [f64; 2]) -> Low {
        Low {
            at,
            distance: self.scene.clearance(coords(at)),
        }
    }

    /// A local minimum, or a place beside one, not above the given one.
    pub(super) fn from(&self, at: [f64; 2]) -> Low {
        let mut low = self.there(self.held(at));
        let Some(mut slope) = self.slope(low) else {
            return low;
        };
        for _ in 0..MOST_STEPS {
            let free = [0, 1].map(|k| self.is_free(k, low.at[k], slope[k]));
            let by = [0, 1].map(|k| if free[k] { slope[k] } else { 0.0 });
            if by[0].hypot(by[1]) <= FLAT {
                break;
            }
            let newton = self.newton(low.at, by, free);
            let down = [-by[0], -by[1]];
            let Some(next) = [newton, down]
                .into_iter()
                .find_map(|way| self.step(low, slope, way))
            else {
                break;
            };
            low = next;
            match self.slope(low) {
                Some(there) => slope = there,
                None => break,
            }
        }
        low
    }

    /// Whether a coordinate can move against its slope.
    fn is_free(&self, k: usize, at: f64, slope: f64) -> bool {
        let (lo, hi) = self.limits[k];
        self.levers[k] > 0.0 && !(at <= lo && slope > 0.0) && !(at >= hi && slope < 0.0)
    }

    fn held(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| at[k].clamp(self.limits[k].0, self.limits[k].1))
    }

    /// The slope of the distance of the nearest pieces; none where they touch.
    fn slope(&self, low: Low) -> Option<Slope> {
        let within = low.distance * (1.0 + SLACK) + f64::MIN_POSITIVE;
        let near = self.scene.near(coords(low.at), within);
        let nearest = (near.iter()).min_by(|a, b| a.distance.total_cmp(&b.distance))?;
        Some([0, 1].map(|k| match self.levers[k] {
            lever if lever > 0.0 => nearest.gradient[k] / lever,
            _ => 0.0,
        }))
    }

    /// The direction of Newton's method, with curvatures taken as positive, so that it leads down; no longer than a step may be.
    fn newton(&self, at: [f64; 2], by: [f64; 2], free: [bool; 2]) -> [f64; 2] {
        let size = self.scene.size();
        let apart = APART * size;
        let mut curve = [[0.0; 2]; 2];
        for k in [0, 1].into_iter().filter(|&k| free[k]) {
            let side = |sign: f64| {
                let mut there = at;
                there[k] += sign * apart / self.levers[k];
                self.slope(self.there(there))
            };
            let (Some(after), Some(before)) = (side(1.0), side(-1.0)) else {
                return [-by[0], -by[1]];
            };
            for (j, row) in curve.iter_mut().enumerate() {
                if free[j] {
                    row[k] = (after[j] - before[j]) / (2.0 * apart);
                }
            }
        }
        let ([a, b], [c, d]) = (curve[0], curve[1]);
        let mixed = 0.5 * (b + c);
        // The axes of the form a x² + 2 mixed x y + d y².
        let angle = 0.5 * (2.0 * mixed).atan2(a - d);
        let (sin, cos) = angle.sin_cos();
        let mut way = [0.0; 2];
        for axis in [[cos, sin], [-sin, cos]] {
            let curvature =
                a * axis[0] * axis[0] + 2.0 * mixed * axis[0] * axis[1] + d * axis[1] * axis[1];
            let along = by[0] * axis[0] + by[1] * axis[1];
            // Where there is no curvature the step is as long as it may be.
            let length = (along / curvature.abs().max(along.abs() / (LONGEST * size)))
                .clamp(-LONGEST * size, LONGEST * size);
            if along != 0.0 {
                way = [way[0] - length * axis[0], way[1] - length * axis[1]];
            }
        }
        [0, 1].map(|k| if free[k] { way[k] } else { 0.0 })
    }

    /// A step along a way that lowers the distance.
    fn step(&self, low: Low, slope: Slope, way: [f64; 2]) -> Option<Low> {
        let mut share = 1.0;
        for _ in 0..HALVINGS {
            let there = self.held([0, 1].map(|k| match self.levers[k] {
                lever if lever > 0.0 => low.at[k] + share * way[k] / lever,
                _ => low.at[k],
            }));
            let moved = [0, 1].map(|k| (there[k] - low.at[k]) * self.levers[k]);
            let promised = moved[0] * slope[0] + moved[1] * slope[1];
            if promised > -LEAST_GAIN * self.scene.size() {
                return None;
            }
            let next = self.there(there);
            if next.distance < low.distance && next.distance <= low.distance + ENOUGH * promised {
                return Some(next);
            }
            share *= 0.5;
        }
        None
    }
}

pub(super) fn coords([u, v]: [f64; 2]) -> Coords {
    [u, v, 0.0]
}

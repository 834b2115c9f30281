//! Away from what is near: towards more clearance.

use crate::legs::{Coords, Near, Scene};

/// Steps of the search for the best mixture of gradients.
const STEPS: usize = 400;
/// Where it has come to within this share of the best: what a step gains is a few hundredths.
const RELATIVE: f64 = 1e-9;

/// The displacement δ by which the least of the distances grows the most, less what it costs: it maximises
///
/// ```text
/// min (dᵢ + gᵢ · δ) − |δ|² / 2 reach
/// ```
///
/// with gradients g in lengths, where turning counts by its lever, and δ across a direction if one is given (a proximal step of
/// steepest ascent). Where several distances balance each other it comes to the place between them at once. `None` where none
/// can grow.
pub(crate) fn rise(
    near: &[Near],
    levers: Coords,
    across: Option<Coords>,
    reach: f64,
) -> Option<Coords> {
    let normal = across.and_then(|t| unit(core::array::from_fn(|k| t[k] * levers[k])));
    let gradients: Vec<Coords> = near
        .iter()
        .map(|n| {
            let g: Coords = core::array::from_fn(|k| {
                if levers[k] > 0.0 {
                    n.gradient[k] / levers[k]
                } else {
                    0.0
                }
            });
            let along = normal.map_or(0.0, |t| dot(&g, &t));
            core::array::from_fn(|k| g[k] - normal.map_or(0.0, |t| t[k]) * along)
        })
        .collect();
    let mut shares = vec![0.0; near.len()];
    // The dual: shares λ of the gradients that minimise reach |Σ λ g|² / 2 + Σ λ d. It begins with the nearest.
    let first = (0..near.len()).min_by(|&i, &j| near[i].distance.total_cmp(&near[j].distance))?;
    shares[first] = 1.0;
    let mut sum = gradients[first];
    let mut slopes = vec![0.0; near.len()];
    for _ in 0..STEPS {
        for (slope, (gradient, near)) in slopes.iter_mut().zip(gradients.iter().zip(near)) {
            *slope = reach * dot(gradient, &sum) + near.distance;
        }
        let by_slope = |&i: &usize, &j: &usize| slopes[i].total_cmp(&slopes[j]);
        let best = (0..near.len()).min_by(by_slope)?;
        let worst = (0..near.len())
            .filter(|&i| shares[i] > 0.0)
            .max_by(by_slope)?;
        let gain = slopes[worst] - slopes[best];
        let way: Coords = core::array::from_fn(|k| gradients[best][k] - gradients[worst][k]);
        let bend = reach * dot(&way, &way);
        if gain <= RELATIVE * near[first].distance {
            break;
        }
        let moved = if bend > 0.0 {
            (gain / bend).min(shares[worst])
        } else {
            shares[worst]
        };
        shares[best] += moved;
        shares[worst] -= moved;
        sum = core::array::from_fn(|k| sum[k] + moved * way[k]);
    }
    let grows = sum.iter().any(|s| s.abs() > 0.0);
    grows.then(|| {
        core::array::from_fn(|k| {
            if levers[k] > 0.0 {
                reach * sum[k] / levers[k]
            } else {
                0.0
            }
        })
    })
}

/// A configuration that climbs to more clearance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Climb {
    pub(crate) at: Coords,
    pub(crate) clearance: f64,
    /// How far the next step goes at most.
    pub(crate) reach: f64,
}

/// Steps are made longer by this after one that was taken, and shorter after one that was not.
const LONGER: f64 = 4.0;
const SHORTER: f64 = 0.25;
/// So many lengths of a step are tried at once.
const TRIED: usize = 8;

impl Climb {
    /// Takes a step, across a direction if one is given, to where the clearance is larger by a share `gain` and which is accepted.
    /// Returns whether one was found.
    pub(crate) fn step(
        &mut self,
        scene: &Scene,
        levers: Coords,
        across: Option<Coords>,
        gain: f64,
        accepts: impl Fn(Coords, f64) -> bool,
    ) -> bool {
        let mut reach = self.reach;
        for _ in 0..TRIED {
            // A step changes distances by its length at most: what is farther does not become the nearest.
            let near: Vec<Near> = scene.near(self.at, self.clearance + 2.0 * reach);
            let Some(step) = rise(&near, levers, across, reach) else {
                break;
            };
            let to = scene.within_limits(core::array::from_fn(|k| self.at[k] + step[k]));
            let clearance = scene.clearance(to);
            if clearance > self.clearance * (1.0 + gain) && accepts(to, clearance) {
                *self = Self {
                    at: to,
                    clearance,
                    reach: reach * LONGER,
                };
                return true;
            }
            reach *= SHORTER;
        }
        false
    }
}

fn dot(a: &Coords, b: &Coords) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn unit(a: Coords) -> Option<Coords> {
    let length = dot(&a, &a).sqrt();
    (length > 0.0).then(|| a.map(|x| x / length))
}

//! Away from what is near: towards more clearance.

use crate::legs::{Coords, Near};

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

fn dot(a: &Coords, b: &Coords) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn unit(a: Coords) -> Option<Coords> {
    let length = dot(&a, &a).sqrt();
    (length > 0.0).then(|| a.map(|x| x / length))
}

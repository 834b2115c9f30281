//! The linear analysis: shares of parameters, the worst case and the root of the sum of squares.

use super::study::Study;
use crate::sensitivity::Sensitivity;

/// A requirement as a linear function of the parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// Contribution of each parameter, in the order of the variations.
    pub parameters: Vec<Contribution>,
    /// The value as drawn.
    pub nominal: f64,
    /// The smallest and the largest value.
    pub worst: [f64; 2],
    /// The values within which a root of the sum of squares of the tolerances lies, about that in the middle of the tolerances.
    pub rss: [f64; 2],
    /// The standard deviation of the value, by those of the parameters.
    pub sigma: f64,
}

/// Contribution of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Contribution {
    /// The name of the parameter.
    pub parameter: String,
    /// The derivatives for smaller and for larger values of the parameter.
    pub derivative: [f64; 2],
    /// Change of the smallest value, at most 0, and of the largest.
    pub ends: [f64; 2],
    /// By how much the value is off in the middle of its tolerance.
    pub shift: f64,
    /// The standard deviation of the value by this alone.
    pub sigma: f64,
    /// Its share of the worst case.
    pub worst_share: f64,
    /// Its share of the variance.
    pub variance_share: f64,
}

impl Study<'_> {
    /// The linear analysis about the values of the parameters; `None` where a derivative is not known.
    pub(super) fn linear(&self, by: &[Sensitivity]) -> Option<Linear> {
        let zero = vec![0.0; self.variations.len()];
        let point = self.at(&zero);
        let nominal = *point.value.as_ref().ok()?;
        let list = &self.variations.list;
        let of = |name: &str| {
            let known = by.iter().find(|s| s.parameter == name)?;
            known.derivative.as_ref().ok().copied()
        };
        let known: Option<Vec<[f64; 2]>> = list.iter().map(|v| of(&v.parameter.name)).collect();
        let slopes: Vec<[f64; 2]> = match known {
            Some(known) => known,
            None => {
                let slopes = self.slopes(&zero, &point)?;
                slopes.into_iter().map(|s| [s; 2]).collect()
            }
        };
        // What each adds to the worst cases: for smaller and for larger values by the derivative of that side.
        let mut ends: Vec<[f64; 2]> = (slopes.iter().zip(list))
            .map(|([below, above], v)| {
                let [down, up] = [below * v.deviations[0], above * v.deviations[1]];
                [down.min(up).min(0.0), down.max(up).max(0.0)]
            })
            .collect();
        let mut alone = ends.clone();
        for zone in &self.variations.zones {
            // Together they add as much as the length of both slopes times the radius, of each that of the side on which it adds more: each
            // its share.
            let [i, j] = zone.coordinates;
            let most = |k: usize, sign: f64| {
                let [below, above] = slopes[k];
                (sign * above).max(-sign * below).max(0.0)
            };
            for (end, sign) in [(0, -1.0), (1, 1.0)] {
                let long = most(i, sign).hypot(most(j, sign));
                for k in [i, j] {
                    let by = most(k, sign);
                    let share = if long > 0.0 { by / long } else { 0.0 };
                    ends[k][end] = sign * zone.radius * by * share;
                    alone[k][end] = sign * zone.radius * by;
                }
            }
        }
        let worst = [0, 1].map(|i| nominal + ends.iter().map(|e| e[i]).sum::<f64>());
        let width = worst[1] - worst[0];
        // Each by itself moves the value within these ends, about their middle.
        let shift = |k: usize| 0.5 * (alone[k][0] + alone[k][1]);
        let shifts: f64 = (0..list.len()).map(shift).sum();
        let half = |k: usize| 0.5 * (alone[k][1] - alone[k][0]);
        let root = (0..list.len()).map(|k| half(k).powi(2)).sum::<f64>().sqrt();
        let sigmas = self.variations.sigmas();
        let variances: Vec<f64> = (0..list.len())
            .map(|k| sigmas[k].powi(2) * share_of_variance(slopes[k]))
            .collect();
        let variance: f64 = variances.iter().sum();
        let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
        let parameters = (0..list.len()).map(|k| Contribution {
            parameter: list[k].parameter.name.clone(),
            derivative: slopes[k],
            ends: ends[k],
            shift: shift(k),
            sigma: variances[k].sqrt(),
            worst_share: share(ends[k][1] - ends[k][0], width),
            variance_share: share(variances[k], variance),
        });
        Some(Linear {
            parameters: parameters.collect(),
            nominal,
            worst,
            rss: [nominal + shifts - root, nominal + shifts + root],
            sigma: variance.sqrt(),
        })
    }
}

/// The variance of what is a times a number of the variance 1 and the mean 0 where that is below 0, and b times where it is above:
/// (a² + b²) / 2 − (b − a)² / 4 · (E|x|)², with E|x| = √(2/π) of a normal distribution.
fn share_of_variance([below, above]: [f64; 2]) -> f64 {
    let mean = 0.5 * (above - below) * core::f64::consts::FRAC_2_PI.sqrt();
    0.5 * (below * below + above * above) - mean * mean
}

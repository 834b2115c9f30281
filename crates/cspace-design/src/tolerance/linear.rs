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
        let middle = |k: usize| 0.5 * (slopes[k][0] + slopes[k][1]);
        // What each adds to the worst cases, and to the root of the sum of squares.
        let mut ends: Vec<[f64; 2]> = (slopes.iter().zip(list))
            .map(|([below, above], v)| {
                let [down, up] = [below * v.deviations[0], above * v.deviations[1]];
                [down.min(up).min(0.0), down.max(up).max(0.0)]
            })
            .collect();
        let mut halves: Vec<f64> = (0..list.len())
            .map(|k| (middle(k) * list[k].half()).abs())
            .collect();
        for zone in &self.variations.zones {
            // Together they add as much as the length of both slopes times the radius: each its share.
            let [i, j] = zone.coordinates;
            let long = middle(i).hypot(middle(j));
            for k in [i, j] {
                let part = if long > 0.0 {
                    zone.radius * middle(k) * middle(k) / long
                } else {
                    0.0
                };
                ends[k] = [-part, part];
                halves[k] = zone.radius * middle(k).abs();
            }
        }
        let worst = [0, 1].map(|i| nominal + ends.iter().map(|e| e[i]).sum::<f64>());
        let width = worst[1] - worst[0];
        let shift = |k: usize| middle(k) * list[k].middle();
        let shifts: f64 = (0..list.len()).map(shift).sum();
        let root = halves.iter().map(|h| h * h).sum::<f64>().sqrt();
        let sigmas = self.variations.sigmas();
        let variances: Vec<f64> = (0..list.len())
            .map(|k| (middle(k) * sigmas[k]).powi(2))
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

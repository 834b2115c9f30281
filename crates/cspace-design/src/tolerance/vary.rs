//! Variations within tolerances: deviations of parameters from their values, and how likely they are.

use core::f64::consts::TAU;

use cspace_model::Model;
use cspace_model::model::{Distribution, Parameter, Setting};
use rand::Rng;
use rand_distr::{Distribution as _, StandardNormal};

/// A parameter with a tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation {
    /// The parameter, with its value and how that is written.
    pub parameter: Parameter,
    /// The smallest and the largest deviation from the value.
    pub deviations: [f64; 2],
    /// How likely deviations are.
    pub distribution: Distribution,
}

/// The point of two coordinates that lies within a circle about its nominal place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    /// The numbers of the two variations.
    pub coordinates: [usize; 2],
    /// The radius of the circle.
    pub radius: f64,
}

/// Everything that varies, in the order of the model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Variations {
    /// The parameters.
    pub list: Vec<Variation>,
    /// Variations that are coordinates of a point in a zone.
    pub zones: Vec<Zone>,
}

impl Variation {
    /// Half the width of the tolerance.
    pub fn half(&self) -> f64 {
        0.5 * (self.deviations[1] - self.deviations[0])
    }

    /// The middle of the tolerance.
    pub fn middle(&self) -> f64 {
        0.5 * (self.deviations[1] + self.deviations[0])
    }

    /// The standard deviation of the distribution.
    fn sigma(&self) -> f64 {
        let (t, [lo, hi]) = (self.half(), self.deviations);
        match &self.distribution {
            Distribution::Uniform => t / 3.0_f64.sqrt(),
            Distribution::Normal { sigma } => t / sigma,
            // Of the corners lo, 0 and hi: (lo² + hi² − lo·hi) / 18.
            Distribution::Triangular => ((lo * lo + hi * hi - lo * hi) / 18.0).sqrt(),
            Distribution::Table(rows) => moments(rows).1,
        }
    }

    fn draw(&self, random: &mut impl Rng) -> f64 {
        let [lo, hi] = self.deviations;
        match &self.distribution {
            Distribution::Uniform => lo + (hi - lo) * random.random::<f64>(),
            Distribution::Normal { sigma } => {
                let normal: f64 = StandardNormal.sample(random);
                self.middle() + normal * self.half() / sigma
            }
            Distribution::Triangular => {
                // The inverse of the quadratic cumulative distribution on either side of the peak.
                let (u, width): (f64, f64) = (random.random(), hi - lo);
                if width == 0.0 {
                    lo
                } else if u * width < -lo {
                    lo + (u * width * -lo).sqrt()
                } else {
                    hi - ((1.0 - u) * width * hi).sqrt()
                }
            }
            Distribution::Table(rows) => {
                let u: f64 = random.random();
                from_table(rows, u) - self.parameter.value
            }
        }
    }
}

/// The area under each piece of a density that is linear between its rows.
fn areas(rows: &[[f64; 2]]) -> impl Iterator<Item = f64> + '_ {
    rows.windows(2)
        .map(|w| 0.5 * (w[1][0] - w[0][0]) * (w[0][1] + w[1][1]))
}

/// The value below which a share of a density lies.
fn from_table(rows: &[[f64; 2]], share: f64) -> f64 {
    let total: f64 = areas(rows).sum();
    let mut left = share * total;
    for (w, area) in rows.windows(2).zip(areas(rows)) {
        if left <= area && area > 0.0 {
            let ([x, p], [y, q]) = (w[0], w[1]);
            // left = p d + (q − p) d² / (2 (y − x)), by the form that loses no digits where q is p.
            let slope = (q - p) / (y - x);
            let root = (p * p + 2.0 * slope * left).max(0.0).sqrt();
            return (x + 2.0 * left / (p + root)).min(y);
        }
        left -= area;
    }
    rows.last().map_or(f64::NAN, |r| r[0])
}

/// Mean and standard deviation of a density.
fn moments(rows: &[[f64; 2]]) -> (f64, f64) {
    let total: f64 = areas(rows).sum();
    let (mut first, mut second) = (0.0, 0.0);
    let origin = rows[0][0];
    for w in rows.windows(2) {
        let ([x, p], [y, q]) = (w[0], w[1]);
        let (a, b) = (x - origin, y - origin);
        let d = b - a;
        // Simpson's rule is exact for cubics.
        let m = 0.5 * (a + b);
        let r = 0.5 * (p + q);
        first += d / 6.0 * (a * p + 4.0 * m * r + b * q);
        second += d / 6.0 * (a * a * p + 4.0 * m * m * r + b * b * q);
    }
    let mean = first / total;
    (
        origin + mean,
        (second / total - mean * mean).max(0.0).sqrt(),
    )
}

impl Variations {
    /// Variations in a model.
    pub fn of(model: &Model) -> Self {
        let mut all = Self::default();
        for parameter in &model.parameters {
            let distribution = parameter
                .distribution
                .clone()
                .unwrap_or(Distribution::Uniform);
            if let Some((below, above)) = parameter.deviations {
                all.list.push(Variation {
                    parameter: parameter.clone(),
                    deviations: [-below, above],
                    distribution,
                });
            } else if let Some(position) = &parameter.position {
                let radius = 0.5 * position.zone;
                let first = all.list.len();
                let other = model.parameters.iter().find(|p| p.name == position.with);
                for parameter in [Some(parameter), other].into_iter().flatten() {
                    all.list.push(Variation {
                        parameter: parameter.clone(),
                        deviations: [-radius, radius],
                        distribution: Distribution::Uniform,
                    });
                }
                all.zones.push(Zone {
                    coordinates: [first, first + 1],
                    radius,
                });
            }
        }
        all
    }

    /// As many as there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether nothing varies.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The values that parameters are set to for some deviations.
    pub fn settings(&self, set: &[Setting], deviations: &[f64]) -> Vec<Setting> {
        let deviated = self.list.iter().zip(deviations);
        let moved = deviated.filter(|(_, by)| **by != 0.0);
        (set.iter().cloned())
            .chain(moved.map(|(v, by)| v.parameter.deviated(*by)))
            .collect()
    }

    /// As these, each tolerance by a factor of its own.
    #[must_use]
    pub fn by(&self, factors: &[f64]) -> Self {
        let list = self.list.iter().zip(factors);
        let list = list.map(|(v, &factor)| {
            let value = v.parameter.value;
            let distribution = match &v.distribution {
                Distribution::Table(rows) => {
                    let row = |&[x, density]: &[f64; 2]| [value + factor * (x - value), density];
                    Distribution::Table(rows.iter().map(row).collect())
                }
                other => other.clone(),
            };
            Variation {
                parameter: v.parameter.clone(),
                deviations: v.deviations.map(|d| d * factor),
                distribution,
            }
        });
        let zones = self.zones.iter().map(|zone| Zone {
            radius: zone.radius * factors[zone.coordinates[0]],
            ..*zone
        });
        Self {
            list: list.collect(),
            zones: zones.collect(),
        }
    }

    /// The box of deviations, all tolerances by a factor.
    pub fn scaled(&self, factor: f64) -> Vec<[f64; 2]> {
        let scaled = |v: &Variation| v.deviations.map(|d| d * factor);
        self.list.iter().map(scaled).collect()
    }

    /// Standard deviations.
    pub fn sigmas(&self) -> Vec<f64> {
        let mut sigmas: Vec<f64> = self.list.iter().map(Variation::sigma).collect();
        for zone in &self.zones {
            // Uniform in a disc: a quarter of the square of the radius.
            for &i in &zone.coordinates {
                sigmas[i] = 0.5 * zone.radius;
            }
        }
        sigmas
    }

    /// Deviations by chance.
    pub fn draw(&self, random: &mut impl Rng) -> Vec<f64> {
        let mut all: Vec<f64> = self.list.iter().map(|v| v.draw(random)).collect();
        for zone in &self.zones {
            let (r, angle) = (random.random::<f64>().sqrt(), TAU * random.random::<f64>());
            let [i, j] = zone.coordinates;
            all[i] = zone.radius * r * angle.cos();
            all[j] = zone.radius * r * angle.sin();
        }
        all
    }

    /// How many times the tolerances deviations are.
    pub fn share(&self, deviations: &[f64]) -> f64 {
        let mut share = 0.0_f64;
        for (i, (v, &d)) in self.list.iter().zip(deviations).enumerate() {
            if self.zone_of(i).is_none() {
                let side = v.deviations[usize::from(d > 0.0)];
                share = share.max(if d == 0.0 { 0.0 } else { d / side });
            }
        }
        for zone in &self.zones {
            let [i, j] = zone.coordinates;
            share = share.max(deviations[i].hypot(deviations[j]) / zone.radius);
        }
        share
    }

    /// The zone that a variation is a coordinate of.
    pub fn zone_of(&self, i: usize) -> Option<Zone> {
        let mut zones = self.zones.iter();
        zones.find(|z| z.coordinates.contains(&i)).copied()
    }

    /// The deviations, all tolerances by a factor, at which a linear function of these slopes is largest.
    pub fn farthest(&self, slopes: &[f64], factor: f64) -> Vec<f64> {
        let mut all: Vec<f64> = (self.list.iter().zip(slopes))
            .map(|(v, &s)| match s {
                s if s > 0.0 => factor * v.deviations[1],
                s if s < 0.0 => factor * v.deviations[0],
                _ => 0.0,
            })
            .collect();
        for zone in &self.zones {
            let [i, j] = zone.coordinates;
            let long = slopes[i].hypot(slopes[j]);
            for k in [i, j] {
                all[k] = if long > 0.0 {
                    factor * zone.radius * slopes[k] / long
                } else {
                    0.0
                };
            }
        }
        all
    }
}

/// The middle of a box, and half its widths.
pub(super) fn middle_and_half(ranges: &[[f64; 2]]) -> (Vec<f64>, Vec<f64>) {
    let middle = ranges.iter().map(|[lo, hi]| 0.5 * (lo + hi)).collect();
    let half = ranges.iter().map(|[lo, hi]| 0.5 * (hi - lo)).collect();
    (middle, half)
}

/// Both halves of a box by one of its parameters.
pub(super) fn halves(ranges: &[[f64; 2]], k: usize) -> [Vec<[f64; 2]>; 2] {
    let middle = 0.5 * (ranges[k][0] + ranges[k][1]);
    let mut both = [ranges.to_vec(), ranges.to_vec()];
    both[0][k][1] = middle;
    both[1][k][0] = middle;
    both
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_have_their_moments() {
        // A triangle over (0, 1, 2): mean 1, variance 1/6; half of it below 1.
        let rows = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]];
        let (mean, sigma) = moments(&rows);
        assert!((mean - 1.0).abs() < 1e-12 && (sigma - (1.0_f64 / 6.0).sqrt()).abs() < 1e-12);
        assert!((from_table(&rows, 0.5) - 1.0).abs() < 1e-12);
        // An eighth lies below a half.
        assert!((from_table(&rows, 0.125) - 0.5).abs() < 1e-12);
        assert!((from_table(&rows, 1.0) - 2.0).abs() < 1e-12);
    }
}

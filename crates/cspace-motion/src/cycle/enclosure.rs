//! Where the parts of a linkage are at a time, and bounds of that over an interval of time.
//!
//! The joints are n equations F(x, t) = 0 for n coordinates x. About a solution x₀ in the middle of an interval T, with C the inverse of the
//! derivative there, Krawczyk's operator
//!
//! ```text
//! K(X) = x₀ − C F(x₀, T) + (1 − C F′(X, T)) (X − x₀)
//! ```
//!
//! maps a box X into itself only if for every time of T there is one solution in X, and one alone. Rates and accelerations are solutions of linear
//! equations with the same derivative, and are enclosed likewise.

use cspace::{Ball, Dual, Real};
use nalgebra::DMatrix;

use super::linkage::Linkage;
use crate::system::System;

/// Steps of Newton's method: they converge quadratically.
const MOST_STEPS: usize = 12;
/// A step no longer than this share of the mechanism's size is the last.
const CLOSED: f64 = 1e-13;
/// A box is enlarged so often before the interval is too long.
const ENLARGED: usize = 6;
/// Enclosures of linear equations are improved so often.
const IMPROVED: usize = 3;
/// Equations that are left out, as they follow from the others, hold to this share of the size.
const FOLLOWS: f64 = 1e-9;

/// The coordinates of a linkage over an interval of time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Enclosed {
    /// All that they can be.
    pub(super) within: Vec<Ball>,
    /// Bounds of the absolute values of their accelerations.
    pub(super) bend: Vec<f64>,
}

/// A linkage with the coordinates of everything else.
pub(super) struct Equations<'a> {
    pub(super) system: &'a System,
    pub(super) linkage: &'a Linkage,
}

/// The derivative at a solution.
struct Local {
    /// The equations that are solved, by their numbers among those of the joints.
    rows: Vec<usize>,
    inverse: DMatrix<f64>,
}

impl Equations<'_> {
    fn n(&self) -> usize {
        self.linkage.unknown.len()
    }

    fn length(&self, k: usize) -> f64 {
        self.system.lengths()[self.linkage.unknown[k]]
    }

    /// All coordinates: those of the linkage as given, driven ones by `drive`.
    fn all<T: Real>(&self, x: &[T], drive: impl Fn(&crate::DriveCurve) -> T) -> Vec<T> {
        let mut q = vec![T::constant(0.0); self.system.count()];
        for (&i, &value) in self.linkage.unknown.iter().zip(x) {
            q[i] = value;
        }
        for (i, curve) in self.system.drives() {
            q[*i] = drive(curve);
        }
        q
    }

    /// The derivative of all equations by the unknown, at a time.
    fn jacobian(&self, x: &[f64], time: f64) -> (DMatrix<f64>, Vec<f64>) {
        let q = self.all(x, |curve| curve.at(time).value);
        let rows = self.system.joints_of(&self.linkage.joints, &q);
        let mut jacobian = DMatrix::<f64>::zeros(rows.len(), self.n());
        for (r, row) in rows.iter().enumerate() {
            for &(i, d) in row.entries() {
                if let Ok(k) = self.linkage.unknown.binary_search(&i) {
                    jacobian[(r, k)] = d;
                }
            }
        }
        (jacobian, rows.iter().map(|row| row.value).collect())
    }

    /// Independent equations, as many as there are coordinates, and the inverse of their derivative.
    fn local(&self, jacobian: &DMatrix<f64>) -> Option<Local> {
        let n = self.n();
        let rows = match jacobian.nrows() {
            m if m < n => return None,
            m if m == n => (0..n).collect(),
            _ => self.independent(jacobian),
        };
        let square = DMatrix::from_fn(n, n, |r, k| jacobian[(rows[r], k)]);
        let inverse = square.try_inverse()?;
        let is_finite = inverse.iter().all(|x| x.is_finite());
        is_finite.then_some(Local { rows, inverse })
    }

    /// The rows that are farthest from being combinations of those taken before.
    fn independent(&self, jacobian: &DMatrix<f64>) -> Vec<usize> {
        let n = self.n();
        let mut left: Vec<Vec<f64>> = (0..jacobian.nrows())
            .map(|r| (0..n).map(|k| jacobian[(r, k)] / self.length(k)).collect())
            .collect();
        let mut rows = Vec::with_capacity(n);
        for _ in 0..n {
            let square = |r: &usize| left[*r].iter().map(|x| x * x).sum::<f64>();
            let Some(next) = (0..left.len())
                .filter(|r| !rows.contains(r))
                .max_by(|a, b| square(a).total_cmp(&square(b)))
            else {
                break;
            };
            let length = square(&next).sqrt().max(f64::MIN_POSITIVE);
            let unit: Vec<f64> = left[next].iter().map(|x| x / length).collect();
            for row in &mut left {
                let along: f64 = row.iter().zip(&unit).map(|(a, b)| a * b).sum();
                for (x, u) in row.iter_mut().zip(&unit) {
                    *x -= along * u;
                }
            }
            rows.push(next);
        }
        rows.sort_unstable();
        rows
    }

    /// The solution at a time beside a guess; none if Newton's method leads to none, or the joints contradict each other there.
    pub(super) fn solve(&self, time: f64, guess: &[f64]) -> Option<Vec<f64>> {
        let size = self.system.size();
        let mut x = guess.to_vec();
        let mut before = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let (jacobian, values) = self.jacobian(&x, time);
            let local = self.local(&jacobian)?;
            let mut far = 0.0_f64;
            for (k, of) in x.iter_mut().enumerate() {
                let step: f64 = (local.rows.iter().enumerate())
                    .map(|(c, &r)| local.inverse[(k, c)] * values[r])
                    .sum();
                *of -= step;
                far = far.max((step * self.length(k)).abs());
            }
            if !far.is_finite() {
                return None;
            }
            // At a dead point the steps halve, and end in rounding.
            if far <= CLOSED * size || (far < 1e-6 * size && far > 0.5 * before) {
                let (_, values) = self.jacobian(&x, time);
                let open = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                return (open <= FOLLOWS * size).then_some(x);
            }
            before = far;
        }
        None
    }

    /// Rates of the coordinates at a solution.
    pub(super) fn rates(&self, time: f64, x: &[f64]) -> Option<Vec<f64>> {
        let (jacobian, _) = self.jacobian(x, time);
        let local = self.local(&jacobian)?;
        let q = self.all(x, |curve| curve.at(time).value);
        let rows = self.system.joints_of(&self.linkage.joints, &q);
        let mut v = vec![0.0; self.system.count()];
        for (i, curve) in self.system.drives() {
            v[*i] = curve.at(time).rate;
        }
        let pushed: Vec<f64> = local.rows.iter().map(|&r| rows[r].rate(&v)).collect();
        Some(
            (0..self.n())
                .map(|k| {
                    let each = pushed.iter().enumerate();
                    -each.map(|(c, b)| local.inverse[(k, c)] * b).sum::<f64>()
                })
                .collect(),
        )
    }

    /// Bounds over an interval of time, about a solution in its middle; none if the interval is too long for them.
    pub(super) fn enclosed(&self, [lo, hi]: [f64; 2], middle: &[f64]) -> Option<Enclosed> {
        let n = self.n();
        let (half, time) = (0.5 * (hi - lo), 0.5 * (lo + hi));
        let (jacobian, _) = self.jacobian(middle, time);
        let local = self.local(&jacobian)?;
        let rates = self.rates(time, middle)?;
        let inverse = |k: usize, c: usize| Ball::constant(local.inverse[(k, c)]);
        let times = |b: &[Ball]| -> Vec<Ball> {
            (0..n)
                .map(|k| {
                    let zero = Ball::constant(0.0);
                    (0..n).fold(zero, |sum, c| sum + inverse(k, c) * b[c])
                })
                .collect()
        };
        let centers: Vec<Ball> = middle.iter().map(|&x| Ball::constant(x)).collect();
        let motions = |d: usize| move |curve: &crate::DriveCurve| curve.over([lo, hi])[d];
        let fixed = {
            let q = self.all(&centers, motions(0));
            let rows = self.system.joints_of(&self.linkage.joints, &q);
            let values: Vec<Ball> = local.rows.iter().map(|&r| rows[r].value).collect();
            times(&values)
        };
        // What is left of the unit matrix, over a box.
        let rest = |within: &[Ball]| -> Vec<Vec<Ball>> {
            let q = self.all(within, motions(0));
            let rows = self.system.joints_of(&self.linkage.joints, &q);
            let mut rest = vec![vec![Ball::constant(0.0); n]; n];
            for (k, own) in rest.iter_mut().enumerate() {
                own[k] = Ball::constant(1.0);
                for (c, &r) in local.rows.iter().enumerate() {
                    for &(i, d) in rows[r].entries() {
                        if let Ok(j) = self.linkage.unknown.binary_search(&i) {
                            own[j] = own[j] - inverse(k, c) * d;
                        }
                    }
                }
            }
            rest
        };
        let size = self.system.size();
        let mut radius: Vec<f64> = (0..n)
            .map(|k| 1.25 * rates[k].abs() * half + 1e-13 * size / self.length(k))
            .collect();
        let mut found = None;
        for _ in 0..ENLARGED {
            let within: Vec<Ball> = (0..n).map(|k| Ball::new(middle[k], radius[k])).collect();
            let rest = rest(&within);
            let image: Vec<Ball> = (0..n)
                .map(|k| {
                    let start = centers[k] - fixed[k];
                    (0..n).fold(start, |sum, j| sum + rest[k][j] * Ball::new(0.0, radius[j]))
                })
                .collect();
            let reach = |k: usize| (image[k].mid - middle[k]).abs() + image[k].radius;
            if (0..n).all(|k| reach(k) < radius[k]) {
                found = Some((image, rest));
                break;
            }
            for (k, r) in radius.iter_mut().enumerate() {
                *r = r.max(1.25 * reach(k));
            }
            if radius.iter().any(|r| !r.is_finite()) {
                return None;
            }
        }
        let (within, rest) = found?;
        // Solutions of F′ y = b, given C b.
        let linear = |b: &[Ball]| -> Option<Vec<Ball>> {
            let share = (0..n).map(|k| {
                let each = (0..n).map(|j| {
                    let e = rest[k][j];
                    (e.mid.abs() + e.radius) * self.length(k) / self.length(j)
                });
                each.sum::<f64>()
            });
            let share = share.fold(0.0, f64::max);
            let most = (0..n).map(|k| (b[k].mid.abs() + b[k].radius) * self.length(k));
            let most = most.fold(0.0, f64::max) / (1.0 - share);
            if share.is_nan() || share >= 1.0 || !most.is_finite() {
                return None;
            }
            let mut y: Vec<Ball> = (0..n)
                .map(|k| Ball::new(0.0, most * (1.0 + 1e-12) / self.length(k)))
                .collect();
            for _ in 0..IMPROVED {
                y = (0..n)
                    .map(|k| (0..n).fold(b[k], |sum, j| sum + rest[k][j] * y[j]))
                    .collect();
            }
            Some(y)
        };
        let driven: Vec<(usize, [Ball; 3])> = (self.system.drives().iter())
            .map(|(i, curve)| (*i, curve.over([lo, hi])))
            .collect();
        let of = |i: usize, d: usize| {
            let drive = driven.iter().find(|drive| drive.0 == i);
            drive.map(|drive| drive.1[d])
        };
        let rates = {
            let q = self.all(&within, motions(0));
            let rows = self.system.joints_of(&self.linkage.joints, &q);
            let pushed: Vec<Ball> = (local.rows.iter())
                .map(|&r| {
                    let zero = Ball::constant(0.0);
                    let each = rows[r].entries().iter();
                    each.filter_map(|&(i, d)| Some(-(d * of(i, 1)?)))
                        .fold(zero, |a, b| a + b)
                })
                .collect();
            linear(&times(&pushed))?
        };
        let bend = {
            let moving: Vec<Dual<1, Ball>> = (within.iter().zip(&rates))
                .map(|(&value, &rate)| Dual {
                    value,
                    slope: [rate],
                })
                .collect();
            let q = self.all(&moving, |curve| {
                let [value, rate, _] = curve.over([lo, hi]);
                Dual {
                    value,
                    slope: [rate],
                }
            });
            let rows = self.system.joints_of(&self.linkage.joints, &q);
            let pushed: Vec<Ball> = (local.rows.iter())
                .map(|&r| {
                    let zero = Ball::constant(0.0);
                    let each = rows[r].entries().iter();
                    each.map(|&(i, d)| {
                        let turned = d.slope[0] * q[i].slope[0];
                        let driven = of(i, 2).map_or(zero, |a| d.value * a);
                        -(turned + driven)
                    })
                    .fold(zero, |a, b| a + b)
                })
                .collect();
            linear(&times(&pushed))?
        };
        Some(Enclosed {
            within,
            bend: bend.iter().map(|b| b.mid.abs() + b.radius).collect(),
        })
    }
}

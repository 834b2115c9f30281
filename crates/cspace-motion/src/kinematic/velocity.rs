//! Velocities at one configuration and time: unconstrained, constrained by the active contacts, and the projection of
//! the first onto the second.
//!
//! With the metric M of the outlines, including dampers, and the forces F, the free velocity is M⁻¹ F. In the
//! coordinates y = Lᵀ v, M = L Lᵀ, distances are Euclidean: the velocity is the point of a cone that is nearest to y₀ =
//! L⁻¹ F. Joints are equations and are eliminated first; the nearest point is then the solution of a least-squares
//! problem with nonnegative multipliers.
//!
//! Source: Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23: least distance programming.

use std::borrow::Cow;

use crate::linear::{Cholesky, Pushing, Rows, dot, length, nonnegative};
use crate::system::{Law, Row, System};

use super::holding::Holding;

/// Largest ratio of the speed of other parts to that of a driven part: beyond it the mechanism is at a dead point. Near
/// a dead point the ratio grows as the inverse of the distance to it, and events are located to some 1e-7 of a step
/// there.
const MOST_AMPLIFICATION: f64 = 1e5;
/// Violation of a bound, as a share of the speeds, that still counts as rounding: gradients are accurate to some 1e-15
/// of the parts' sizes, over short levers.
const ROUNDING: f64 = 1e-11;

/// A residual whose square is below this (of a target of length 1) is rounding.
const NOTHING: f64 = 1e-13;
/// An equation of a joint that is missed by more than this share of the speeds contradicts the others: half of the digits.
const CONTRADICTS: f64 = 1e-8;

/// The linear equations of motion at one configuration and time.
#[derive(Debug, Clone)]
pub(crate) struct Local<'a> {
    system: &'a System,
    factor: Cow<'a, Cholesky>,
    /// y of the free velocity.
    pub(super) free: Vec<f64>,
    /// y of the forces: of the velocity that they would be.
    pub(super) forces: Vec<f64>,
    /// The rates of all coordinates, of those that are free 0.
    pub(super) driven: Vec<f64>,
    pub(super) joints: Vec<(Vec<f64>, f64)>,
}

/// Velocity, with the bounds that hold it.
#[derive(Debug, Clone)]
pub(crate) struct Held {
    /// The rates of all coordinates.
    pub(crate) rates: Vec<f64>,
    /// Rates of the free coordinates, in y.
    pub(super) y: Vec<f64>,
    /// Multiplier of each requested bound, as a speed of the metric, to be compared with `speed`.
    pub(crate) pushes: Vec<f64>,
    /// The lengths of the directions in which they push.
    pub(super) lengths: Vec<f64>,
    /// The speed by the metric.
    pub(crate) speed: f64,
    /// The speed as a length per second, at least that of the free velocity: what rounding of rates is compared with.
    pub(super) fastest: f64,
    /// Number of independent directions that are constrained.
    pub(super) rank: usize,
    /// Whether the constraints leave no other velocity.
    pub(crate) determined: bool,
}

/// Result of the projection onto the velocities that bounds allow.
#[derive(Debug, Clone)]
pub(crate) enum Nearest {
    /// The nearest velocity, which bounds with positive multipliers hold, and its distance from the free one.
    Held { held: Vec<usize>, distance: f64 },
    /// Contradiction: a combination of the bounds with these multipliers, all at least 0.
    None { multipliers: Vec<f64> },
}

impl<'a> Local<'a> {
    /// Equations of motion at a configuration and a time; `None` if the metric is singular, or numbers are not finite.
    pub(crate) fn at(system: &'a System, q: &[f64], time: f64) -> Option<Self> {
        Self::with_joints(system, q, time, &system.joints(q))
    }

    /// As `at`, with the joints' equations there given.
    pub(super) fn with_joints(
        system: &'a System,
        q: &[f64],
        time: f64,
        joints: &[Row],
    ) -> Option<Self> {
        let n = system.count();
        let free = system.free();
        let mut driven = vec![0.0; n];
        for (i, curve) in system.drives() {
            driven[*i] = curve.at(time).rate;
        }
        let share = match system.law() {
            Law::Speeds { scale, .. } => scale,
            Law::Balance => 0.0,
        };
        // Dampers between driven and free parts pull.
        let pull = |matrix: &[f64], forces: &[f64]| -> Vec<f64> {
            let of = |&i: &usize| share * forces[i] - dot(&matrix[i * n..(i + 1) * n], &driven);
            free.iter().map(of).collect()
        };
        let (factor, mut pull, forces) = if let Some(metric) = system.metric() {
            let forces = system.forces(q);
            let pull = pull(&metric.matrix, &forces);
            (Cow::Borrowed(&metric.factor), pull, forces)
        } else {
            let (matrix, forces) = system.metric_and_forces(q);
            let factor = system.factor(&matrix)?;
            (Cow::Owned(factor), pull(&matrix, &forces), forces)
        };
        factor.forward(&mut pull);
        let mut acting: Vec<f64> = free.iter().map(|&i| forces[i]).collect();
        factor.forward(&mut acting);
        let mut local = Self {
            system,
            factor,
            free: pull,
            forces: acting,
            driven,
            joints: Vec::new(),
        };
        local.joints = joints.iter().map(|row| local.reduced(row)).collect();
        Some(local)
    }

    /// As `self`, with drives at rest, and forces as velocities.
    pub(super) fn still(&self) -> Self {
        let mut still = self.clone();
        still.driven.fill(0.0);
        still.free.clone_from(&self.forces);
        still.joints.iter_mut().for_each(|joint| joint.1 = 0.0);
        still
    }

    /// A vector over all coordinates, such as a force, in y.
    pub(super) fn reduced_force(&self, force: &[f64]) -> Vec<f64> {
        let mut y: Vec<f64> = self.system.free().iter().map(|&i| force[i]).collect();
        self.factor.forward(&mut y);
        y
    }

    /// A displacement of the free coordinates, from y, as one of all.
    pub(super) fn displaced(&self, y: &[f64]) -> Vec<f64> {
        let mut v = y.to_vec();
        self.factor.backward(&mut v);
        let mut all = vec![0.0; self.system.count()];
        for (&i, v) in self.system.free().iter().zip(v) {
            all[i] = v;
        }
        all
    }

    /// A row in y, and the rate that drives alone give its function, negated: row · y must be that, or more.
    pub(crate) fn reduced(&self, row: &Row) -> (Vec<f64>, f64) {
        let free = self.system.free();
        let mut by_free = vec![0.0; free.len()];
        for &(i, d) in row.entries() {
            if let Ok(k) = free.binary_search(&i) {
                by_free[k] = d;
            }
        }
        self.factor.forward(&mut by_free);
        (by_free, -row.rate(&self.driven))
    }

    /// The rates of all coordinates of y.
    pub(super) fn rates(&self, y: &[f64]) -> Vec<f64> {
        let mut v = y.to_vec();
        self.factor.backward(&mut v);
        let mut rates = self.driven.clone();
        for (&i, v) in self.system.free().iter().zip(v) {
            rates[i] = v;
        }
        rates
    }

    /// The shortest displacement of the free coordinates, by the metric, that changes functions by given amounts: joints
    /// first, then others.
    pub(crate) fn displacement(&self, rows: &[Row], changes: &[f64]) -> Vec<f64> {
        let (y, _) = Rows::of(&self.with_those(rows)).least(changes);
        let mut v = if y.is_empty() {
            vec![0.0; self.system.free().len()]
        } else {
            y
        };
        self.factor.backward(&mut v);
        v
    }

    /// Joints and constraints as equations in y, and the directions in which they push.
    pub(super) fn pushing(&self, holding: &Holding) -> Option<Pushing> {
        self.pushing_along(self.with_those(&holding.rows), holding.along.as_deref())
    }

    fn pushing_along(&self, vectors: Vec<Vec<f64>>, along: Option<&[Row]>) -> Option<Pushing> {
        Pushing::of(vectors, along.map(|rows| self.with_those(rows)))
    }

    /// Joints and other functions in y.
    fn with_those(&self, rows: &[Row]) -> Vec<Vec<f64>> {
        let joints = self.joints.iter().map(|(row, _)| row.clone());
        let others = rows.iter().map(|row| self.reduced(row).0);
        joints.chain(others).collect()
    }

    /// The velocity that keeps some functions as they are, and joints; `None` if what pushes cannot.
    pub(crate) fn held(&self, holding: &Holding) -> Option<Held> {
        let joints = self.joints.len();
        let (mut vectors, mut missing) = (Vec::new(), Vec::new());
        let reduced = holding.rows.iter().map(|row| self.reduced(row));
        for (vector, rate) in self.joints.iter().cloned().chain(reduced) {
            missing.push(rate - dot(&vector, &self.free));
            vectors.push(vector);
        }
        let pushing = self.pushing_along(vectors, holding.along.as_deref())?;
        let (mut y, lambda) = pushing.meet(&missing)?;
        if y.is_empty() {
            y.resize(self.free.len(), 0.0);
        }
        for (y, free) in y.iter_mut().zip(&self.free) {
            *y += free;
        }
        let lengths = pushing.lengths()[joints..].to_vec();
        let pushes = lambda[joints..].iter().zip(&lengths).map(|(m, l)| m * l);
        let rank = pushing.rows().rank();
        let rates = self.rates(&y);
        let free = self.system.speed(&self.rates(&self.free));
        Some(Held {
            fastest: free.max(self.system.speed(&rates)),
            rates,
            pushes: pushes.collect(),
            lengths,
            speed: length(&y).max(length(&self.free)),
            y,
            rank,
            determined: holding.is_of_places() && rank == self.system.free().len(),
        })
    }

    /// Whether drives contradict the joints, or the mechanism is at a dead point.
    pub(crate) fn is_stuck(&self) -> bool {
        let vectors: Vec<Vec<f64>> = self.joints.iter().map(|(v, _)| v.clone()).collect();
        let missing: Vec<f64> = (self.joints.iter())
            .map(|(v, b)| b - dot(v, &self.free))
            .collect();
        let (y, _) = Rows::of(&vectors).least(&missing);
        let scale = missing.iter().fold(0.0_f64, |s, m| s.max(m.abs()));
        let off = |(v, m): (&Vec<f64>, &f64)| {
            let found = if y.is_empty() { 0.0 } else { dot(v, &y) };
            (found - m).abs() > CONTRADICTS * scale
        };
        vectors.iter().zip(&missing).any(off) || self.is_amplified(&y, scale)
    }

    /// Whether a change of velocity, in y, is larger than the free velocity and the speeds (length per second) that
    /// cause it can explain.
    fn is_amplified(&self, y: &[f64], speed: f64) -> bool {
        let fastest = |y: &[f64]| {
            let mut v = y.to_vec();
            self.factor.backward(&mut v);
            let free = self.system.free().iter();
            let speeds = free
                .zip(v)
                .map(|(&i, v)| (v * self.system.lengths()[i]).abs());
            speeds.fold(0.0, f64::max)
        };
        !y.is_empty() && fastest(y) > MOST_AMPLIFICATION * fastest(&self.free).max(speed)
    }

    /// The velocity nearest to the free one at which no function of `rows` decreases, and some of them do not change.
    pub(super) fn nearest_with(&self, rows: &[Row], kept: &[usize]) -> Nearest {
        if kept.is_empty() {
            return self.nearest(rows);
        }
        let mut with = self.clone();
        with.joints
            .extend(kept.iter().map(|&i| self.reduced(&rows[i])));
        if with.is_stuck() {
            return Nearest::None {
                multipliers: vec![0.0; rows.len()],
            };
        }
        let others: Vec<usize> = (0..rows.len()).filter(|i| !kept.contains(i)).collect();
        let other: Vec<Row> = others.iter().map(|&i| rows[i]).collect();
        match with.nearest(&other) {
            Nearest::Held { held, distance } => {
                let mut all = kept.to_vec();
                all.extend(held.into_iter().map(|k| others[k]));
                all.sort_unstable();
                Nearest::Held {
                    held: all,
                    distance,
                }
            }
            Nearest::None { multipliers } => {
                let mut all = vec![0.0; rows.len()];
                for (&i, m) in others.iter().zip(multipliers) {
                    all[i] = m;
                }
                Nearest::None { multipliers: all }
            }
        }
    }

    /// The velocity nearest to the free one at which no function of `rows` decreases.
    pub(crate) fn nearest(&self, rows: &[Row]) -> Nearest {
        let vectors: Vec<Vec<f64>> = self.joints.iter().map(|(v, _)| v.clone()).collect();
        let missing: Vec<f64> = (self.joints.iter())
            .map(|(v, b)| b - dot(v, &self.free))
            .collect();
        let joints = Rows::of(&vectors);
        let (correction, _) = joints.least(&missing);
        let mut start = self.free.clone();
        for (y, c) in start.iter_mut().zip(&correction) {
            *y += c;
        }
        // Each bound g·z ≥ h for the displacement z from there, along the joints.
        let bounds: Vec<(Vec<f64>, f64)> = (rows.iter())
            .map(|row| {
                let (mut g, b) = self.reduced(row);
                let (before, rate) = (length(&g), b - dot(&g, &start));
                joints.take_out(&mut g);
                let long = length(&g);
                // A bound that no free velocity changes: it holds or it does not.
                if long <= ROUNDING * before || long == 0.0 {
                    g.fill(0.0);
                    let speed = if before > 0.0 { before } else { 1.0 };
                    (g, rate / speed)
                } else {
                    g.iter_mut().for_each(|x| *x /= long);
                    (g, rate / long)
                }
            })
            .collect();
        let scale = bounds.iter().fold(0.0_f64, |s, (_, h)| s.max(h.abs()));
        let speed = length(&start).max(length(&self.free));
        let violated = bounds.iter().any(|(_, h)| *h > ROUNDING * scale.max(speed));
        if !violated {
            return Nearest::Held {
                held: Vec::new(),
                distance: 0.0,
            };
        }
        let n = start.len();
        let columns: Vec<Vec<f64>> = (bounds.iter())
            .map(|(g, h)| g.iter().copied().chain([h / scale]).collect())
            .collect();
        let mut target = vec![0.0; n + 1];
        target[n] = 1.0;
        let solved = nonnegative(&columns, &target);
        // z = −r/ρ in units of `scale`, with the residual (r, ρ); if ρ is 0 there is none.
        let rest = solved.residual[n];
        let jams = rest < NOTHING || {
            let z: Vec<f64> = (solved.residual[..n].iter())
                .map(|r| -scale * r / rest)
                .collect();
            let missed = rows.iter().map(|row| {
                let (g, b) = self.reduced(row);
                (b - dot(&g, &start)).abs()
            });
            self.is_amplified(&z, missed.fold(0.0, f64::max))
        };
        if jams {
            return Nearest::None {
                multipliers: solved.u,
            };
        }
        let held = (0..rows.len())
            .filter(|&j| solved.u[j] > ROUNDING * rest)
            .collect();
        let distance = length(&solved.residual[..n]) / rest * scale;
        Nearest::Held { held, distance }
    }
}

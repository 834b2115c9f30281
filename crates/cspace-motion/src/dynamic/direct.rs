//! Direct solution for accelerations and corrections, with equations that all hold and a diagonal mass matrix.
//!
//! With a diagonal mass matrix M the equations M x = h + Σ λ c, r · x = b, of as many directions c as rows r, are a
//! small system in the forces λ alone. Where it is singular, as with dependent joints or contacts, the slower methods
//! that can handle these are used.

use core::ops::Range;

use nalgebra::{DMatrix, DVector};

use crate::linear::Square;

use super::world::{Equations, Touch};
use crate::complementarity::{Mode, Solution};

/// The inverse of a diagonal mass matrix.
#[derive(Debug, Clone)]
pub(super) struct Lightness(Vec<f64>);

/// Rows r and directions c, one after the other, with what each row is to be.
#[derive(Debug, Default)]
struct System {
    rows: Vec<f64>,
    directions: Vec<f64>,
    targets: Vec<f64>,
    /// Non-zero ranges of each row and its direction: those of the parts of a joint or a contact.
    within: Vec<Range<usize>>,
}

impl System {
    fn push(&mut self, row: impl Iterator<Item = f64> + Clone, target: f64) {
        let (mut first, mut end) = (usize::MAX, 0);
        for (i, _) in row.clone().enumerate().filter(|(_, r)| *r != 0.0) {
            (first, end) = (first.min(i), i + 1);
        }
        self.within.push(first.min(end)..end);
        self.directions.extend(row.clone());
        self.rows.extend(row);
        self.targets.push(target);
    }
}

impl System {
    /// Extends the non-zero range of the last row to an index.
    fn reach(&mut self, i: usize) {
        if let Some(within) = self.within.last_mut() {
            *within = match within.end {
                0 => i..i + 1,
                end => within.start.min(i)..end.max(i + 1),
            };
        }
    }
}

impl Lightness {
    /// `None` if the matrix is not diagonal, with positive numbers.
    pub(super) fn of(mass: &DMatrix<f64>) -> Option<Self> {
        let n = mass.nrows();
        let is_diagonal = (0..n).all(|i| (0..n).all(|k| (i == k) == (mass[(i, k)] != 0.0)));
        let all: Vec<f64> = mass.diagonal().iter().map(|m| 1.0 / m).collect();
        (is_diagonal && all.iter().all(|w| w.is_finite() && *w > 0.0)).then_some(Self(all))
    }

    /// r · c, by the inverse masses, where both are not 0.
    fn product(&self, (r, a): (&[f64], &Range<usize>), (c, b): (&[f64], &Range<usize>)) -> f64 {
        let within = a.start.max(b.start)..a.end.min(b.end);
        let all = within.map(|i| r[i] * c[i] * self.0[i]);
        all.sum()
    }

    /// λ, and M⁻¹ (h + Σ λ c); `None` if the system is singular.
    fn solved(&self, system: &System, h: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
        let (n, count) = (self.0.len(), system.targets.len());
        let row = |i: usize| &system.rows[i * n..][..n];
        let direction = |i: usize| &system.directions[i * n..][..n];
        let within = |i: usize| &system.within[i];
        let mut x: Vec<f64> = h.iter().zip(&self.0).map(|(h, w)| h * w).collect();
        let mut forces = vec![0.0; count];
        if count == 0 {
            return Some((forces, x));
        }
        // In units in which each force moves its own row by 1.
        let units: Vec<f64> = (0..count)
            .map(|i| {
                let own = self.product((row(i), within(i)), (row(i), within(i)));
                if own > 0.0 { own.sqrt().recip() } else { 1.0 }
            })
            .collect();
        let square = Square::of(DMatrix::from_fn(count, count, |i, k| {
            self.product((row(i), within(i)), (direction(k), within(k))) * units[i] * units[k]
        }))?;
        if !square.is_regular() {
            return None;
        }
        // A second round takes out what rounding has left.
        for _ in 0..2 {
            let missing: Vec<f64> = (0..count)
                .map(|i| {
                    let is: f64 = within(i).clone().map(|j| row(i)[j] * x[j]).sum();
                    (system.targets[i] - is) * units[i]
                })
                .collect();
            for (k, more) in square.basic(&missing).iter().enumerate() {
                let more = more * units[k];
                forces[k] += more;
                for j in within(k).clone() {
                    x[j] += self.0[j] * direction(k)[j] * more;
                }
            }
        }
        (x.iter().all(|x| x.is_finite())).then_some((forces, x))
    }

    /// Accelerations and forces with contacts in their modes.
    pub(super) fn accelerations(
        &self,
        equations: &Equations,
        bearings: &[(usize, Mode)],
        friction: impl Fn(usize) -> f64,
    ) -> Option<Solution> {
        let mut system = System::default();
        for (row, bend) in equations
            .joints
            .row_iter()
            .zip(equations.joint_bends.iter())
        {
            system.push(row.iter().copied(), *bend);
        }
        let n = self.0.len();
        for (&(contact, mode), (touch, [b, _])) in bearings.iter().zip(&equations.contacts) {
            system.push(touch.normal.iter().copied(), -b);
            let drag = -mode.direction() * friction(contact);
            if drag != 0.0 {
                let last = system.directions.len() - n;
                for (i, t) in touch.tangent.iter().enumerate().filter(|t| *t.1 != 0.0) {
                    system.directions[last + i] += drag * t;
                    system.reach(i);
                }
            }
        }
        for ((_, mode), (touch, [_, c])) in bearings.iter().zip(&equations.contacts) {
            if *mode == Mode::Stick {
                system.push(touch.tangent.iter().copied(), -c);
            }
        }
        let (forces, x) = self.solved(&system, equations.force.as_slice())?;
        let joints = equations.joint_bends.len();
        let mut stuck = forces[joints + bearings.len()..].iter();
        let normal = forces[joints..joints + bearings.len()].to_vec();
        let tangential = (bearings.iter().zip(&normal))
            .map(|(&(contact, mode), normal)| match mode {
                Mode::Stick => stuck.next().copied().unwrap_or(0.0),
                mode => -mode.direction() * friction(contact) * normal,
            })
            .collect();
        Some(Solution {
            x: DVector::from_vec(x),
            modes: bearings.iter().map(|b| b.1).collect(),
            normal,
            tangential,
            joints: DVector::from_column_slice(&forces[..joints]),
            rates: Vec::new(),
        })
    }

    /// The least change, in the metric of the masses, that changes what joints and contacts measure by given amounts: of the joints, then
    /// of gaps, then, if there are that many, of what sticks across.
    pub(super) fn least(
        &self,
        joints: &DMatrix<f64>,
        touches: &[Touch],
        stuck: &[&Touch],
        by: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let mut system = System::default();
        let mut by = by.iter().copied();
        for row in joints.row_iter() {
            system.push(row.iter().copied(), by.next()?);
        }
        for touch in touches {
            system.push(touch.normal.iter().copied(), by.next()?);
        }
        for touch in stuck {
            system.push(touch.tangent.iter().copied(), by.next()?);
        }
        let still = vec![0.0; self.0.len()];
        Some(DVector::from_vec(self.solved(&system, &still)?.1))
    }
}

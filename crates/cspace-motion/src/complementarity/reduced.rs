//! Reduction of the problem to the forces of contacts alone.
//!
//! With M = L Lᵀ and y = Lᵀ x the masses are 1. Joints remove a component from every direction. With the rows k of L⁻¹
//! n and L⁻¹ τ without that component,
//!
//! ```text
//! y = y₀ + Σ λ k,   a = a₀ + W λ,   W = k · k
//! ```
//!
//! W, Delassus's operator, is computed once; each combination of modes is then a small system in the forces of the contacts that bear.
//! Dependent joints are allowed if they do not contradict each other.

use nalgebra::{DMatrix, DVector};

use crate::linear::{Cholesky, Rows, Square, add_scaled, dot, length};

use super::problem::{Mode, Problem, Solution};

/// Equations hold to this share of their terms.
const HOLDS: f64 = 1e-9;
/// A contact direction counts as taken away by the joints if less than this share of it is left. Such a remainder is
/// rounding, and would become a large error for joints that turn a little.
const NOTHING: f64 = 1e-10;

/// Forces of contacts and the rates they leave: λ_N and λ_T, a_N and a_T of each contact in turn.
#[derive(Debug, Clone, Default)]
pub(crate) struct Forces {
    pub(crate) forces: Vec<f64>,
    pub(crate) rates: Vec<f64>,
    /// Largest terms of forces and of rates, which determine the rounding.
    pub(crate) scale: (f64, f64),
}

/// A force that is sought: λ_N with the friction of sliding that follows from it, or λ_T.
struct Sought {
    /// The rate that it makes 0.
    row: usize,
    /// λ_T / λ_N.
    drag: f64,
}

/// The reduced problem.
#[derive(Debug)]
pub(crate) struct Reduced<'a> {
    problem: &'a Problem<'a>,
    factor: Cholesky,
    joints: Rows,
    /// The rows of the joints, L⁻¹ J.
    joint_rows: Vec<Vec<f64>>,
    /// y without contacts.
    free: Vec<f64>,
    /// The sums of the sizes of its terms.
    sizes: Vec<f64>,
    /// The rows k, two of each contact, one after the other.
    directions: Vec<f64>,
    /// W by rows.
    pub(crate) operator: Vec<f64>,
    /// a₀, and the sum of the sizes of its terms.
    pub(crate) rates: Vec<f64>,
    terms: Vec<f64>,
    force: f64,
}

impl<'a> Reduced<'a> {
    /// `None` if masses are not positive, joints contradict each other, or numbers are not finite.
    pub(crate) fn of(problem: &'a Problem<'a>) -> Option<Self> {
        let n = problem.h.len();
        let factor = Cholesky::of(problem.mass.as_slice(), n)?;
        let mut loads = problem.h.as_slice().to_vec();
        factor.forward(&mut loads);
        let (joints, joint_rows, free) = jointed(problem, &factor, &loads)?;
        for (x, load) in free.iter().zip(&mut loads) {
            *load = load.abs() + x.abs();
        }
        let count = 2 * problem.bearings.len();
        let mut directions = Vec::with_capacity(count * n);
        let mut rates = Vec::with_capacity(count);
        let mut terms = Vec::with_capacity(count);
        for bearing in &problem.bearings {
            for (row, constant) in [(&bearing.normal, bearing.b), (&bearing.tangent, bearing.c)] {
                let start = directions.len();
                directions.extend_from_slice(row.as_slice());
                let k = &mut directions[start..];
                factor.forward(k);
                let sizes: f64 = k.iter().zip(&loads).map(|(k, y)| k.abs() * y).sum();
                terms.push(sizes + constant.abs());
                rates.push(dot(k, &free) + constant);
                let before = length(k);
                joints.take_out(k);
                if length(k) <= NOTHING * before {
                    k.fill(0.0);
                }
            }
        }
        let mut operator = vec![0.0; count * count];
        for i in 0..count {
            for j in 0..=i {
                let product = dot(&directions[i * n..][..n], &directions[j * n..][..n]);
                operator[i * count + j] = product;
                operator[j * count + i] = product;
            }
        }
        let force = problem.h.amax();
        let finite = |all: &[f64]| all.iter().all(|x| x.is_finite());
        let numbers = finite(&operator) && finite(&terms) && finite(&free);
        numbers.then_some(Self {
            problem,
            factor,
            joints,
            joint_rows,
            free,
            sizes: loads,
            directions,
            operator,
            rates,
            terms,
            force,
        })
    }

    /// The forces in some modes, whether the inequalities hold or not; `None` if the equations have no solution.
    pub(crate) fn forces(&self, modes: &[Mode]) -> Option<Forces> {
        let count = self.rates.len();
        let mut sought = Vec::with_capacity(count);
        for (i, (mode, bearing)) in modes.iter().zip(&self.problem.bearings).enumerate() {
            let (row, drag) = (2 * i, -mode.direction() * bearing.friction);
            if *mode != Mode::Open {
                sought.push(Sought { row, drag });
            }
            if *mode == Mode::Stick {
                let row = row + 1;
                sought.push(Sought { row, drag: 0.0 });
            }
        }
        let entry = |row: usize, column: usize| self.operator[row * count + column];
        // In units in which each force moves its own contact by 1.
        let unit = |s: &Sought| {
            let own = entry(s.row, s.row);
            if own > 0.0 { own.sqrt().recip() } else { 1.0 }
        };
        let units: Vec<f64> = sought.iter().map(unit).collect();
        let effects = DMatrix::from_fn(sought.len(), sought.len(), |i, j| {
            let (row, column) = (sought[i].row, &sought[j]);
            let mut effect = entry(row, column.row);
            if column.drag != 0.0 {
                effect += column.drag * entry(row, column.row + 1);
            }
            effect * units[i] * units[j]
        });
        let square = Square::of(effects)?;
        let target = |(s, unit): (&Sought, &f64)| -self.rates[s.row] * unit;
        let target: Vec<f64> = sought.iter().zip(&units).map(target).collect();
        let spread = |found: &DVector<f64>| {
            let mut forces = vec![0.0; count];
            for ((s, unit), found) in sought.iter().zip(&units).zip(found.iter()) {
                forces[s.row] = unit * found;
                if s.drag != 0.0 {
                    forces[s.row + 1] = s.drag * unit * found;
                }
            }
            self.with(forces)
        };
        let fits = |f: &Forces| {
            let most = HOLDS * f.scale.1;
            sought.iter().all(|s| f.rates[s.row].abs() <= most)
        };
        let found = spread(&square.basic(&target));
        if square.is_regular() || !fits(&found) {
            return fits(&found).then_some(found);
        }
        Some(spread(&square.least(&target, &units))).filter(fits)
    }

    /// The rates that forces leave.
    pub(crate) fn with(&self, forces: Vec<f64>) -> Forces {
        let count = self.rates.len();
        let mut rates = self.rates.clone();
        let mut largest = f64::MIN_POSITIVE;
        for (i, rate) in rates.iter_mut().enumerate() {
            let mut terms = self.terms[i];
            for (w, f) in self.operator[i * count..][..count].iter().zip(&forces) {
                *rate += w * f;
                terms += (w * f).abs();
            }
            largest = largest.max(terms);
        }
        let force = forces.iter().fold(self.force, |m, f| m.max(f.abs()));
        Forces {
            forces,
            rates,
            scale: (force, largest),
        }
    }

    /// Whether forces are allowed by the modes: the cheap part of the check, which rejects most modes.
    pub(crate) fn bears(&self, modes: &[Mode], f: &Forces) -> bool {
        let least = -f.scale.0 * self.problem.zero;
        let bearings = modes.iter().zip(&self.problem.bearings);
        (bearings.zip(f.forces.chunks_exact(2))).all(|((mode, bearing), force)| match mode {
            Mode::Open => true,
            Mode::Stick => bearing.friction * force[0] - force[1].abs() >= least,
            Mode::Forward | Mode::Backward => force[0] >= least,
        })
    }

    /// Whether two x differ by more than rounding, in the metric of the masses: relative to themselves, and to the
    /// solution without contacts.
    pub(crate) fn differ(&self, a: &DVector<f64>, b: &DVector<f64>) -> bool {
        /// Multiple of the zero threshold.
        const MORE: f64 = 1e3;
        let long = |x: &DVector<f64>| x.dot(&(self.problem.mass * x)).max(0.0).sqrt();
        let largest = MORE * long(a).max(long(b));
        long(&(a - b)) > self.problem.zero * largest.max(length(&self.sizes))
    }

    /// x for given forces. Values within the rounding of their terms are set to 0, so that a part that rests on a wall
    /// along an axis is at rest.
    fn x(&self, f: &Forces) -> Vec<f64> {
        /// Rounding of the terms, as a share.
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        let n = self.free.len();
        let mut x = self.free.clone();
        let mut sizes = self.sizes.clone();
        for (i, &force) in f.forces.iter().enumerate() {
            if force == 0.0 {
                continue;
            }
            let direction = &self.directions[i * n..][..n];
            for ((x, size), k) in x.iter_mut().zip(&mut sizes).zip(direction) {
                *x += force * k;
                *size += (force * k).abs();
            }
        }
        self.factor.backward(&mut x);
        self.factor.backward_sizes(&mut sizes);
        for (x, size) in x.iter_mut().zip(sizes) {
            if x.abs() <= ROUNDING * size {
                *x = 0.0;
            }
        }
        x
    }

    /// The forces of the joints, the least that do what loads and contacts do not.
    fn joint_forces(&self, x: &DVector<f64>, f: &Forces) -> DVector<f64> {
        if self.joint_rows.is_empty() {
            return DVector::zeros(0);
        }
        let mut rest = self.problem.mass * x - &self.problem.h;
        for (bearing, force) in self.problem.bearings.iter().zip(f.forces.chunks_exact(2)) {
            rest.axpy(-force[0], &bearing.normal, 1.0);
            rest.axpy(-force[1], &bearing.tangent, 1.0);
        }
        self.factor.forward(rest.as_mut_slice());
        let changes: Vec<f64> = (self.joint_rows.iter())
            .map(|row| dot(row, rest.as_slice()))
            .collect();
        DVector::from_vec(self.joints.least(&changes).1)
    }

    /// The solution that belongs to forces.
    pub(crate) fn solution(&self, modes: &[Mode], f: &Forces) -> Solution {
        let x = DVector::from_vec(self.x(f));
        Solution {
            modes: modes.to_vec(),
            normal: f.forces.iter().step_by(2).copied().collect(),
            tangential: f.forces.iter().skip(1).step_by(2).copied().collect(),
            joints: self.joint_forces(&x, f),
            rates: (self.problem.bearings.iter())
                .map(|b| (b.normal.dot(&x) + b.b, b.tangent.dot(&x) + b.c))
                .collect(),
            x,
        }
    }
}

/// Reduces the joints' equations and projects the loads L⁻¹ h, without contacts, on the motions that joints allow;
/// `None` if joints contradict each other.
fn jointed(
    problem: &Problem,
    factor: &Cholesky,
    loads: &[f64],
) -> Option<(Rows, Vec<Vec<f64>>, Vec<f64>)> {
    let mut free = loads.to_vec();
    let count = problem.joints.nrows();
    let mut rows = Rows::default();
    if count == 0 {
        return Some((rows, Vec::new(), free));
    }
    let scaled: Vec<Vec<f64>> = (problem.joints.row_iter())
        .map(|row| {
            let mut row: Vec<f64> = row.iter().copied().collect();
            factor.forward(&mut row);
            row
        })
        .collect();
    for row in &scaled {
        rows.push(row);
    }
    rows.take_out(&mut free);
    if rows.rank() > 0 {
        add_scaled(&mut free, 1.0, &rows.least(problem.j.as_slice()).0);
    }
    let (mut off, mut terms) = (0.0_f64, 0.0_f64);
    for (row, j) in scaled.iter().zip(problem.j.iter()) {
        let sizes = row.iter().zip(loads).zip(&free);
        let sum: f64 = sizes.map(|((k, l), y)| k.abs() * (l.abs() + y.abs())).sum();
        terms = terms.max(sum + j.abs());
        off = off.max((dot(row, &free) - j).abs());
    }
    (off <= HOLDS * terms).then_some((rows, scaled, free))
}

//! Direct solution for accelerations and corrections, with equations that all hold and a diagonal mass matrix.
//!
//! With a diagonal mass matrix M the equations M x = h + Σ λ c, r · x = b, of as many directions c as rows r, are a
//! small system in the forces λ alone. Rows and directions concern two parts each, and parts that are connected by no row are
//! systems by themselves. Where contacts share a load, as the two feet of a box that sticks, forces are the least; where rows
//! contradict each other, the slower methods that can handle this are used.

use nalgebra::{DMatrix, DVector};

use crate::linear::Square;

use super::world::{Equations, Touch};
use crate::complementarity::{Mode, Solution};

/// Equations that depend on others hold to this share of their terms.
const HOLDS: f64 = 1e-9;
/// Rounding of a sum, as a share of the sizes of its terms.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The inverse of a diagonal mass matrix.
#[derive(Debug, Clone)]
pub(super) struct Lightness(Vec<f64>);

/// Vectors by their numbers that are not 0, each with its coordinate, in order.
#[derive(Debug, Default)]
struct Sparse {
    entries: Vec<(usize, f64)>,
    ends: Vec<usize>,
}

impl Sparse {
    fn push(&mut self, vector: impl Iterator<Item = f64>) {
        self.entries
            .extend(vector.enumerate().filter(|e| e.1 != 0.0));
        self.ends.push(self.entries.len());
    }

    fn of(&self, i: usize) -> &[(usize, f64)] {
        let start = i.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.entries[start..self.ends[i]]
    }
}

/// Rows r and directions c, with what each row is to be.
#[derive(Debug, Default)]
struct System {
    rows: Sparse,
    directions: Sparse,
    targets: Vec<f64>,
}

impl System {
    /// Adds a row that is its own direction.
    fn push(&mut self, row: impl Iterator<Item = f64> + Clone, target: f64) {
        self.push_along(row.clone(), row, target);
    }

    fn push_along(
        &mut self,
        row: impl Iterator<Item = f64>,
        direction: impl Iterator<Item = f64>,
        target: f64,
    ) {
        self.rows.push(row);
        self.directions.push(direction);
        self.targets.push(target);
    }

    /// The rows by the systems that they make, of `n` coordinates.
    fn blocks(&self, n: usize) -> Vec<Vec<usize>> {
        // Each coordinate knows one of its block before it, the first knows itself.
        let mut before: Vec<usize> = (0..n).collect();
        let first = |before: &[usize], mut i: usize| {
            while before[i] != i {
                i = before[i];
            }
            i
        };
        for i in 0..self.targets.len() {
            let mut all = self.rows.of(i).iter().chain(self.directions.of(i));
            let Some(&(one, _)) = all.next() else {
                continue;
            };
            for &(other, _) in all {
                let ends = [one, other].map(|k| first(&before, k));
                before[ends[0].max(ends[1])] = ends[0].min(ends[1]);
            }
        }
        let mut blocks: Vec<Vec<usize>> = vec![Vec::new(); n + 1];
        for i in 0..self.targets.len() {
            let one = self.rows.of(i).first();
            blocks[one.map_or(n, |e| first(&before, e.0))].push(i);
        }
        blocks.retain(|block| !block.is_empty());
        blocks
    }
}

/// x, with the sums of the sizes of its terms, and the forces λ.
struct Found {
    x: Vec<f64>,
    sizes: Vec<f64>,
    forces: Vec<f64>,
}

impl Lightness {
    /// `None` if the matrix is not diagonal, with positive numbers.
    pub(super) fn of(mass: &DMatrix<f64>) -> Option<Self> {
        let n = mass.nrows();
        let is_diagonal = (0..n).all(|i| (0..n).all(|k| (i == k) == (mass[(i, k)] != 0.0)));
        let all: Vec<f64> = mass.diagonal().iter().map(|m| 1.0 / m).collect();
        (is_diagonal && all.iter().all(|w| w.is_finite() && *w > 0.0)).then_some(Self(all))
    }

    /// r · c, by the inverse masses.
    fn product(&self, r: &[(usize, f64)], c: &[(usize, f64)]) -> f64 {
        let (mut sum, mut k) = (0.0, 0);
        for &(i, r) in r {
            while k < c.len() && c[k].0 < i {
                k += 1;
            }
            if let Some(&(_, c)) = c.get(k).filter(|c| c.0 == i) {
                sum += r * c * self.0[i];
            }
        }
        sum
    }

    /// λ, and M⁻¹ (h + Σ λ c). `None` if rows contradict each other by more than `slack`, or if they depend on each other and
    /// `shared` says that forces are not to be the least then.
    fn solved(
        &self,
        system: &System,
        h: &[f64],
        (shared, slack): (bool, f64),
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let x: Vec<f64> = h.iter().zip(&self.0).map(|(h, w)| h * w).collect();
        let mut found = Found {
            sizes: x.iter().map(|x| x.abs()).collect(),
            forces: vec![0.0; system.targets.len()],
            x,
        };
        for block in system.blocks(self.0.len()) {
            let is_regular = self.solve(system, &block, &mut found)?;
            if !(is_regular || shared && holds(system, &block, &found, slack)) {
                return None;
            }
        }
        let Found {
            mut x,
            sizes,
            forces,
        } = found;
        for (x, size) in x.iter_mut().zip(sizes) {
            // A part that rests on a wall along an axis is at rest.
            if x.abs() <= ROUNDING * size {
                *x = 0.0;
            }
        }
        (x.iter().all(|x| x.is_finite())).then_some((forces, x))
    }

    /// Solves the equations of a block; whether no row depends on others.
    fn solve(&self, system: &System, block: &[usize], found: &mut Found) -> Option<bool> {
        let row = |i: usize| system.rows.of(block[i]);
        let direction = |k: usize| system.directions.of(block[k]);
        let count = block.len();
        // In units in which each force moves its own row by 1.
        let units: Vec<f64> = (0..count)
            .map(|i| {
                let own = self.product(row(i), row(i));
                if own > 0.0 { own.sqrt().recip() } else { 1.0 }
            })
            .collect();
        let square = Square::of(DMatrix::from_fn(count, count, |i, k| {
            self.product(row(i), direction(k)) * units[i] * units[k]
        }))?;
        // A second round takes out what rounding has left.
        for _ in 0..2 {
            let missing: Vec<f64> = (0..count)
                .map(|i| {
                    let is: f64 = row(i).iter().map(|&(j, r)| r * found.x[j]).sum();
                    (system.targets[block[i]] - is) * units[i]
                })
                .collect();
            for (k, more) in square.least(&missing, &units).iter().enumerate() {
                let more = more * units[k];
                found.forces[block[k]] += more;
                for &(j, c) in direction(k) {
                    found.x[j] += self.0[j] * c * more;
                }
            }
        }
        for (k, &i) in block.iter().enumerate() {
            for &(j, c) in direction(k) {
                found.sizes[j] += (self.0[j] * c * found.forces[i]).abs();
            }
        }
        Some(square.is_regular())
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
        for (&(contact, mode), (touch, [b, _])) in bearings.iter().zip(&equations.contacts) {
            let drag = -mode.direction() * friction(contact);
            let both = touch.normal.iter().zip(&touch.tangent);
            let direction = both.map(|(n, t)| if drag == 0.0 { *n } else { n + drag * t });
            system.push_along(touch.normal.iter().copied(), direction, -b);
        }
        for ((_, mode), (touch, [_, c])) in bearings.iter().zip(&equations.contacts) {
            if *mode == Mode::Stick {
                system.push(touch.tangent.iter().copied(), -c);
            }
        }
        let joints = equations.joint_bends.len();
        // Of joints and contacts that share a load, contacts are to bear the least.
        let (forces, x) = self.solved(&system, equations.force.as_slice(), (joints == 0, 0.0))?;
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
    /// of gaps, then, if there are that many, of what sticks across. `None` if
    /// what they are to change by contradicts itself by more than `slack`.
    pub(super) fn least(
        &self,
        joints: &DMatrix<f64>,
        touches: &[Touch],
        stuck: &[&Touch],
        by: &DVector<f64>,
        slack: f64,
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
        Some(DVector::from_vec(
            self.solved(&system, &still, (true, slack))?.1,
        ))
    }
}

/// Whether all rows of a block are what they are to be, to rounding or a slack.
fn holds(system: &System, block: &[usize], found: &Found, slack: f64) -> bool {
    let (mut off, mut terms) = (0.0_f64, 0.0_f64);
    for &i in block {
        let target = system.targets[i];
        let row = system.rows.of(i).iter();
        let (is, size) = row.fold((0.0, target.abs()), |(is, size), &(j, r)| {
            (is + r * found.x[j], size + r.abs() * found.sizes[j])
        });
        off = off.max((target - is).abs());
        terms = terms.max(size);
    }
    off <= slack.max(HOLDS * terms)
}

//! Contacts with friction as linear complementarity.
//!
//! If the direction of a contact's sliding is unknown, the friction is λ_T = β⁺ − β⁻ and σ the speed of sliding:
//!
//! ```text
//! 0 ≤ λ_N ⟂ a_N ≥ 0,   0 ≤ β⁺ ⟂ σ + a_T ≥ 0,   0 ≤ β⁻ ⟂ σ − a_T ≥ 0,   0 ≤ σ ⟂ f λ_N − β⁺ − β⁻ ≥ 0
//! ```
//!
//! For a contact that slides, or has no friction, only λ_N is unknown; it pushes along n − s f τ. If no contact slides
//! yet, the matrix is copositive, and Lemke's method finds a solution wherever contacts that support each other do not
//! contradict each other.
//!
//! Sources: Stewart and Trinkle, International Journal for Numerical Methods in Engineering 39 (1996); Pang and Trinkle, Mathematical
//! Programming 73 (1996).

use nalgebra::{DMatrix, DVector};

use super::lemke::{Complementary, Outcome, lemke_from};
use super::problem::{Bearing, Mode, Problem, Solution};
use super::reduced::Reduced;

/// Covering vectors that are tried, as a ray from one of them proves nothing and others may lead to other solutions.
const COVERS: usize = 4;

/// Kind of an unknown of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// λ_N, with λ_T / λ_N.
    Normal(f64),
    /// β⁺ or β⁻, by its sign.
    Tangential(f64),
    /// σ.
    Speed,
}

/// Contacts with friction as a complementarity problem.
#[derive(Debug)]
struct Complementarity<'a> {
    bearings: &'a [Bearing],
    unknowns: Vec<(usize, Kind)>,
    /// The unit of force of each contact: it moves the contact by about 1.
    units: Vec<f64>,
    m: DMatrix<f64>,
    q: DVector<f64>,
}

impl<'a> Complementarity<'a> {
    fn of(bearings: &'a [Bearing], reduced: &Reduced) -> Self {
        let count = 2 * bearings.len();
        let w = |row: usize, column: usize| reduced.operator[row * count + column];
        let mut unknowns = Vec::with_capacity(2 * count);
        let mut units = Vec::with_capacity(bearings.len());
        for (i, bearing) in bearings.iter().enumerate() {
            let own = w(2 * i, 2 * i).max(w(2 * i + 1, 2 * i + 1));
            units.push(if own > 0.0 { own.sqrt().recip() } else { 1.0 });
            match bearing.slides {
                Some(s) => unknowns.push((i, Kind::Normal(-s * bearing.friction))),
                None if bearing.friction == 0.0 => unknowns.push((i, Kind::Normal(0.0))),
                None => unknowns.extend([
                    (i, Kind::Normal(0.0)),
                    (i, Kind::Tangential(1.0)),
                    (i, Kind::Tangential(-1.0)),
                    (i, Kind::Speed),
                ]),
            }
        }
        // The rate of a row by a force of an unknown.
        let effect = |row: usize, k: usize, kind: Kind| match kind {
            Kind::Normal(drag) if drag != 0.0 => w(row, 2 * k) + drag * w(row, 2 * k + 1),
            Kind::Normal(_) => w(row, 2 * k),
            Kind::Tangential(sign) => sign * w(row, 2 * k + 1),
            Kind::Speed => 0.0,
        };
        let entry = |r: usize, c: usize| {
            let ((i, row), (k, column)) = (unknowns[r], unknowns[c]);
            match (row, column) {
                (Kind::Normal(_) | Kind::Tangential(_), Kind::Speed) => {
                    f64::from(u8::from(i == k && row != Kind::Normal(0.0)))
                }
                (Kind::Normal(_), _) => units[i] * units[k] * effect(2 * i, k, column),
                (Kind::Tangential(sign), _) => {
                    sign * units[i] * units[k] * effect(2 * i + 1, k, column)
                }
                (Kind::Speed, Kind::Normal(_)) if i == k => bearings[i].friction,
                (Kind::Speed, Kind::Tangential(_)) if i == k => -1.0,
                (Kind::Speed, _) => 0.0,
            }
        };
        let constant = |r: usize| match unknowns[r] {
            (i, Kind::Normal(_)) => units[i] * reduced.rates[2 * i],
            (i, Kind::Tangential(sign)) => sign * units[i] * reduced.rates[2 * i + 1],
            (_, Kind::Speed) => 0.0,
        };
        let n = unknowns.len();
        let m = DMatrix::from_fn(n, n, entry);
        let q = DVector::from_fn(n, |r, _| constant(r));
        Self {
            bearings,
            unknowns,
            units,
            m,
            q,
        }
    }

    /// Positive numbers, the first time ones, later spread evenly.
    fn cover(&self, time: usize) -> DVector<f64> {
        /// The golden ratio: its multiples fall evenly.
        const SPREAD: f64 = 0.618_033_988_749_894_9;
        DVector::from_fn(self.q.len(), |i, _| {
            if time == 0 {
                1.0
            } else {
                0.25 + ((i + 1) as f64 * (time as f64 + 1.0) * SPREAD).fract()
            }
        })
    }

    /// The modes of a basis, and the forces of each contact.
    fn read(&self, found: &Complementary) -> (Vec<Mode>, Vec<f64>) {
        let mut forces = vec![0.0; 2 * self.bearings.len()];
        let mut modes = vec![Mode::Open; self.bearings.len()];
        // For each contact, whether λ_N, β⁺, β⁻ and σ are in the basis.
        let mut inside = vec![[false; 4]; self.bearings.len()];
        for (k, &(i, kind)) in self.unknowns.iter().enumerate() {
            let force = found.z[k] * self.units[i];
            match kind {
                Kind::Normal(drag) => {
                    forces[2 * i] += force;
                    forces[2 * i + 1] += drag * force;
                    inside[i][0] = found.basic[k];
                }
                Kind::Tangential(sign) => {
                    forces[2 * i + 1] += sign * force;
                    inside[i][if sign > 0.0 { 1 } else { 2 }] = found.basic[k];
                }
                Kind::Speed => inside[i][3] = found.basic[k],
            }
        }
        for ((mode, bearing), inside) in modes.iter_mut().zip(self.bearings).zip(inside) {
            *mode = match (bearing.slides, inside) {
                (_, [false, ..]) => Mode::Open,
                (Some(s), _) if s < 0.0 => Mode::Backward,
                (Some(_), _) => Mode::Forward,
                (None, _) if bearing.friction == 0.0 => Mode::Forward,
                // σ = |a_T|, against all the friction there is.
                (None, [_, false, true, true]) => Mode::Forward,
                (None, [_, true, false, true]) => Mode::Backward,
                // f λ_N = 0.
                (None, [_, false, false, true]) => Mode::Open,
                (None, _) => Mode::Stick,
            };
        }
        (modes, forces)
    }
}

/// Solutions that Lemke's method finds, from several covering vectors; several may be the same.
pub(crate) fn solutions(problem: &Problem, reduced: &Reduced) -> Vec<Solution> {
    let complementarity = Complementarity::of(&problem.bearings, reduced);
    let mut found = Vec::new();
    // Without friction the first is all: x is that of a convex problem.
    let has_friction = problem.bearings.iter().any(|b| b.friction != 0.0);
    for time in 0..COVERS {
        if !has_friction && !found.is_empty() {
            break;
        }
        let cover = complementarity.cover(time);
        let Outcome::Solution(z) = lemke_from(&complementarity.m, &complementarity.q, &cover)
        else {
            continue;
        };
        let (modes, forces) = complementarity.read(&z);
        // The forces that belong to the modes, if they do: those that share a load share it evenly.
        let even = reduced.forces(&modes);
        let own = reduced.with(forces);
        let solution = even.and_then(|f| {
            let solution = reduced.solution(&modes, &f);
            problem.holds(&solution, f.scale.1).then_some(solution)
        });
        found.extend(solution.or_else(|| {
            let (solution, terms) = (reduced.solution(&modes, &own), own.scale.1);
            let fits = problem.holds(&solution, terms) && problem.agrees(&solution, terms);
            fits.then_some(solution)
        }));
    }
    found
}

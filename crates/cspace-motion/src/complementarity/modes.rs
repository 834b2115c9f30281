//! Modes of contacts (bearing, sticking or sliding): one problem for accelerations and for impacts.
//!
//! Unknowns are x (accelerations, or velocities after an impact), forces λ_N, λ_T of the contacts and μ of the joints
//! with
//!
//! ```text
//! M x = h + Jᵀ μ + Σ λ_N n + Σ λ_T τ,   J x = j
//! λ_N ≥ 0,   a_N = n · x + b ≥ 0,   λ_N a_N = 0
//! |λ_T| ≤ f λ_N;   λ_T = −f λ_N s where it slides, or begins to slide, in direction s = ±1, and 0 = a_T = τ · x + c where it sticks
//! ```
//!
//! Each contact is in one of four modes, and in each combination of modes the equations are linear. All combinations
//! are tried; those whose inequalities hold are solutions: there may be none, one or several. If contacts support each
//! other redundantly, their forces are the smallest that do so (least squares). With too many combinations Lemke's
//! method finds a solution (`friction.rs`).

use super::friction;
use super::problem::{Bearing, Mode, Problem, Solution};
use super::reduced::Reduced;

/// Largest number of combinations of modes that are tried.
pub(crate) const MOST: usize = 1024;
/// Largest number of them where no contact rubs: one solution is all then, which Lemke's method finds sooner.
const MOST_SMOOTH: usize = 32;

impl Problem<'_> {
    /// Solutions that differ in x: all of them if there are at most [`MOST`] combinations of modes, else those that Lemke's method
    /// finds. These are all if there is no friction, or little; with much there may be others, and there may be one where none is found.
    pub(crate) fn solutions(&self) -> Vec<Solution> {
        let Some(reduced) = Reduced::of(self) else {
            return Vec::new();
        };
        let count = (self.bearings.iter())
            .try_fold(1_usize, |all, b| all.checked_mul(b.choices().len()))
            .filter(|&count| count <= MOST);
        let rubs = self.bearings.iter().any(|b| b.friction != 0.0);
        let is_few = |count: usize| rubs || count <= MOST_SMOOTH;
        if count.is_some_and(is_few) {
            return self.enumerated(&reduced);
        }
        let found = self.pivoted(&reduced);
        if found.is_empty() && count.is_some() {
            return self.enumerated(&reduced);
        }
        found
    }

    /// Indices of the contacts that contradict by themselves: with one of them alone there is no solution, as where a rod is pushed over a
    /// rough floor (Painlevé). Where each alone has one, that all together have none may be due to rounding, or to what Lemke's method did
    /// not find.
    pub(crate) fn contradictions(&self) -> Vec<usize> {
        let contradicts = |k: &usize| {
            let alone = Self {
                bearings: vec![self.bearings[*k].clone()],
                ..self.clone()
            };
            alone.solutions().is_empty()
        };
        (0..self.bearings.len()).filter(contradicts).collect()
    }

    /// Solutions for all combinations of modes.
    fn enumerated(&self, reduced: &Reduced) -> Vec<Solution> {
        let mut found: Vec<Solution> = Vec::new();
        let choices: Vec<&[Mode]> = self.bearings.iter().map(Bearing::choices).collect();
        let mut modes: Vec<Mode> = choices.iter().map(|c| c[0]).collect();
        let mut odometer = vec![0; choices.len()];
        loop {
            if let Some(forces) = reduced.forces(&modes)
                && reduced.bears(&modes, &forces)
            {
                let solution = reduced.solution(&modes, &forces);
                if self.holds(&solution, forces.scale.1) {
                    add(&mut found, solution, reduced);
                }
            }
            let Some(i) = (0..odometer.len()).find(|&i| odometer[i] + 1 < choices[i].len()) else {
                return found;
            };
            odometer[..i].fill(0);
            odometer[i] += 1;
            for k in 0..=i {
                modes[k] = choices[k][odometer[k]];
            }
        }
    }

    /// Solutions found by Lemke's method.
    fn pivoted(&self, reduced: &Reduced) -> Vec<Solution> {
        let mut found: Vec<Solution> = Vec::new();
        for solution in friction::solutions(self, reduced) {
            add(&mut found, solution, reduced);
        }
        found
    }

    /// The solution of the linear equations of some modes, whether its inequalities hold or not; `None` if they have none.
    pub(crate) fn within(&self, modes: &[Mode]) -> Option<Solution> {
        let reduced = Reduced::of(self)?;
        let forces = reduced.forces(modes)?;
        Some(reduced.solution(modes, &forces))
    }
}

/// Adds a solution if x is another than that of those found.
fn add(found: &mut Vec<Solution>, solution: Solution, reduced: &Reduced) {
    let differs = |other: &Solution| reduced.differ(&other.x, &solution.x);
    if found.iter().all(differs) {
        found.push(solution);
    }
}

#[cfg(test)]
mod tests;

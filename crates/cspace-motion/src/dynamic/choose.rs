//! Motions that all agree with the laws of contact and friction, and the one that is taken.
//!
//! The laws may allow several motions: a drawer that is pushed aside may wedge or go. The rule takes the one with
//!
//! 1. the least energy of the change, ½ (x − a)ᵀ M (x − a), where x are the accelerations, or in an impact the rates after it, and a those
//!    without contacts: Gauss's principle of least constraint,
//! 2. the least forces, the sum of all |λ_N| and |λ_T|,
//! 3. the first, in the order of the contacts' modes.

use core::cmp::Ordering;

use super::motion::Choice;
use crate::complementarity::{Problem, Solution};

/// Energies, and forces, are equal within this share.
const EQUAL: f64 = 1e-9;

impl Problem<'_> {
    /// The solution that is taken of several, and what else there is.
    pub(super) fn chosen(
        &self,
        solutions: Vec<Solution>,
        contacts: &[usize],
    ) -> Option<(Solution, Choice)> {
        let free = self.mass.clone().cholesky()?.solve(&self.h);
        let energy = |s: &Solution| {
            let change = &s.x - &free;
            0.5 * change.dot(&(self.mass * &change))
        };
        let force = |s: &Solution| -> f64 {
            let all = s.normal.iter().chain(&s.tangential);
            all.map(|f| f.abs()).sum()
        };
        let keys: Vec<[f64; 2]> = solutions.iter().map(|s| [energy(s), force(s)]).collect();
        let compare = |a: f64, b: f64| match (a - b).abs() <= EQUAL * a.max(b) {
            true => Ordering::Equal,
            false => a.total_cmp(&b),
        };
        let is_less = |a: [f64; 2], b: [f64; 2]| {
            let order = compare(a[0], b[0]).then(compare(a[1], b[1]));
            order == Ordering::Less
        };
        let first = (1..keys.len()).fold(0, |best, k| match is_less(keys[k], keys[best]) {
            true => k,
            false => best,
        });
        let mut others: Vec<_> = solutions.iter().map(|s| s.modes.clone()).collect();
        let choice = Choice {
            contacts: contacts.to_vec(),
            taken: others.remove(first),
            others,
        };
        Some((solutions.into_iter().nth(first)?, choice))
    }
}

//! Impulses of contacts with friction by projected Gauss–Seidel: contact after contact, each solved exactly with the
//! others held constant, until nothing changes.
//!
//! With u = W λ + w, for each contact with its normal and tangential parts n and t:
//!
//! ```text
//! 0 ≤ λ_n ⟂ u_n ≥ 0,   |λ_t| ≤ μ λ_n,   λ_t = −μ λ_n sign u_t where u_t ≠ 0
//! ```
//!
//! Contacts that share a load make W singular; the sweeps converge to one of the possible distributions. Where they
//! converge slowly, as with contacts that almost share a direction, they are extrapolated at intervals along the last
//! change, as far as a geometric series goes and no contact opens, closes or begins to slide.

use nalgebra::{DMatrix, DVector};

/// Sweeps are over when no rate at a contact changes by more than this share of the largest.
const CONVERGED: f64 = 1e-12;
/// There are no more sweeps than that.
const MOST_SWEEPS: usize = 50_000;
/// Sweeps between two extensions.
const EXTENDED: usize = 20;
/// Relative tolerance within which a friction impulse counts as being at its bound.
const AT_BOUND: f64 = 1e-9;
/// Largest change of rates in the last allowed sweep, as a share, with which the result counts as converged.
const GOOD: f64 = 1e-6;
/// A contact is rigid if its impulse changes its own rate by less than this share of the change without joints.
const RIGID: f64 = 1e-12;

/// Contacts in pairs of rows: normal, tangential.
pub(super) struct Impulses<'a> {
    /// Change of rates per impulse.
    pub(super) w: &'a DMatrix<f64>,
    /// Rates without impulses; for openings including restitution.
    pub(super) free: &'a DVector<f64>,
    /// The coefficients of friction.
    pub(super) friction: &'a [f64],
    /// Change of each row's rate by its own impulse without joints.
    pub(super) alone: &'a DVector<f64>,
}

impl Impulses<'_> {
    /// Impulses, from a guess. `None` if the sweeps come to nothing.
    pub(super) fn solved(&self, guess: DVector<f64>) -> Option<DVector<f64>> {
        let mut impulses = guess;
        let scale = self.free.amax();
        let mut changed = 0.0;
        let mut last = DVector::zeros(impulses.len());
        for sweep in 1..=MOST_SWEEPS {
            let before = impulses.clone();
            changed = self.sweep(&mut impulses);
            if changed <= CONVERGED * scale {
                return Some(impulses);
            }
            let change = &impulses - &before;
            if sweep.is_multiple_of(EXTENDED) {
                self.extend(&mut impulses, &change, &last);
            }
            last = change;
        }
        (changed <= GOOD * scale).then_some(impulses)
    }

    /// Extrapolates a change up to its limit, or to where a contact changes its state.
    fn extend(&self, impulses: &mut DVector<f64>, change: &DVector<f64>, last: &DVector<f64>) {
        let ratio = change.dot(last) / last.norm_squared();
        // Without an end, if changes do not become smaller.
        let mut far = if ratio < 1.0 {
            (ratio / (1.0 - ratio)).max(0.0)
        } else {
            f64::INFINITY
        };
        for (k, &friction) in self.friction.iter().enumerate() {
            let (n, t) = (impulses[2 * k], impulses[2 * k + 1]);
            let (dn, dt) = (change[2 * k], change[2 * k + 1]);
            if dn < 0.0 {
                far = far.min(-n / dn);
            }
            for side in [1.0, -1.0] {
                let (room, falls) = (friction * n - side * t, friction * dn - side * dt);
                if room > AT_BOUND * friction * n && falls < 0.0 {
                    far = far.min(-room / falls);
                }
            }
        }
        if far.is_finite() {
            *impulses += change * far;
        }
    }

    /// Makes one sweep; returns the change of rates.
    fn sweep(&self, impulses: &mut DVector<f64>) -> f64 {
        let mut changed: f64 = 0.0;
        for (k, &friction) in self.friction.iter().enumerate() {
            let (i, j) = (2 * k, 2 * k + 1);
            let rate = |row: usize| {
                self.free[row] + self.w.row(row).transpose().dot(impulses)
                    - self.w[(row, i)] * impulses[i]
                    - self.w[(row, j)] * impulses[j]
            };
            let block = Block {
                normal: self.w[(i, i)],
                tangential: self.w[(j, j)],
                both: self.w[(i, j)],
                rates: [rate(i), rate(j)],
                friction,
                is_stiff: [i, j].map(|row| self.w[(row, row)] <= RIGID * self.alone[row]),
            };
            let [n, t] = block.solved();
            let change = |row: usize| {
                self.w[(row, i)] * (n - impulses[i]) + self.w[(row, j)] * (t - impulses[j])
            };
            // A rigid contact never satisfies its law; its rate is the remaining violation.
            let left = if block.is_stiff[0] {
                -block.rates[0].min(0.0)
            } else {
                0.0
            };
            changed = changed.max(change(i).abs()).max(change(j).abs()).max(left);
            (impulses[i], impulses[j]) = (n, t);
        }
        changed
    }
}

/// One contact, with the rates that the others leave it.
struct Block {
    normal: f64,
    tangential: f64,
    both: f64,
    rates: [f64; 2],
    friction: f64,
    is_stiff: [bool; 2],
}

impl Block {
    /// Impulses that solve the contact.
    fn solved(&self) -> [f64; 2] {
        let [opening, sliding] = self.rates;
        if opening >= 0.0 || self.is_stiff[0] {
            return [0.0; 2];
        }
        if self.friction == 0.0 || self.is_stiff[1] {
            return [-opening / self.normal, 0.0];
        }
        let (a, b, c) = (self.normal, self.tangential, self.both);
        let det = a * b - c * c;
        if det > RIGID * a * b {
            let (n, t) = (
                (c * sliding - b * opening) / det,
                (c * opening - a * sliding) / det,
            );
            if n >= 0.0 && t.abs() <= self.friction * n {
                return [n, t];
            }
        }
        let first = if sliding < 0.0 { -1.0 } else { 1.0 };
        for direction in [first, -first] {
            // It slides in a direction, and friction is against it.
            let slope = a - direction * self.friction * c;
            if slope > RIGID * a {
                let n = -opening / slope;
                let t = -direction * self.friction * n;
                if direction * (sliding + c * n + b * t) >= 0.0 {
                    return [n, t];
                }
            }
        }
        [-opening / a, 0.0]
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::complementarity::numbers::Numbers;

    /// Contacts of random directions in few coordinates, some of them twice: what comes out satisfies the laws.
    #[test]
    fn random_and_redundant_contacts_satisfy_their_laws() {
        let mut numbers = Numbers::of(5);
        let mut slid = 0;
        let mut stuck = 0;
        for case in 0..200 {
            let (coordinates, contacts) = (3, 1 + case % 5);
            let mut rows = numbers.matrix(2 * contacts, coordinates);
            // Normals that push to one side, so that friction of small coefficients has solutions.
            for k in 0..contacts {
                rows[(2 * k, 0)] = 1.0 + rows[(2 * k, 0)].abs();
            }
            if contacts > 2 {
                let (first, second) = (rows.row(0).clone_owned(), rows.row(1).clone_owned());
                rows.set_row(2, &first);
                rows.set_row(3, &second);
            }
            let w = &rows * rows.transpose();
            let mut v = numbers.vector(coordinates);
            v[0] = -1.0;
            let free = &rows * v;
            let friction = vec![0.2 * numbers.share(); contacts];
            let alone = w.diagonal();
            let problem = Impulses {
                w: &w,
                free: &free,
                friction: &friction,
                alone: &alone,
            };
            let found = problem.solved(DVector::zeros(2 * contacts)).unwrap();
            let rates = &w * &found + &free;
            for k in 0..contacts {
                let (n, t) = (found[2 * k], found[2 * k + 1]);
                let (opens, slides) = (rates[2 * k], rates[2 * k + 1]);
                assert!(n >= 0.0 && opens >= -1e-9, "{case}: {n} {opens}");
                assert!((n * opens).abs() < 1e-9);
                assert!(t.abs() <= friction[k] * n + 1e-12);
                if slides.abs() > 1e-9 && n > 0.0 {
                    assert!((t + friction[k] * n * slides.signum()).abs() < 1e-9);
                    slid += 1;
                } else if n > 0.0 {
                    stuck += 1;
                }
            }
        }
        assert!(slid > 50 && stuck > 10, "{slid} {stuck}");
    }

    /// A part that is held where it is cannot be pushed away.
    #[test]
    fn what_cannot_give_way_is_told() {
        let w = DMatrix::zeros(2, 2);
        let free = DVector::from_vec(vec![-1.0, 0.0]);
        let alone = DVector::from_element(2, 1.0);
        let problem = Impulses {
            w: &w,
            free: &free,
            friction: &[0.0],
            alone: &alone,
        };
        assert_eq!(problem.solved(DVector::zeros(2)), None);
    }
}

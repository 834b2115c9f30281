//! Linear complementarity: w = M z + q with w, z ≥ 0 and w · z = 0.
//!
//! Lemke's method: with enough of a covering vector d, z = 0 and w = q + d z₀ ≥ 0. Unknowns are exchanged, always
//! entering the complement of the one that left, until z₀ leaves; then there is a solution. If nothing limits the
//! growth of the entering unknown, there is a ray, and for many classes of M this proves that there is no solution: for
//! positive semidefinite and copositive M under conditions on q, not in general. Ties are broken lexicographically, so
//! that no basis returns.
//!
//! Source: Cottle, Pang and Stone, The Linear Complementarity Problem (1992), sections 4.4 and 4.9.

use nalgebra::{DMatrix, DVector};

use crate::linear::Square;

/// An entry of a column below this share of its largest ends nothing: rounding of some 10⁻¹⁵ that exchanges have made larger. Two
/// contacts at a distance of 10⁻⁵ of their lever still differ by 10⁻¹⁰.
const PIVOT: f64 = 1e-11;
/// Ratios nearer to each other than this share are the same: q is scaled to 1, and exchanges carry rounding along.
const TIE: f64 = 1e-12;
/// An answer may be negative by this share of its terms.
const NEGATIVE: f64 = 1e-9;
/// Exchanges are as many as a few times the unknowns in practice; more than this many times mean that rounding leads in circles.
const TIMES: usize = 20;

/// z of a solution, exactly 0 outside of the basis.
#[derive(Debug, Clone)]
pub(crate) struct Complementary {
    pub(crate) z: DVector<f64>,
    /// Whether z, rather than w, is in the basis.
    pub(crate) basic: Vec<bool>,
}

/// Result of Lemke's method.
#[derive(Debug, Clone)]
pub(crate) enum Outcome {
    /// A solution, to rounding.
    Solution(Complementary),
    /// No solution is found: nothing limits the growth of an unknown, or numbers are not finite.
    Ray,
    /// Too many exchanges, or rounding that spoils the answer.
    TooLong,
}

/// The problem with a covering vector of ones.
#[cfg(test)]
pub(crate) fn lemke(m: &DMatrix<f64>, q: &DVector<f64>) -> Outcome {
    lemke_from(m, q, &DVector::from_element(q.len(), 1.0))
}

/// The problem with a covering vector of positive numbers. Where there are several solutions it decides which is found.
pub(crate) fn lemke_from(m: &DMatrix<f64>, q: &DVector<f64>, cover: &DVector<f64>) -> Outcome {
    let n = q.len();
    let largest = q.amax();
    let all = m.iter().chain(q.iter()).chain(cover.iter());
    if m.nrows() != n || m.ncols() != n || all.into_iter().any(|x| !x.is_finite()) {
        return Outcome::Ray;
    }
    if q.iter().all(|&x| x >= 0.0) {
        return answer(m, q, vec![false; n]);
    }
    let mut table = Table::new(m, q, cover, largest.recip());
    // z₀ enters for the row that needs it most.
    let mut column = n;
    let Some(mut row) = table.first(cover) else {
        return Outcome::Ray;
    };
    for _ in 0..TIMES * (n + 1) {
        let left = table.exchange(row, column);
        if left == table.cover() {
            let mut basic = vec![false; n];
            for &unknown in &table.basis {
                if unknown >= n {
                    basic[unknown - n] = true;
                }
            }
            return answer(m, q, basic);
        }
        let partner = if left < n { left + n } else { left - n };
        let Some(enters) = table.outside.iter().position(|&u| u == partner) else {
            return Outcome::TooLong;
        };
        column = enters;
        let Some(leaves) = table.leaves(column) else {
            return Outcome::Ray;
        };
        row = leaves;
    }
    Outcome::TooLong
}

/// The basis solved anew, from the numbers of the problem.
fn answer(m: &DMatrix<f64>, q: &DVector<f64>, basic: Vec<bool>) -> Outcome {
    let n = q.len();
    let inside: Vec<usize> = (0..n).filter(|&i| basic[i]).collect();
    let among = DMatrix::from_fn(inside.len(), inside.len(), |i, j| m[(inside[i], inside[j])]);
    let Some(square) = Square::of(among) else {
        return Outcome::TooLong;
    };
    let mut z = DVector::zeros(n);
    let mut w = q.clone();
    // The second time what rounding has left.
    for _ in 0..2 {
        let right: Vec<f64> = inside.iter().map(|&i| -w[i]).collect();
        for (&i, more) in inside.iter().zip(&square.basic(&right)) {
            z[i] += more;
        }
        w = m * &z + q;
    }
    let terms: Vec<f64> = (0..n)
        .map(|i| {
            q[i].abs()
                + m.row(i)
                    .iter()
                    .zip(&z)
                    .map(|(m, z)| (m * z).abs())
                    .sum::<f64>()
        })
        .collect();
    let largest = terms.iter().fold(0.0_f64, |a, b| a.max(*b));
    let long = z.amax();
    for i in 0..n {
        let (z, w) = (&mut z[i], w[i]);
        let wrong = if basic[i] {
            *z < -NEGATIVE * long || w.abs() > NEGATIVE * largest
        } else {
            w < -NEGATIVE * largest
        };
        if wrong || !z.is_finite() {
            return Outcome::TooLong;
        }
        if basic[i] {
            *z = z.max(0.0);
        }
    }
    Outcome::Solution(Complementary { z, basic })
}

/// Tableau. Unknowns are numbered: w from 0, z from n, z₀ is 2 n. Basic unknowns as functions of the others: basis +
/// table · outside = right.
struct Table {
    n: usize,
    /// Entries by rows of n + 2 numbers: n + 1 columns of the nonbasic unknowns, and the right side.
    entries: Vec<f64>,
    basis: Vec<usize>,
    outside: Vec<usize>,
    spare: Vec<f64>,
}

impl Table {
    fn new(m: &DMatrix<f64>, q: &DVector<f64>, cover: &DVector<f64>, scale: f64) -> Self {
        let n = q.len();
        let mut entries = Vec::with_capacity(n * (n + 2));
        for i in 0..n {
            entries.extend(m.row(i).iter().map(|x| -x));
            entries.push(-cover[i]);
            entries.push(q[i] * scale);
        }
        Self {
            n,
            entries,
            basis: (0..n).collect(),
            outside: (n..=2 * n).collect(),
            spare: Vec::new(),
        }
    }

    fn cover(&self) -> usize {
        2 * self.n
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * (self.n + 2) + column]
    }

    fn right(&self, row: usize) -> f64 {
        self.at(row, self.n + 1)
    }

    /// The row that makes all others feasible if z₀ enters there. Of equal ones the last: it is lexicographically first, because w is the
    /// basis.
    fn first(&self, cover: &DVector<f64>) -> Option<usize> {
        let need = |i: usize| self.right(i) / cover[i];
        (0..self.n)
            .filter(|&i| cover[i] > 0.0)
            .min_by(|&i, &j| need(i).total_cmp(&need(j)).then(j.cmp(&i)))
    }

    /// The row that ends the growth of a column, if one does: z₀ where it may be, else the lexicographically first.
    fn leaves(&self, column: usize) -> Option<usize> {
        let largest = (0..self.n).fold(0.0_f64, |m, i| m.max(self.at(i, column).abs()));
        let mut rows: Vec<usize> = (0..self.n)
            .filter(|&i| self.at(i, column) > PIVOT * largest)
            .collect();
        let ratio = |i: usize| self.right(i).max(0.0) / self.at(i, column);
        self.least(&mut rows, ratio, |i| {
            self.right(i).max(1.0) / self.at(i, column)
        });
        if let Some(&cover) = rows.iter().find(|&&i| self.basis[i] == self.cover()) {
            return Some(cover);
        }
        // By the columns of w in the inverse of the basis, one after the other.
        for unknown in 0..self.n {
            if rows.len() <= 1 {
                break;
            }
            if let Some(k) = self.outside.iter().position(|&u| u == unknown) {
                let ratio = |i: usize| self.at(i, k) / self.at(i, column);
                let scale = |i: usize| self.at(i, k).abs().max(1.0) / self.at(i, column);
                self.least(&mut rows, ratio, scale);
            } else {
                // It is in the basis: its column is 1 in its own row, and that is not the least.
                rows.retain(|&i| self.basis[i] != unknown);
            }
        }
        rows.first().copied()
    }

    /// Keeps the rows of least ratio.
    fn least(
        &self,
        rows: &mut Vec<usize>,
        ratio: impl Fn(usize) -> f64,
        scale: impl Fn(usize) -> f64,
    ) {
        let Some(best) = (rows.iter().copied()).min_by(|&i, &j| ratio(i).total_cmp(&ratio(j)))
        else {
            return;
        };
        let least = ratio(best);
        rows.retain(|&i| i == best || ratio(i) - least <= TIE * scale(i).min(scale(best)));
    }

    /// The unknown of a column enters the basis for that of a row, which is returned.
    fn exchange(&mut self, row: usize, column: usize) -> usize {
        let width = self.n + 2;
        let start = row * width;
        let share = self.entries[start + column].recip();
        self.entries[start + column] = 1.0;
        for x in &mut self.entries[start..start + width] {
            *x *= share;
        }
        self.spare.clear();
        self.spare
            .extend_from_slice(&self.entries[start..start + width]);
        for (i, other) in self.entries.chunks_exact_mut(width).enumerate() {
            let by = other[column];
            if i == row || by == 0.0 {
                continue;
            }
            other[column] = 0.0;
            for (x, y) in other.iter_mut().zip(&self.spare) {
                *x -= by * y;
            }
        }
        core::mem::swap(&mut self.basis[row], &mut self.outside[column]);
        self.outside[column]
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::{Complementary, Outcome, lemke, lemke_from};
    use crate::complementarity::numbers::Numbers;

    /// All z of bases that satisfy the inequalities.
    fn all(m: &DMatrix<f64>, q: &DVector<f64>) -> Vec<DVector<f64>> {
        let n = q.len();
        let mut found: Vec<DVector<f64>> = Vec::new();
        for basis in 0..1_usize << n {
            let inside: Vec<usize> = (0..n).filter(|i| basis >> i & 1 == 1).collect();
            let k = inside.len();
            let part = DMatrix::from_fn(k, k, |i, j| m[(inside[i], inside[j])]);
            let right = DVector::from_fn(k, |i, _| -q[inside[i]]);
            let lu = part.full_piv_lu();
            if k > 0 && lu.u().diagonal().amin() < 1e-10 {
                continue;
            }
            let mut z = DVector::zeros(n);
            if k > 0 {
                let solved = lu.solve(&right).unwrap();
                for (i, x) in inside.iter().zip(solved.iter()) {
                    z[*i] = *x;
                }
            }
            let w = m * &z + q;
            let new = found.iter().all(|other| (other - &z).amax() > 1e-9);
            let least = -1e-12 * (1.0 + z.amax());
            if z.min() > least && w.min() > least && new {
                found.push(z);
            }
        }
        found
    }

    fn check(m: &DMatrix<f64>, q: &DVector<f64>, found: &Complementary) {
        let w = m * &found.z + q;
        let rounding = 1e-12 * (q.amax() + m.amax() * found.z.amax() * q.len() as f64);
        for (i, (z, w)) in found.z.iter().zip(&w).enumerate() {
            assert!(*z >= 0.0 && *w >= -rounding, "{z} {w} {m} {q}");
            assert!(*z == 0.0 || w.abs() <= rounding, "{z} {w} {m} {q}");
            assert!(found.basic[i] || *z == 0.0);
        }
    }

    /// With a positive definite matrix there is one solution, with a semidefinite one Lemke's method finds one if there is one.
    #[test]
    fn it_agrees_with_all_bases() {
        let mut numbers = Numbers::of(7);
        let (mut solved, mut unsolved) = (0, 0);
        for round in 0..1200_usize {
            let n = 1 + round % 7;
            let rank = if round % 3 == 0 { n } else { n.div_ceil(2) };
            let a = numbers.matrix(n, rank);
            let skew = numbers.matrix(n, n);
            let mut m = &a * a.transpose();
            if round % 2 == 0 {
                m += (&skew - skew.transpose()) * 0.5;
            }
            let mut q = numbers.vector(n);
            if round % 5 == 0 {
                // Whole numbers: many ties.
                m.apply(|x| *x = x.round());
                m = &m * m.transpose();
                q.apply(|x| *x = (3.0 * *x).round());
            }
            let known = all(&m, &q);
            match lemke(&m, &q) {
                Outcome::Solution(found) => {
                    check(&m, &q, &found);
                    let near = |z: &DVector<f64>| (z - &found.z).amax() < 1e-9 * (1.0 + z.amax());
                    assert!(
                        known.iter().any(near),
                        "{round} {known:?} {} {:?}",
                        found.z,
                        found.basic
                    );
                    solved += 1;
                }
                Outcome::Ray => {
                    assert!(known.is_empty(), "{round} {m} {q}");
                    unsolved += 1;
                }
                Outcome::TooLong => panic!("{round} {m} {q}"),
            }
        }
        assert!(solved > 600 && unsolved > 100, "{solved} {unsolved}");
    }

    /// Without such a matrix a ray proves nothing, but a result is a solution.
    #[test]
    fn what_it_finds_is_a_solution() {
        let mut numbers = Numbers::of(3);
        let mut solved = 0;
        for round in 0..1000 {
            let n = 1 + round % 7;
            let (m, q) = (numbers.matrix(n, n), numbers.vector(n));
            let cover = numbers.vector(n).map(|x| 1.5 + x);
            let known = all(&m, &q);
            if let Outcome::Solution(found) = lemke_from(&m, &q, &cover) {
                check(&m, &q, &found);
                let near = |z: &DVector<f64>| (z - &found.z).amax() < 1e-7 * (1.0 + z.amax());
                assert!(known.iter().any(near), "{m} {q} {}", found.z);
                solved += 1;
            }
        }
        assert!(solved > 300, "{solved}");
    }

    /// Chvátal's and other numbers on which rules without order of ties return to where they were.
    #[test]
    fn ties_do_not_lead_in_circles() {
        // The linear programme that Beale's example is, as conditions of its optimum.
        let a = DMatrix::from_row_slice(
            3,
            4,
            &[
                0.25, -60.0, -0.04, 9.0, 0.5, -90.0, -0.02, 3.0, 0.0, 0.0, 1.0, 0.0,
            ],
        );
        let c = [-0.75, 150.0, -0.02, 6.0];
        let b = [0.0, 0.0, 1.0];
        let mut m = DMatrix::zeros(7, 7);
        m.view_mut((0, 4), (4, 3)).copy_from(&a.transpose());
        m.view_mut((4, 0), (3, 4)).copy_from(&-&a);
        let q = DVector::from_iterator(7, c.into_iter().chain(b));
        let Outcome::Solution(found) = lemke(&m, &q) else {
            panic!("it has an optimum");
        };
        check(&m, &q, &found);
        let least: f64 = (0..4).map(|k| c[k] * found.z[k]).sum();
        assert!((least + 0.05).abs() < 1e-14, "{least}");
        // Everything is a tie.
        for n in [1, 5, 30] {
            let m = DMatrix::from_element(n, n, 1.0);
            let q = DVector::from_element(n, -1.0);
            let Outcome::Solution(found) = lemke(&m, &q) else {
                panic!("{n}");
            };
            check(&m, &q, &found);
            assert_eq!(found.z.sum(), 1.0);
        }
    }

    #[test]
    fn what_are_no_numbers_has_no_solution() {
        let q = DVector::from_element(2, -1.0);
        for bad in [f64::NAN, f64::INFINITY] {
            let m = DMatrix::from_element(2, 2, bad);
            assert!(matches!(lemke(&m, &q), Outcome::Ray));
            let one = DMatrix::identity(2, 2);
            assert!(matches!(
                lemke(&one, &DVector::from_element(2, bad)),
                Outcome::Ray
            ));
        }
        assert!(matches!(lemke(&DMatrix::zeros(2, 2), &q), Outcome::Ray));
        assert!(matches!(lemke(&DMatrix::zeros(1, 3), &q), Outcome::Ray));
        let nothing = lemke(&DMatrix::zeros(0, 0), &DVector::zeros(0));
        assert!(matches!(nothing, Outcome::Solution(_)));
        // No positive number covers.
        let none = lemke_from(&DMatrix::identity(2, 2), &q, &DVector::zeros(2));
        assert!(matches!(none, Outcome::Ray));
    }
}

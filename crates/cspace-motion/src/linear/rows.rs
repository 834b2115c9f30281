//! Linear equations of which some may depend on others: A y = b as A = R Q with orthonormal rows Q.
//!
//! Dependent equations follow from those before them, contacts from joints. The factorizations of `nalgebra` that tell the rank choose
//! by size, and so others at each step.

use core::ops::Range;

use super::{add_scaled, dot, length};

/// A row is independent of those before it if its component orthogonal to them is longer than this, relative to the
/// row. It is the square root of the rounding: a row closer to the others would be solved to fewer than half of the
/// digits.
const DEPENDENT: f64 = 1e-8;

/// Rows of equations, orthogonalized.
#[derive(Debug, Clone, Default)]
pub(crate) struct Rows {
    /// Q: an orthonormal basis of the rows, each with its non-zero range: a contact concerns two parts, and its
    /// component orthogonal to the rows before it often only one.
    basis: Vec<(Vec<f64>, Range<usize>)>,
    /// R of the rows that are independent: row i has i + 1 numbers.
    triangle: Vec<Vec<f64>>,
    /// Indices of these rows.
    independent: Vec<usize>,
    count: usize,
}

impl Rows {
    pub(crate) fn of(rows: &[Vec<f64>]) -> Self {
        let mut all = Self::default();
        for row in rows {
            all.push(row);
        }
        all
    }

    pub(crate) fn push(&mut self, row: &[f64]) {
        let mut rest = row.to_vec();
        let mut parts = vec![0.0; self.basis.len()];
        // Twice is enough for orthogonality to rounding.
        for _ in 0..2 {
            for ((q, within), part) in self.basis.iter().zip(&mut parts) {
                let (rest, q) = (&mut rest[within.clone()], &q[within.clone()]);
                let along = dot(rest, q);
                add_scaled(rest, -along, q);
                *part += along;
            }
        }
        let long = length(&rest);
        if long > DEPENDENT * length(row) {
            rest.iter_mut().for_each(|x| *x /= long);
            parts.push(long);
            let within = support(&rest);
            self.basis.push((rest, within));
            self.triangle.push(parts);
            self.independent.push(self.count);
        }
        self.count += 1;
    }

    /// Number of independent rows.
    pub(crate) fn rank(&self) -> usize {
        self.basis.len()
    }

    /// The shortest y with A y = b for the rows that are independent; and λ with y = Aᵀ λ, 0 for the other rows.
    pub(crate) fn least(&self, b: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = self.basis.first().map_or(0, |q| q.0.len());
        let mut along: Vec<f64> = Vec::with_capacity(self.rank());
        for (row, &i) in self.triangle.iter().zip(&self.independent) {
            let known = dot(&row[..along.len()], &along);
            along.push((b[i] - known) / row[along.len()]);
        }
        let mut y = vec![0.0; n];
        for ((q, within), c) in self.basis.iter().zip(&along) {
            add_scaled(&mut y[within.clone()], *c, &q[within.clone()]);
        }
        // Rᵀ λ = the parts along the basis.
        let mut lambda = vec![0.0; self.count];
        for k in (0..along.len()).rev() {
            let later: f64 = (k + 1..along.len())
                .map(|i| self.triangle[i][k] * lambda[self.independent[i]])
                .sum();
            lambda[self.independent[k]] = (along[k] - later) / self.triangle[k][k];
        }
        (y, lambda)
    }

    /// Removes from a vector its components along the rows.
    pub(crate) fn take_out(&self, v: &mut [f64]) {
        for _ in 0..2 {
            for (q, within) in &self.basis {
                let (v, q) = (&mut v[within.clone()], &q[within.clone()]);
                let along = dot(v, q);
                add_scaled(v, -along, q);
            }
        }
    }
}

/// Range from the first to after the last number that is not 0.
fn support(v: &[f64]) -> Range<usize> {
    let first = v.iter().position(|x| *x != 0.0).unwrap_or(0);
    let end = v.iter().rposition(|x| *x != 0.0).map_or(0, |last| last + 1);
    first..end
}

#[cfg(test)]
mod tests {
    use super::super::dot;
    use super::Rows;

    #[test]
    fn the_shortest_solution_and_its_multipliers() {
        let a = [
            vec![1.0, 2.0, 0.0],
            vec![0.0, 1.0, 1.0],
            vec![1.0, 3.0, 1.0],
        ];
        let rows = Rows::of(&a);
        // The third is the sum of the others.
        assert_eq!(rows.rank(), 2);
        let (y, lambda) = rows.least(&[1.0, 2.0, 3.0]);
        for (row, b) in a.iter().zip([1.0, 2.0, 3.0]) {
            assert!((dot(row, &y) - b).abs() < 1e-14);
        }
        for (k, y) in y.iter().enumerate() {
            let sum: f64 = a.iter().zip(&lambda).map(|(row, l)| row[k] * l).sum();
            assert!((sum - y).abs() < 1e-14);
        }
        let mut v = vec![3.0, -1.0, 2.0];
        rows.take_out(&mut v);
        assert!(a.iter().all(|row| dot(row, &v).abs() < 1e-14));
    }
}

//! Square systems of equations of which some may depend on others.

use super::{Rows, add_scaled, dot};

/// Smallest pivot, as a share of the largest; a row with a smaller one depends on the rows before it. The matrices are
/// products of two directions each, so directions that differ by an angle of 10⁻⁶ still count as two; products carry
/// rounding of some 10⁻¹⁵.
const RANK: f64 = 1e-12;

/// A = L U with rows and columns in an order that puts the largest pivots first.
#[derive(Debug, Clone, Default)]
pub(crate) struct Square {
    n: usize,
    /// L, without its diagonal of ones, and U, by rows in their order.
    lu: Vec<f64>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    rank: usize,
}

impl Square {
    /// Factors a matrix of n × n numbers by rows; `None` if one of them is not finite. The previous factors are
    /// discarded and their memory is used again.
    pub(crate) fn factor(&mut self, n: usize, at: impl Fn(usize, usize) -> f64) -> Option<()> {
        self.n = n;
        self.lu.clear();
        self.lu.extend((0..n * n).map(|k| at(k / n, k % n)));
        self.rows.clear();
        self.rows.extend(0..n);
        self.columns.clear();
        self.columns.extend(0..n);
        self.rank = 0;
        if self.lu.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let mut first = 0.0;
        for k in 0..n {
            let (mut largest, mut place) = (0.0, (k, k));
            for i in k..n {
                for (j, x) in self.lu[i * n + k..(i + 1) * n].iter().enumerate() {
                    if x.abs() > largest {
                        (largest, place) = (x.abs(), (i, k + j));
                    }
                }
            }
            if k == 0 {
                first = largest;
            }
            if largest <= RANK * first {
                break;
            }
            self.swap(k, place);
            let (above, below) = self.lu.split_at_mut((k + 1) * n);
            let pivot = &above[k * n..];
            for row in below.chunks_exact_mut(n) {
                let share = row[k] / pivot[k];
                row[k] = share;
                add_scaled(&mut row[k + 1..], -share, &pivot[k + 1..]);
            }
            self.rank += 1;
        }
        Some(())
    }

    fn swap(&mut self, k: usize, (row, column): (usize, usize)) {
        let n = self.n;
        if row != k {
            let (above, below) = self.lu.split_at_mut(row * n);
            above[k * n..(k + 1) * n].swap_with_slice(&mut below[..n]);
            self.rows.swap(k, row);
        }
        if column != k {
            for i in 0..n {
                self.lu.swap(i * n + k, i * n + column);
            }
            self.columns.swap(k, column);
        }
    }

    /// Whether all rows are independent.
    pub(crate) fn is_regular(&self) -> bool {
        self.rank == self.n
    }

    /// L⁻¹ b, for the rows that are independent.
    fn forward(&self, b: &[f64]) -> Vec<f64> {
        let n = self.n;
        let mut u: Vec<f64> = Vec::with_capacity(n);
        for i in 0..self.rank {
            let known = dot(&self.lu[i * n..i * n + i], &u);
            u.push(b[self.rows[i]] - known);
        }
        u
    }

    /// The solution of the rows that are independent in which as many unknowns as can be are 0.
    pub(crate) fn basic(&self, b: &[f64]) -> Vec<f64> {
        let (n, rank) = (self.n, self.rank);
        let mut u = self.forward(b);
        for i in (0..rank).rev() {
            let known = dot(&self.lu[i * n + i + 1..i * n + rank], &u[i + 1..]);
            u[i] = (u[i] - known) / self.lu[i * n + i];
        }
        let mut found = vec![0.0; n];
        for (&column, u) in self.columns.iter().zip(u) {
            found[column] = u;
        }
        found
    }

    /// The solution of the rows that are independent for which Σ (unit · unknown)² is least.
    pub(crate) fn least(&self, b: &[f64], unit: &[f64]) -> Vec<f64> {
        if self.is_regular() {
            return self.basic(b);
        }
        let (n, rank) = (self.n, self.rank);
        let mut rows = Rows::default();
        for i in 0..rank {
            let row = |j: usize| {
                if j < i {
                    0.0
                } else {
                    self.lu[i * n + j] / unit[self.columns[j]]
                }
            };
            rows.push(&(0..n).map(row).collect::<Vec<f64>>());
        }
        let (shortest, _) = rows.least(&self.forward(b));
        let mut found = vec![0.0; n];
        for (&column, x) in self.columns.iter().zip(shortest) {
            found[column] = x / unit[column];
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::{Square, dot};

    /// Rows of a matrix, the third of which may be the sum of the others.
    fn matrix(third: [f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 2.0, -1.0], [0.5, -3.0, 4.0], third]
    }

    #[test]
    fn a_regular_matrix_has_one_solution() {
        let a = matrix([7.0, 0.0, 2.0]);
        let mut square = Square::default();
        square.factor(3, |i, j| a[i][j]).unwrap();
        assert!(square.is_regular());
        let b = [1.0, -2.0, 5.0];
        for x in [square.basic(&b), square.least(&b, &[1.0, 5.0, 1.0])] {
            for (row, b) in a.iter().zip(b) {
                assert!((dot(row, &x) - b).abs() < 1e-14);
            }
        }
    }

    /// The least solution is at right angles, in its metric, to what makes no difference.
    #[test]
    fn a_singular_matrix_has_a_least_one() {
        let a = matrix([1.5, -1.0, 3.0]);
        // a · idle = 0.
        let idle = [5.0, -4.5, -4.0];
        assert!(a.iter().all(|row| dot(row, &idle).abs() < 1e-14));
        let mut square = Square::default();
        square.factor(3, |i, j| a[i][j]).unwrap();
        assert!(!square.is_regular());
        let (b, unit) = ([1.0, -2.0, -1.0], [1.0, 3.0, 0.5]);
        let x = square.least(&b, &unit);
        for (row, b) in a.iter().zip(b) {
            assert!((dot(row, &x) - b).abs() < 1e-14);
        }
        let along: f64 = (0..3).map(|k| x[k] * idle[k] * unit[k] * unit[k]).sum();
        assert!(along.abs() < 1e-13, "{along}");
        let basic = square.basic(&b);
        assert_eq!(basic.iter().filter(|x| **x == 0.0).count(), 1);
    }

    #[test]
    fn nothing_and_no_numbers() {
        let mut square = Square::default();
        square.factor(2, |_, _| 0.0).unwrap();
        assert_eq!(square.least(&[0.0; 2], &[1.0; 2]), [0.0; 2]);
        square.factor(0, |_, _| 0.0).unwrap();
        assert!(square.basic(&[]).is_empty());
        assert!(square.factor(2, |_, _| f64::NAN).is_none());
    }
}

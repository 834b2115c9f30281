//! Square systems of equations of which some may depend on others.
//!
//! `nalgebra` factors; the rank and what is solved of a singular matrix are decided here.

use nalgebra::{DMatrix, DVector, Dyn, FullPivLU, PermutationSequence};

use super::Rows;

/// Smallest pivot, as a share of the largest; a row with a smaller one depends on the rows before it. The matrices are
/// products of two directions each, so directions that differ by an angle of 10⁻⁶ still count as two; products carry
/// rounding of some 10⁻¹⁵.
const RANK: f64 = 1e-12;

/// A = L U with rows and columns in an order that puts the largest pivots first.
#[derive(Debug, Clone)]
pub(crate) struct Square {
    rows: PermutationSequence<Dyn>,
    lower: DMatrix<f64>,
    upper: DMatrix<f64>,
    columns: PermutationSequence<Dyn>,
    rank: usize,
}

impl Square {
    /// Factors a matrix; `None` if a number is not finite.
    pub(crate) fn of(matrix: DMatrix<f64>) -> Option<Self> {
        if matrix.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let (rows, lower, upper, columns) = FullPivLU::new(matrix).unpack();
        let pivots = upper.diagonal().abs();
        let rank = (pivots.iter())
            .take_while(|&&pivot| pivot > RANK * pivots[0])
            .count();
        Some(Self {
            rows,
            lower,
            upper,
            columns,
            rank,
        })
    }

    /// Whether all rows are independent.
    pub(crate) fn is_regular(&self) -> bool {
        self.rank == self.upper.nrows()
    }

    /// L⁻¹ b, for the rows that are independent, and 0 for the others.
    fn forward(&self, b: &[f64]) -> DVector<f64> {
        let mut u = DVector::from_column_slice(b);
        self.rows.permute_rows(&mut u);
        let (mut known, mut rest) = u.rows_range_pair_mut(..self.rank, self.rank..);
        let lower = self.lower.view((0, 0), (self.rank, self.rank));
        lower.solve_lower_triangular_unchecked_mut(&mut known);
        rest.fill(0.0);
        u
    }

    /// The solution of the rows that are independent in which as many unknowns as can be are 0.
    pub(crate) fn basic(&self, b: &[f64]) -> DVector<f64> {
        let mut x = self.forward(b);
        let upper = self.upper.view((0, 0), (self.rank, self.rank));
        upper.solve_upper_triangular_unchecked_mut(&mut x.rows_mut(0, self.rank));
        self.columns.inv_permute_rows(&mut x);
        x
    }

    /// The solution of the rows that are independent for which Σ (unit · unknown)² is least.
    pub(crate) fn least(&self, b: &[f64], unit: &[f64]) -> DVector<f64> {
        if self.is_regular() {
            return self.basic(b);
        }
        let mut units = DVector::from_column_slice(unit);
        self.columns.permute_rows(&mut units);
        let mut rows = Rows::default();
        for row in self.upper.row_iter().take(self.rank) {
            rows.push(row.transpose().component_div(&units).as_slice());
        }
        let (shortest, _) = rows.least(self.forward(b).as_slice());
        let mut x = DVector::zeros(unit.len());
        for ((x, shortest), unit) in x.iter_mut().zip(shortest).zip(&units) {
            *x = shortest / unit;
        }
        self.columns.inv_permute_rows(&mut x);
        x
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::super::dot;
    use super::Square;

    /// Rows of a matrix, the third of which may be the sum of the others.
    fn matrix(third: [f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 2.0, -1.0], [0.5, -3.0, 4.0], third]
    }

    #[test]
    fn a_regular_matrix_has_one_solution() {
        let a = matrix([7.0, 0.0, 2.0]);
        let square = Square::of(DMatrix::from_fn(3, 3, |i, j| a[i][j])).unwrap();
        assert!(square.is_regular());
        let b = [1.0, -2.0, 5.0];
        for x in [square.basic(&b), square.least(&b, &[1.0, 5.0, 1.0])] {
            for (row, b) in a.iter().zip(b) {
                assert!((dot(row, x.as_slice()) - b).abs() < 1e-14);
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
        let square = Square::of(DMatrix::from_fn(3, 3, |i, j| a[i][j])).unwrap();
        assert!(!square.is_regular());
        let (b, unit) = ([1.0, -2.0, -1.0], [1.0, 3.0, 0.5]);
        let x = square.least(&b, &unit);
        for (row, b) in a.iter().zip(b) {
            assert!((dot(row, x.as_slice()) - b).abs() < 1e-14);
        }
        let along: f64 = (0..3).map(|k| x[k] * idle[k] * unit[k] * unit[k]).sum();
        assert!(along.abs() < 1e-13, "{along}");
        let basic = square.basic(&b);
        assert_eq!(basic.iter().filter(|x| **x == 0.0).count(), 1);
    }

    #[test]
    fn nothing_and_no_numbers() {
        let square = Square::of(DMatrix::zeros(2, 2)).unwrap();
        assert_eq!(square.least(&[0.0; 2], &[1.0; 2]).as_slice(), [0.0; 2]);
        assert!(
            Square::of(DMatrix::zeros(0, 0))
                .unwrap()
                .basic(&[])
                .is_empty()
        );
        assert!(Square::of(DMatrix::repeat(2, 2, f64::NAN)).is_none());
    }
}

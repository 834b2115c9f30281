//! Functions that are kept as they are by forces along directions that need not be their gradients.

use nalgebra::DMatrix;

use super::{Rows, Square, add_scaled, dot, length};

/// Equations C x = b that a change x = D λ meets; without friction D = Cᵀ.
#[derive(Debug, Clone)]
pub(crate) struct Pushing {
    rows: Rows,
    vectors: Vec<Vec<f64>>,
    /// The columns of D, and C D, where D is not Cᵀ.
    along: Option<(Vec<Vec<f64>>, Square)>,
}

/// An equation that is missed by more than this share of the largest is not met: half of the digits.
const MISSED: f64 = 1e-8;

impl Pushing {
    /// Factors the rows of C, and the columns of D if D is not Cᵀ. `None` if numbers are not finite.
    pub(crate) fn of(vectors: Vec<Vec<f64>>, along: Option<Vec<Vec<f64>>>) -> Option<Self> {
        let along = match along {
            None => None,
            Some(along) => {
                let n = vectors.len();
                let products = DMatrix::from_fn(n, n, |i, j| dot(&vectors[i], &along[j]));
                Some((along, Square::of(products)?))
            }
        };
        Some(Self {
            rows: Rows::of(&vectors),
            vectors,
            along,
        })
    }

    /// Orthogonalized rows of C.
    pub(crate) fn rows(&self) -> &Rows {
        &self.rows
    }

    /// The lengths of the columns of D.
    pub(crate) fn lengths(&self) -> Vec<f64> {
        let columns = self.along.as_ref().map_or(&self.vectors, |a| &a.0);
        columns.iter().map(|v| length(v)).collect()
    }

    /// x = D λ, and λ; `None` if no forces along these directions meet the equations.
    pub(crate) fn meet(&self, b: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
        let Some((along, square)) = &self.along else {
            return Some(self.rows.least(b));
        };
        let units: Vec<f64> = along.iter().map(|v| length(v)).collect();
        let multipliers = square.least(b, &units);
        let mut x = vec![0.0; along.first().map_or(0, Vec::len)];
        for (column, m) in along.iter().zip(&multipliers) {
            add_scaled(&mut x, *m, column);
        }
        let largest = b.iter().fold(0.0_f64, |m, b| m.max(b.abs()));
        let meets = |(row, b): (&Vec<f64>, &f64)| (dot(row, &x) - b).abs() <= MISSED * largest;
        let multipliers = multipliers.as_slice().to_vec();
        (self.vectors.iter().zip(b).all(meets)).then_some((x, multipliers))
    }

    /// Projects a force to where the functions do not change, by forces along the directions; returns the rest and the
    /// multipliers.
    pub(crate) fn hold(&self, force: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
        let against: Vec<f64> = self.vectors.iter().map(|v| -dot(v, force)).collect();
        let (x, multipliers) = self.meet(&against)?;
        let mut rest = force.to_vec();
        add_scaled(&mut rest, 1.0, &x);
        Some((rest, multipliers))
    }

    /// Whether forces push along the gradients of the functions.
    pub(crate) fn is_smooth(&self) -> bool {
        self.along.is_none()
    }
}

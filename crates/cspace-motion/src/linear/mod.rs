//! Small dense linear algebra: as many unknowns as a mechanism has coordinates.

mod cholesky;
mod nonnegative;
mod pushing;
mod rows;
mod square;

pub(crate) use cholesky::Cholesky;
pub(crate) use nonnegative::nonnegative;
pub(crate) use pushing::Pushing;
pub(crate) use rows::Rows;
pub(crate) use square::Square;

/// The scalar product of two vectors of the same length.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// a += s b.
pub(crate) fn add_scaled(a: &mut [f64], s: f64, b: &[f64]) {
    for (x, y) in a.iter_mut().zip(b) {
        *x += s * y;
    }
}

pub(crate) fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

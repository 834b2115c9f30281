//! Vectors of weighted coordinates. Pairs that have only two leave the third at 0.

use super::tolerance::DEPENDENT;

pub(super) type Vec3 = [f64; 3];

pub(super) fn plus(a: Vec3, b: Vec3) -> Vec3 {
    core::array::from_fn(|i| a[i] + b[i])
}

pub(super) fn minus(a: Vec3, b: Vec3) -> Vec3 {
    core::array::from_fn(|i| a[i] - b[i])
}

pub(super) fn times(a: Vec3, s: f64) -> Vec3 {
    a.map(|x| x * s)
}

pub(super) fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn size(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

/// The point at a share of the way from one vector to another; the other itself from 1 on.
pub(super) fn between(from: Vec3, to: Vec3, share: f64) -> Vec3 {
    if share >= 1.0 {
        to
    } else {
        plus(from, times(minus(to, from), share))
    }
}

/// How much of each of some vectors, three at most, makes the shortest sum that has given products with them. `None` if they depend on
/// each other, or all but do, so that it is not known.
pub(super) fn weights_of(rows: &[Vec3], values: &[f64]) -> Option<Vec3> {
    let n = rows.len().min(3);
    let mut matrix = [[0.0; 4]; 3];
    for i in 0..n {
        for k in 0..n {
            matrix[i][k] = dot(rows[i], rows[k]);
        }
        matrix[i][3] = values[i];
    }
    // No pivoting: the products of vectors with each other are positive definite.
    for i in 0..n {
        let row = matrix[i];
        let independent = row[i] > DEPENDENT * dot(rows[i], rows[i]);
        if !independent {
            return None;
        }
        for below in &mut matrix[i + 1..n] {
            let share = below[i] / row[i];
            for (x, y) in below.iter_mut().zip(row).skip(i) {
                *x -= share * y;
            }
        }
    }
    let mut weights = [0.0; 3];
    for i in (0..n).rev() {
        let row = matrix[i];
        let known: f64 = (i + 1..n).map(|j| row[j] * weights[j]).sum();
        weights[i] = (row[3] - known) / row[i];
    }
    Some(weights)
}

/// A vector with a sum of others added to it.
pub(super) fn weighted(rows: &[Vec3], weights: Vec3, from: Vec3) -> Vec3 {
    let add = |sum, (row, weight): (&Vec3, f64)| plus(sum, times(*row, weight));
    rows.iter().zip(weights).fold(from, add)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The shortest sum has the products asked for, and no other sum of the vectors has them.
    #[test]
    fn weights_give_the_products_asked_for() {
        let rows = [[1.0, 2.0, 0.5], [0.0, -1.0, 3.0], [2.0, 0.0, 1.0]];
        let values = [0.3, -0.7, 1.1];
        for n in 0..=3 {
            let weights = weights_of(&rows[..n], &values[..n]).unwrap_or([f64::NAN; 3]);
            let sum = weighted(&rows[..n], weights, [0.0; 3]);
            for k in 0..n {
                assert!((dot(rows[k], sum) - values[k]).abs() < 1e-12);
            }
        }
        let dependent = [rows[0], times(rows[0], -2.0)];
        assert_eq!(weights_of(&dependent, &[1.0, 1.0]), None);
    }
}

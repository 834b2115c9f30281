//! M = L Lᵀ, of blocks along the diagonal.
//!
//! `nalgebra`'s factor is dense: sixteen parts that push each other take twice as long with it.

/// The factor L of a symmetric positive definite matrix.
///
/// Parts are coupled by dampers alone, so the matrix has small blocks along its diagonal: entries to the left of the
/// first non-zero one of a row stay 0 in L, and are left out of all sums.
#[derive(Debug, Clone)]
pub(crate) struct Cholesky {
    n: usize,
    /// Entries of L by rows; those above the diagonal are never read.
    lower: Vec<f64>,
    /// First column of each row that is not 0.
    first: Vec<usize>,
    /// Row after the last of each column that is not 0.
    end: Vec<usize>,
}

impl Cholesky {
    /// Factors a matrix of n × n numbers by rows; `None` if it is not positive definite.
    pub(crate) fn of(matrix: &[f64], n: usize) -> Option<Self> {
        let mut l = matrix.to_vec();
        let first: Vec<usize> = (0..n)
            .map(|i| (0..i).find(|j| l[i * n + j] != 0.0).unwrap_or(i))
            .collect();
        for i in 0..n {
            for j in first[i]..=i {
                let begin = first[i].max(first[j]);
                let inner: f64 = (begin..j).map(|k| l[i * n + k] * l[j * n + k]).sum();
                let rest = l[i * n + j] - inner;
                if i == j {
                    // Not a number is not positive either.
                    if rest.partial_cmp(&0.0) != Some(core::cmp::Ordering::Greater) {
                        return None;
                    }
                    l[i * n + i] = rest.sqrt();
                } else {
                    l[i * n + j] = rest / l[j * n + j];
                }
            }
        }
        let mut end = vec![0; n];
        for (i, &first) in first.iter().enumerate() {
            end[first..=i].fill(i + 1);
        }
        Some(Self {
            n,
            lower: l,
            first,
            end,
        })
    }

    /// L⁻¹ b.
    pub(crate) fn forward(&self, b: &mut [f64]) {
        let (n, l) = (self.n, &self.lower);
        for i in 0..n {
            let inner: f64 = (self.first[i]..i).map(|k| l[i * n + k] * b[k]).sum();
            b[i] = (b[i] - inner) / l[i * n + i];
        }
    }

    /// L⁻ᵀ b.
    pub(crate) fn backward(&self, b: &mut [f64]) {
        let (n, l) = (self.n, &self.lower);
        for i in (0..n).rev() {
            let below = (i + 1..self.end[i]).filter(|&k| self.first[k] <= i);
            let inner: f64 = below.map(|k| l[k * n + i] * b[k]).sum();
            b[i] = (b[i] - inner) / l[i * n + i];
        }
    }

    /// Computes sums of the magnitudes of the terms of L⁻ᵀ b, from those of b.
    pub(crate) fn backward_sizes(&self, b: &mut [f64]) {
        let (n, l) = (self.n, &self.lower);
        for i in (0..n).rev() {
            let below = (i + 1..self.end[i]).filter(|&k| self.first[k] <= i);
            let inner: f64 = below.map(|k| l[k * n + i].abs() * b[k]).sum();
            b[i] = (b[i] + inner) / l[i * n + i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Cholesky;

    /// Two blocks that a row across both ties together: within its first entries nothing is 0.
    #[test]
    fn blocks_are_solved_as_what_is_full() {
        let n = 6;
        let entries = [(1, 0, 1.0), (3, 2, -2.0), (5, 1, 0.5), (5, 4, 1.5)];
        let mut m = vec![0.0; n * n];
        for i in 0..n {
            m[i * n + i] = 4.0 + i as f64;
        }
        for (i, k, value) in entries {
            (m[i * n + k], m[k * n + i]) = (value, value);
        }
        let x: Vec<f64> = (0..n).map(|i| 1.0 - 0.3 * i as f64).collect();
        let mut b: Vec<f64> = (0..n)
            .map(|i| super::super::dot(&m[i * n..][..n], &x))
            .collect();
        let factor = Cholesky::of(&m, n).unwrap();
        factor.forward(&mut b);
        factor.backward(&mut b);
        assert!(b.iter().zip(x).all(|(a, b)| (a - b).abs() < 1e-14));
    }

    #[test]
    fn solves_what_it_has_factored() {
        let m = [4.0, 1.0, 2.0, 1.0, 5.0, 3.0, 2.0, 3.0, 6.0];
        let x = [1.0, -2.0, 0.5];
        let mut b: Vec<f64> = m.chunks(3).map(|row| super::super::dot(row, &x)).collect();
        let factor = Cholesky::of(&m, 3).unwrap();
        factor.forward(&mut b);
        factor.backward(&mut b);
        assert!(b.iter().zip(x).all(|(a, b)| (a - b).abs() < 1e-14));
        assert!(Cholesky::of(&[1.0, 2.0, 2.0, 1.0], 2).is_none());
    }
}

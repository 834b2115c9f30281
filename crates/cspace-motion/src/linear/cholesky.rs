//! M = L Lᵀ.

/// The factor L of a symmetric positive definite matrix.
#[derive(Debug, Clone)]
pub(crate) struct Cholesky {
    n: usize,
    /// By rows; above the diagonal nothing is read.
    lower: Vec<f64>,
}

impl Cholesky {
    /// Of a matrix of n × n numbers by rows; `None` if it is not positive definite.
    pub(crate) fn of(matrix: &[f64], n: usize) -> Option<Self> {
        let mut l = matrix.to_vec();
        for i in 0..n {
            for j in 0..=i {
                let inner: f64 = (0..j).map(|k| l[i * n + k] * l[j * n + k]).sum();
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
        Some(Self { n, lower: l })
    }

    /// L⁻¹ b.
    pub(crate) fn forward(&self, b: &mut [f64]) {
        let (n, l) = (self.n, &self.lower);
        for i in 0..n {
            let inner: f64 = (0..i).map(|k| l[i * n + k] * b[k]).sum();
            b[i] = (b[i] - inner) / l[i * n + i];
        }
    }

    /// L⁻ᵀ b.
    pub(crate) fn backward(&self, b: &mut [f64]) {
        let (n, l) = (self.n, &self.lower);
        for i in (0..n).rev() {
            let inner: f64 = (i + 1..n).map(|k| l[k * n + i] * b[k]).sum();
            b[i] = (b[i] - inner) / l[i * n + i];
        }
    }

    /// The sums of the sizes of the terms of L⁻ᵀ b, from those of b.
    pub(crate) fn backward_sizes(&self, b: &mut [f64]) {
        let (n, l) = (self.n, &self.lower);
        for i in (0..n).rev() {
            let inner: f64 = (i + 1..n).map(|k| l[k * n + i].abs() * b[k]).sum();
            b[i] = (b[i] + inner) / l[i * n + i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Cholesky;

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

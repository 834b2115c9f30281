//! Eigenvalues of symmetric matrices.

/// Sweeps converge quadratically: a few are enough for a matrix of any size here.
const MOST_SWEEPS: usize = 60;

/// The eigenvalues of a symmetric matrix, n × n by rows, each with its unit eigenvector.
///
/// Source: Golub and Van Loan, Matrix Computations, section 8.5: the cyclic method of Jacobi.
pub(crate) fn eigen(matrix: &[f64], n: usize) -> Vec<(f64, Vec<f64>)> {
    let mut a = matrix.to_vec();
    let mut v = vec![0.0; n * n];
    for i in 0..n {
        v[i * n + i] = 1.0;
    }
    for _ in 0..MOST_SWEEPS {
        let mut turned = false;
        for p in 0..n {
            for q in p + 1..n {
                let (app, aqq, apq) = (a[p * n + p], a[q * n + q], a[p * n + q]);
                if apq.abs() <= f64::EPSILON * (app * aqq).abs().sqrt() || apq == 0.0 {
                    continue;
                }
                turned = true;
                let theta = (aqq - app) / (2.0 * apq);
                let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for k in 0..n {
                    let (x, y) = (a[k * n + p], a[k * n + q]);
                    (a[k * n + p], a[k * n + q]) = (c * x - s * y, s * x + c * y);
                }
                for k in 0..n {
                    let (x, y) = (a[p * n + k], a[q * n + k]);
                    (a[p * n + k], a[q * n + k]) = (c * x - s * y, s * x + c * y);
                    let (x, y) = (v[k * n + p], v[k * n + q]);
                    (v[k * n + p], v[k * n + q]) = (c * x - s * y, s * x + c * y);
                }
            }
        }
        if !turned {
            break;
        }
    }
    let column = |j: usize| (0..n).map(|i| v[i * n + j]).collect();
    (0..n).map(|j| (a[j * n + j], column(j))).collect()
}

#[cfg(test)]
mod tests {
    use super::super::dot;
    use super::eigen;

    #[test]
    fn vectors_are_stretched_by_their_values() {
        let n = 4;
        let m: Vec<f64> = (0..n * n)
            .map(|k| {
                let (i, j) = ((k / n).min(k % n), (k / n).max(k % n));
                1.0 / (1.0 + i as f64 + 3.0 * j as f64) - if i == j { 1.0 } else { 0.0 }
            })
            .collect();
        let found = eigen(&m, n);
        for (value, vector) in &found {
            assert!((dot(vector, vector) - 1.0).abs() < 1e-14);
            for i in 0..n {
                let along = dot(&m[i * n..(i + 1) * n], vector);
                assert!((along - value * vector[i]).abs() < 1e-14);
            }
        }
        let trace: f64 = found.iter().map(|f| f.0).sum();
        assert!((trace - (0..n).map(|i| m[i * n + i]).sum::<f64>()).abs() < 1e-14);
        assert!(eigen(&[], 0).is_empty());
    }
}

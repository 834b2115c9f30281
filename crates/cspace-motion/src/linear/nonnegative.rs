//! Least squares with unknowns that are not negative.

use super::{Rows, add_scaled, dot};

/// A column whose share of the residual is below this does not enter (of columns and a residual of length 1 or less): it is
/// rounding.
const ROUNDING: f64 = 1e-13;

/// The answer: u ≥ 0, and b − A u.
#[derive(Debug, Clone)]
pub(crate) struct Nonnegative {
    pub(crate) u: Vec<f64>,
    pub(crate) residual: Vec<f64>,
}

/// The least |A u − b| with u ≥ 0, by columns of A, each of about length 1.
///
/// Columns that follow from others do no harm: they stay out.
///
/// Source: Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23, algorithm NNLS.
pub(crate) fn nonnegative(columns: &[Vec<f64>], b: &[f64]) -> Nonnegative {
    let m = columns.len();
    let mut u = vec![0.0; m];
    let mut inside: Vec<usize> = Vec::new();
    let mut residual = b.to_vec();
    // Columns that could not enter since the residual last became shorter.
    let mut refused = vec![false; m];
    // Each time round the residual becomes shorter or a column is refused: sets of columns do not return, so there is an end;
    // it comes within a few times m in practice.
    for _ in 0..30 * (m + 1) {
        let share = |j: usize| dot(&columns[j], &residual);
        let outside = (0..m).filter(|j| !inside.contains(j) && !refused[*j]);
        let enters = outside.max_by(|&i, &j| share(i).total_cmp(&share(j)));
        let Some(enters) = enters.filter(|&j| share(j) > ROUNDING) else {
            break;
        };
        inside.push(enters);
        loop {
            let Some(solved) = least_squares(columns, &inside, b) else {
                inside.retain(|&j| j != enters);
                refused[enters] = true;
                break;
            };
            if solved.last().is_some_and(|&z| z <= 0.0) && inside.last() == Some(&enters) {
                // A multiplier that should grow does not: rounding.
                inside.pop();
                refused[enters] = true;
                break;
            }
            // As far towards the solution as nothing becomes negative.
            let step = (inside.iter().zip(&solved))
                .filter(|&(_, &z)| z <= 0.0)
                .map(|(&j, &z)| u[j] / (u[j] - z))
                .fold(1.0, f64::min);
            for (&j, &z) in inside.iter().zip(&solved) {
                u[j] += step * (z - u[j]);
            }
            if step >= 1.0 {
                refused.fill(false);
                break;
            }
            let left = (inside.iter().zip(&solved))
                .filter(|&(&j, &z)| z <= 0.0 && u[j] <= ROUNDING * z.abs().max(ROUNDING))
                .map(|(&j, _)| j)
                .collect::<Vec<_>>();
            for j in &left {
                u[*j] = 0.0;
            }
            inside.retain(|j| !left.contains(j));
            if left.is_empty() || inside.is_empty() {
                break;
            }
        }
        residual = b.to_vec();
        for &j in &inside {
            add_scaled(&mut residual, -u[j], &columns[j]);
        }
    }
    Nonnegative { u, residual }
}

/// The least squares of some columns; `None` if one of them follows from the others.
fn least_squares(columns: &[Vec<f64>], inside: &[usize], b: &[f64]) -> Option<Vec<f64>> {
    let chosen: Vec<Vec<f64>> = inside.iter().map(|&j| columns[j].clone()).collect();
    let rows = Rows::of(&chosen);
    if rows.rank() < chosen.len() {
        return None;
    }
    let products: Vec<f64> = chosen.iter().map(|c| dot(c, b)).collect();
    Some(rows.least(&products).1)
}

#[cfg(test)]
mod tests {
    use super::{add_scaled, dot, nonnegative};

    /// The conditions of the optimum, for columns among which are multiples of each other.
    #[test]
    fn the_optimum_is_one() {
        let columns: Vec<Vec<f64>> = (0..9)
            .map(|i| {
                let a = f64::from(i % 7) * 0.9;
                vec![a.cos(), a.sin(), 0.3 * (2.0 * a).sin()]
            })
            .collect();
        for k in 0..20 {
            let a = f64::from(k) * 0.37;
            let b = [a.sin(), (1.3 * a).cos(), 0.2];
            let found = nonnegative(&columns, &b);
            let mut residual = b.to_vec();
            for (u, c) in found.u.iter().zip(&columns) {
                assert!(*u >= 0.0);
                add_scaled(&mut residual, -u, c);
                let share = dot(c, &found.residual);
                assert!(share < 1e-9, "{k}: {share}");
                assert!(*u == 0.0 || share.abs() < 1e-9, "{k}: {u} {share}");
            }
            assert!(
                residual
                    .iter()
                    .zip(&found.residual)
                    .all(|(a, b)| (a - b).abs() < 1e-12)
            );
        }
    }
}

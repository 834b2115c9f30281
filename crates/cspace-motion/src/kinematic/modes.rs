//! The modes that closed contacts and joints leave: directions in which forces change by themselves.

use nalgebra::DMatrix;

use crate::linear::{add_scaled, dot};

/// Largest stiffness that counts as 0, relative to that of the forces over the mechanism's size: the error of the
/// differences.
const NEUTRAL: f64 = 1e-8;

/// A direction in which no closed contact or joint changes.
#[derive(Debug, Clone)]
pub(super) struct Mode {
    /// The direction, in y.
    pub(super) along: Vec<f64>,
    /// The direction of the force that grows by a displacement, against it; the same without friction.
    pub(super) against: Vec<f64>,
    /// Change of force per displacement along the mode: without friction the second derivative of L.
    pub(super) stiffness: f64,
    /// The force along it that nothing balances.
    pub(super) force: f64,
}

/// Modes over an orthonormal basis, from the changes of force along each of its directions; whether displacements along
/// them come back; and the largest stiffness that counts as 0. Without friction the changes are symmetric. With
/// friction they are not: displacements come back if all eigenvalues have positive real parts, and S = Σ against ·
/// stiffness · alongᵀ is the singular value decomposition.
pub(super) fn modes(
    basis: &[Vec<f64>],
    changes: &[Vec<f64>],
    rest: &[f64],
    of_forces: f64,
    smooth: bool,
) -> (Vec<Mode>, bool, f64) {
    let n = basis.len();
    let combined = |shares: &mut dyn Iterator<Item = f64>| {
        let mut all = vec![0.0; rest.len()];
        for (share, direction) in shares.zip(basis) {
            add_scaled(&mut all, share, direction);
        }
        all
    };
    let mut matrix = DMatrix::from_fn(n, n, |j, k| -dot(&basis[j], &changes[k]));
    if smooth {
        // Differences have errors that are not symmetric.
        matrix = (&matrix + matrix.transpose()) * 0.5;
    }
    let neutral = NEUTRAL * matrix.amax().max(of_forces);
    if n == 0 || matrix.iter().any(|x| !x.is_finite()) {
        return (Vec::new(), n == 0, neutral);
    }
    if smooth {
        let found = matrix.symmetric_eigen();
        let directions = found.eigenvectors.column_iter();
        let modes: Vec<Mode> = (directions.zip(&found.eigenvalues))
            .map(|(direction, &stiffness)| {
                let along = combined(&mut direction.iter().copied());
                let force = dot(&along, rest);
                let against = along.clone();
                Mode {
                    along,
                    against,
                    stiffness,
                    force,
                }
            })
            .collect();
        let is_stable = modes.iter().all(|m| m.stiffness >= -neutral);
        return (modes, is_stable, neutral);
    }
    let is_stable = (matrix.complex_eigenvalues().iter()).all(|value| value.re >= -neutral);
    let svd = matrix.svd(true, true);
    let modes = (svd.u.iter().zip(&svd.v_t)).flat_map(|(u, v)| {
        (0..n).map(|k| {
            let along = combined(&mut v.row(k).iter().copied());
            let against = combined(&mut u.column(k).iter().copied());
            let force = dot(&against, rest);
            Mode {
                along,
                against,
                stiffness: svd.singular_values[k],
                force,
            }
        })
    });
    (modes.collect(), is_stable, neutral)
}

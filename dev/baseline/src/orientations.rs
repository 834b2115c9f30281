//! Orientations of slices.

use core::f64::consts::{PI, TAU};

use cspace::Band;

/// The paper's separation of slices, radians (section 4): no wider one gave it the right topology and an accuracy of 1 %.
pub const SEPARATION: f64 = 0.005;

/// Largest number of slices of a turn: more is a mistake in the separation, and would fill the memory.
pub const MOST_SLICES: f64 = 1e6;

/// A separation that slices cannot have.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("slices cannot be {0} rad apart: a turn takes between one and {MOST_SLICES} of them")]
pub struct SeparationError(pub f64);

/// Number of equal parts of at most `separation` in an interval of the given width.
fn parts(width: f64, separation: f64) -> Result<usize, SeparationError> {
    if separation > 0.0 && separation.is_finite() && TAU / separation <= MOST_SLICES {
        Ok((width / separation).ceil().max(1.0) as usize)
    } else {
        Err(SeparationError(separation))
    }
}

/// The middles of that many equal parts.
fn middles(lo: f64, width: f64, n: usize) -> impl Iterator<Item = f64> {
    (0..n).map(move |k| lo + (k as f64 + 0.5) / n as f64 * width)
}

/// Orientations over a turn at most `separation` apart, in radians, without regard to critical ones: the middles of
/// ⌈2π/s⌉ equal parts of [−π, π).
///
/// ```
/// let plain = cspace_baseline::evenly(cspace_baseline::SEPARATION)?;
/// assert_eq!(plain.len(), 1257);
/// # Ok::<(), cspace_baseline::SeparationError>(())
/// ```
///
/// # Errors
/// If the separation is not valid.
pub fn evenly(separation: f64) -> Result<Vec<f64>, SeparationError> {
    Ok(middles(-PI, TAU, parts(TAU, separation)?).collect())
}

/// Orientations at most `separation` apart that respect critical ones: a band of width w has the middles of ⌈w/s⌉ equal parts.
///
/// This makes about 2π/s + n/2 slices of n bands, which is what the old slices of Figure 5 are: 1265 of 12, 1293 of 72, 1366 of
/// 196. No slice lies at a critical orientation, and every band has one.
///
/// ```
/// use cspace::Band;
/// let bands = [Band { lo: 0.0, hi: 0.012 }, Band { lo: 0.012, hi: 0.013 }];
/// let orientations = cspace_baseline::with_bands(0.005, &bands)?;
/// assert_eq!(orientations.len(), 3 + 1);
/// assert!((orientations[3] - 0.0125).abs() < 1e-15);
/// # Ok::<(), cspace_baseline::SeparationError>(())
/// ```
///
/// # Errors
/// As [`evenly`].
pub fn with_bands(separation: f64, bands: &[Band]) -> Result<Vec<f64>, SeparationError> {
    let mut orientations = Vec::new();
    for band in bands {
        let width = band.hi - band.lo;
        orientations.extend(middles(band.lo, width, parts(width, separation)?));
    }
    Ok(orientations)
}

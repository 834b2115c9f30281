//! Lines and arcs for a run of samples.

use super::divide::Limits;
use super::fitted::Fitted;
use super::run::Run;
use super::{divide, tangent};

/// Factors by which the band is narrowed for the next try, at least and at most, and in all: the small corrections that
/// make pieces tangent take some of it, and a band of a share s needs s^(-1/3) times the pieces.
const NARROWER: f64 = 0.96;
const MUCH_NARROWER: f64 = 0.8;
const NARROWEST: f64 = 0.375;

/// Number of successive bands for which no chain of pieces is found, after which narrower ones are not tried. A chain
/// may be missed, for chains are distinguished by cells of angles.
const MISSES: usize = 3;

/// Factor, for each next try, by which pieces arrive more exactly in the direction of an end: the more exactly, the
/// smaller are the corrections that make them tangent there.
const MORE_EXACTLY: f64 = 8.0;

/// Fits lines and arcs to a run. None if the samples do not allow it: they are too coarse for the tolerance.
pub(crate) fn fit(run: &Run) -> Option<Fitted> {
    fit_within(run, &mut None)
}

/// As [`fit`], beginning with the limits at which fewer samples of the same curve were fitted before; updates these.
pub(super) fn fit_within(run: &Run, from: &mut Option<Limits>) -> Option<Fitted> {
    let pieces = divide::roughly(run);
    let mut limits = from.take().unwrap_or(Limits {
        width: 0.999 * run.band.width(),
        exactness: 1.0,
    });
    let mut misses = 0;
    while limits.width >= NARROWEST * run.band.width() && misses < MISSES {
        let mut next = NARROWER * limits.width;
        match divide::divide(run, pieces, limits) {
            None => misses += 1,
            Some(division) => {
                misses = 0;
                let mut over = f64::INFINITY;
                for with_lines in [true, false] {
                    let Some(made) = tangent::make(run, &division, with_lines) else {
                        continue;
                    };
                    match run.band.excess(made.range) {
                        0.0 => {
                            *from = Some(limits);
                            return Some(merged(made.fitted, run.is_closed));
                        }
                        excess => over = over.min(excess),
                    }
                }
                // Narrower by what the changes have taken; points that scatter ask for the fewest pieces.
                if over.is_finite() && !run.is_measured {
                    next = next
                        .min(limits.width - over)
                        .max(MUCH_NARROWER * limits.width);
                }
            }
        }
        limits.width = next;
        limits.exactness *= MORE_EXACTLY;
    }
    None
}

/// Removes joints of pieces that lie on one line or circle: a closed run may begin inside of one.
fn merged(mut fitted: Fitted, is_closed: bool) -> Fitted {
    /// Tolerance of equal curvatures, as a share of the curvature that bends the shorter piece by its own length.
    const SAME: f64 = 1e-9;
    let mut i = usize::from(!is_closed);
    while i < fitted.vertices.len() && fitted.vertices.len() > 2 {
        let n = fitted.vertices.len();
        let before = (i + n - 1) % n;
        let (first, second) = (fitted.vertices[before], fitted.vertices[i]);
        let next = match i + 1 {
            j if j < n => fitted.vertices[j].point(),
            _ if is_closed => fitted.vertices[0].point(),
            _ => fitted.end,
        };
        let chords = [
            first.point().distance(second.point()),
            second.point().distance(next),
        ];
        let sweeps = [first.bulge, second.bulge].map(|b| 4.0 * b.atan());
        let curvature = |k: usize| 2.0 * (sweeps[k] / 2.0).sin() / chords[k];
        let apart = (curvature(0) - curvature(1)).abs() * chords[0].min(chords[1]);
        let sweep = sweeps[0] + sweeps[1];
        // Half circles are enough for any circle.
        if apart > SAME || sweep.abs() > core::f64::consts::PI + SAME {
            i += 1;
            continue;
        }
        fitted.vertices[before].bulge = (sweep / 4.0).tan();
        fitted.vertices.remove(i);
    }
    fitted
}

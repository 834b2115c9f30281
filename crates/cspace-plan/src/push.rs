//! Away from what is near: towards more clearance.

use crate::legs::{Coords, Near};

/// The direction, of unit length where turning counts by its lever, in which the least of the distances grows the most: the
/// point nearest to zero of the convex hull of their gradients (the steepest ascent of a minimum). `None` if there is none.
pub(crate) fn ascent(near: &[Near], levers: Coords, _within: f64) -> Option<Coords> {
    /// Steps of the search for the nearest point.
    const STEPS: usize = 200;
    /// Gradients this small balance each other.
    const NONE: f64 = 1e-9;
    // In lengths: by x, y and the lever of θ.
    let scaled: Vec<Coords> = near
        .iter()
        .map(|n| core::array::from_fn(|k| if levers[k] > 0.0 { n.gradient[k] / levers[k] } else { 0.0 }))
        .collect();
    let dot = |a: &Coords, b: &Coords| -> f64 { (0..3).map(|k| a[k] * b[k]).sum() };
    let mut point = *scaled.first()?;
    for _ in 0..STEPS {
        let lowest = scaled.iter().min_by(|a, b| dot(a, &point).total_cmp(&dot(b, &point)))?;
        let way: Coords = core::array::from_fn(|k| lowest[k] - point[k]);
        let square = dot(&way, &way);
        let gain = -dot(&point, &way);
        if square == 0.0 || gain <= 1e-12 * dot(&point, &point).max(NONE) {
            break;
        }
        let share = (gain / square).min(1.0);
        point = core::array::from_fn(|k| point[k] + way[k] * share);
    }
    let length = dot(&point, &point).sqrt();
    (length > NONE).then(|| {
        core::array::from_fn(|k| {
            if levers[k] > 0.0 {
                point[k] / (length * levers[k])
            } else {
                0.0
            }
        })
    })
}

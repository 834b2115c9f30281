//! Legs of limited turn and travel.

use crate::legs::Coords;
use crate::route::along;

/// A path of more legs is of no use to anybody, and would take the memory.
pub(crate) const MOST_LEGS: f64 = 1e6;

/// Divides the legs of a path evenly, so that none changes a coordinate by more than its step. `None` if these are more than
/// [`MOST_LEGS`].
pub(crate) fn divided(places: &[Coords], steps: Coords) -> Option<Vec<Coords>> {
    let parts = |leg: &[Coords]| {
        (0..3)
            .map(|k| ((leg[1][k] - leg[0][k]).abs() / steps[k]).ceil())
            .fold(1.0, f64::max)
    };
    if places.windows(2).map(parts).sum::<f64>() > MOST_LEGS {
        return None;
    }
    let mut all: Vec<Coords> = places.first().copied().into_iter().collect();
    for leg in places.windows(2) {
        let (from, to) = (leg[0], leg[1]);
        let parts = parts(leg);
        let count = parts as usize;
        all.extend((1..count).map(|i| along(from, to, i as f64 / parts)));
        all.push(to);
    }
    Some(all)
}

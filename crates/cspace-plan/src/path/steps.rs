//! Legs of limited turn and travel.

use crate::legs::Coords;
use crate::route::along;

/// The same path with legs divided evenly, so that none changes a coordinate by more than its step.
pub(crate) fn divided(places: &[Coords], steps: Coords) -> Vec<Coords> {
    let mut all: Vec<Coords> = places.first().copied().into_iter().collect();
    for leg in places.windows(2) {
        let (from, to) = (leg[0], leg[1]);
        let parts = (0..3)
            .map(|k| ((to[k] - from[k]).abs() / steps[k]).ceil())
            .fold(1.0, f64::max);
        let count = parts as usize;
        all.extend((1..count).map(|i| along(from, to, i as f64 / parts)));
        all.push(to);
    }
    all
}

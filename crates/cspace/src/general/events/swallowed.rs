//! Short curves that pass through another curve with all their length, within one cluster of events.
//!
//! Both ends of the short curve then pass the other at orientations that cannot be told apart: there is no crossing before and none after,
//! and what was in front of the other curve is behind it. Its cells must not be continued past the cluster.

use crate::contact::{Curve, Exact, Geometry, Orientation};
use crate::geometry::Point;

use crate::general::events::clusters::Clusters;

/// The sheet, of two whose curves do not cross just below and just above a cluster, that is on different sides of the other below and
/// above: all of it has passed through in between.
pub(crate) fn swallowed(
    geometry: &Geometry,
    clusters: &Clusters,
    (f, g): (u32, u32),
    at: u32,
) -> Option<u32> {
    let (below, above) = clusters.exactly_beside(at);
    let turns = [below, above].map(Orientation::by);
    let placed = |sheet: u32| [0, 1].map(|k: usize| geometry.curve(sheet, &turns[k]));
    [(f, g), (g, f)]
        .into_iter()
        .find(|&(short, long)| {
            let middles = placed(short).map(|c| c.point(Exact::ZERO));
            is_passed(&placed(long), middles)
        })
        .map(|pair| pair.0)
}

/// Whether a curve passes a point that is beside it at both orientations.
fn is_passed(curve: &[Curve<Exact>; 2], point: [Point<Exact>; 2]) -> bool {
    let sides = [0, 1].map(|k: usize| curve[k].is_free(point[k]));
    matches!(sides, [Some(a), Some(b)] if a != b)
}

//! Curves that face each other and pass through each other along a piece, within one cluster of events.
//!
//! Two opposite sides of a pocket that closes may be lines, which coincide along a piece (`levels.rs`), or nearly so, as where one of them
//! is slightly bowed. Then they cross, but the crossing runs through the whole piece while the orientation changes by less than can be
//! resolved, so that there is no crossing before and none after. The piece that was in front of the other curve is then behind it: a cell
//! there must not be continued.

use crate::contact::{Curve, Exact, Geometry, Orientation};
use crate::geometry::Point;

use crate::general::events::clusters::Clusters;

/// A sheet of which a piece has come behind another sheet, within a cluster.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Pinch {
    pub(crate) sheet: u32,
    pub(crate) at: u32,
    pub(crate) other: u32,
}

/// Pinches of a sheet at a cluster, from a sorted list.
pub(crate) fn pinches_of(all: &[Pinch], sheet: u32, at: u32) -> &[Pinch] {
    let from = all.partition_point(|p| (p.sheet, p.at) < (sheet, at));
    let count = all[from..].partition_point(|p| (p.sheet, p.at) == (sheet, at));
    &all[from..from + count]
}

/// Whether, of two sheets that do not cross just below and just above a cluster, one comes behind the other in the range where both exist.
pub(crate) fn pinched(
    geometry: &Geometry,
    sheets: (u32, u32),
    beside: &[Orientation<Exact>; 2],
) -> bool {
    let [f, g] = [sheets.0, sheets.1].map(|s| placed(geometry, s, beside));
    let passes = |f: &[Curve<Exact>; 2], g: &[Curve<Exact>; 2], end: usize| {
        let p = f.map(|c| [c.start, c.end][end]);
        let [m, n] = [f, g].map(|c| c[0].normal(p[0]));
        let opposite = m.dot(n).is_negative();
        opposite && is_passed(g, p)
    };
    [0, 1]
        .into_iter()
        .any(|end| passes(&f, &g, end) || passes(&g, &f, end))
}

/// The sheet, of two whose curves do not cross just below and just above a cluster, that is on different sides of the other below and
/// above: all of it has passed through in between.
pub(crate) fn swallowed(
    geometry: &Geometry,
    (f, g): (u32, u32),
    beside: &[Orientation<Exact>; 2],
) -> Option<u32> {
    [(f, g), (g, f)]
        .into_iter()
        .find(|&(short, long)| {
            let [short, long] = [short, long].map(|s| placed(geometry, s, beside));
            is_passed(&long, short.map(|c| c.point(Exact::ZERO)))
        })
        .map(|pair| pair.0)
}

impl Pinch {
    /// Whether a place of the sheet's curve comes behind the other sheet, or out from behind it.
    pub(crate) fn moves(&self, geometry: &Geometry, clusters: &Clusters, place: f64) -> bool {
        let beside = turns_beside(clusters, self.at);
        let [f, g] = [self.sheet, self.other].map(|s| placed(geometry, s, &beside));
        is_passed(&g, f.map(|c| c.point(Exact::from(place))))
    }
}

/// Orientations just below and just above a cluster.
pub(crate) fn turns_beside(clusters: &Clusters, at: u32) -> [Orientation<Exact>; 2] {
    let (below, above) = clusters.exactly_beside(at);
    [below, above].map(Orientation::by)
}

/// The curves of a sheet at two orientations.
fn placed(geometry: &Geometry, sheet: u32, turns: &[Orientation<Exact>; 2]) -> [Curve<Exact>; 2] {
    [0, 1].map(|k: usize| geometry.curve(sheet, &turns[k]))
}

/// Whether a curve passes a point that is beside it at both orientations.
fn is_passed(curve: &[Curve<Exact>; 2], point: [Point<Exact>; 2]) -> bool {
    let sides = [0, 1].map(|k: usize| curve[k].is_free(point[k]));
    matches!(sides, [Some(a), Some(b)] if a != b)
}

//! Curves that face each other and pass each other along a piece, within one cluster of events.
//!
//! Two opposite sides of a pocket that closes are lines, and become one all along (`levels.rs`); or nearly so, as where one of
//! them is slightly bowed. Then they cross, but the crossing runs through all that faces each other while the orientation changes
//! by less than is told apart, so that there is none before and none after. What was in front of the other curve is behind it
//! then: a cell that is there does not go on.

use crate::contact::{Curve, CurveShape, Geometry};
use crate::geometry::{Point, Rotation};

use super::clusters::Clusters;

/// A sheet of which some has come behind another sheet, within a cluster.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Pinch {
    pub(super) sheet: u32,
    pub(super) at: u32,
    pub(super) other: u32,
}

/// Those of a sheet at a cluster, of a sorted list.
pub(super) fn pinches_of(all: &[Pinch], sheet: u32, at: u32) -> &[Pinch] {
    let from = all.partition_point(|p| (p.sheet, p.at) < (sheet, at));
    let count = all[from..].partition_point(|p| (p.sheet, p.at) == (sheet, at));
    &all[from..from + count]
}

/// Whether of two sheets that do not cross just below and just above a cluster one comes behind the other where both are.
pub(super) fn pinched(geometry: &Geometry, sheets: (u32, u32), beside: (f64, f64)) -> bool {
    let [f, g] = [sheets.0, sheets.1].map(|s| placed(geometry, s, beside));
    let passes = |f: &[Curve; 2], g: &[Curve; 2], of: fn(&Curve) -> Point| {
        let opposite = f[0].normal(of(&f[0])).dot(g[0].normal(of(&f[0]))) < 0.0;
        opposite && is_passed(g, [of(&f[0]), of(&f[1])])
    };
    let ends: [fn(&Curve) -> Point; 2] = [|c| c.start, |c| c.end];
    ends.into_iter()
        .any(|end| passes(&f, &g, end) || passes(&g, &f, end))
}

impl Pinch {
    /// Whether a place of the sheet's curve comes behind the other sheet, or out from behind it.
    pub(super) fn moves(&self, geometry: &Geometry, clusters: &Clusters, place: f64) -> bool {
        let beside = clusters.just_beside(self.at);
        let [f, g] = [self.sheet, self.other].map(|s| placed(geometry, s, beside));
        is_passed(&g, [f[0].point(place), f[1].point(place)])
    }
}

/// A sheet's curves just below and just above a cluster.
pub(super) fn placed(geometry: &Geometry, sheet: u32, beside: (f64, f64)) -> [Curve; 2] {
    [beside.0, beside.1]
        .map(|theta| geometry.contacts.sheets[sheet as usize].curve(theta, Rotation::by(theta)))
}

/// Whether a curve passes a point that is beside it before and after.
pub(super) fn is_passed(curve: &[Curve; 2], point: [Point; 2]) -> bool {
    let side = |curve: &Curve, p: Point| {
        let off = match curve.shape {
            CurveShape::Line { normal } => normal.dot(p - curve.start),
            CurveShape::Circle { center, radius, .. } => center.distance(p) - radius.abs(),
            CurveShape::Bow(bow) => bow.distance(p),
        };
        (curve.position(p).abs() < curve.half_length()).then_some(off > 0.0)
    };
    let sides = [0, 1].map(|k| side(&curve[k], point[k]));
    matches!(sides, [Some(a), Some(b)] if a != b)
}

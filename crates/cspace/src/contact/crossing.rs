//! Crossings of two contact curves of one slice.

use crate::feature::tolerance::WIDEST_ARC;
use crate::geometry::Point;
use crate::number::{Dd, Ordered};

use super::curve::Curve;
use super::cycle::Cycle;

/// Numbers in which crossings are computed.
pub(crate) trait Crossed: Ordered {
    /// Sine of the angle between two lines below which they are parallel.
    const PARALLEL: f64;
}

impl Crossed for f64 {
    /// The place where lines cross is off by the rounding of their normals, 2⁻⁵², divided by the sine: at this angle by 1/512 of its
    /// distance.
    const PARALLEL: f64 = 1.0 / (1u64 << 43) as f64;
}

impl Crossed for Dd {
    const PARALLEL: f64 = 1e-28;
}

/// A crossing of the lines or circles of two contact curves f and g.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Crossing<T = f64> {
    pub(crate) point: Point<T>,
    /// Whether travel along f enters the blocked side of g there (then g leaves the blocked side of f).
    pub(crate) enters: bool,
}

/// The crossing with the given name ([`Cycle::enters`](super::cycle::Cycle::enters)), anywhere on the lines or circles; for large circles
/// only near the parts. Lines at an angle below [`Crossed::PARALLEL`] do not cross, whatever their rounding.
pub(crate) fn crossing<T: Crossed>(f: &Curve<T>, g: &Curve<T>, root: u8) -> Option<Crossing<T>> {
    let (mut c, d) = (f.cycle, &g.cycle);
    // The line is written from the end nearer to the other curve, so that a crossing near an end is accurate.
    if c.is_line() && d.level(f.end).abs() <= d.level(f.start).abs() {
        c.through = f.end;
    }
    let (place, enters) = c.crossing(d, root, T::PARALLEL)?;
    let point = c.at(place);
    let large = [&c, d].into_iter().find(|cycle| cycle.is_large());
    let is_near =
        |cycle: &Cycle<T>| (cycle.place(point).x * cycle.weight).value().abs() < WIDEST_ARC;
    large
        .is_none_or(is_near)
        .then_some(Crossing { point, enters })
}

/// For each root, whether two curves cross there between their ends, and if so whether the first enters. `corners` states whether the
/// curves share a corner where the first ends, and where it starts: this does not count as a crossing.
pub(crate) fn crossings<T: Crossed>(
    f: &Curve<T>,
    g: &Curve<T>,
    corners: [bool; 2],
) -> [Option<bool>; 2] {
    let mut found = [0, 1].map(|root| crossing(f, g, root));
    for (shared, p) in corners.into_iter().zip([f.end, f.start]) {
        if shared {
            let distance =
                |c: &Option<Crossing<T>>| c.map_or(f64::INFINITY, |c| c.point.distance(p).value());
            let nearest = usize::from(distance(&found[1]) < distance(&found[0]));
            found[nearest] = None;
        }
    }
    let is_on = |curve: &Curve<T>, p: Point<T>| curve.holds(curve.cycle.place(p));
    found.map(|c| {
        c.filter(|c| is_on(f, c.point) && is_on(g, c.point))
            .map(|c| c.enters)
    })
}

#[cfg(test)]
mod tests;

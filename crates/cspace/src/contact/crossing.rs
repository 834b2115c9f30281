//! Where two contact curves of one slice cross.

use crate::feature::tolerance::{SAME_CARRIER, WIDEST_ARC};
use crate::geometry::Point;

use super::curve::Curve;
use super::cycle::Cycle;

/// A crossing of the lines or circles of two contact curves f and g.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Crossing {
    pub(crate) point: Point,
    /// Whether travel along f enters the blocked side of g there (then g leaves that of f).
    pub(crate) enters: bool,
}

/// The crossing with the given name ([`Cycle::enters`](super::cycle::Cycle::enters)), wherever it lies on the lines or circles; of
/// large circles only near the parts. Lines at an angle below [`SAME_CARRIER`] do not cross, whatever rounding makes of them.
pub(crate) fn crossing(f: &Curve, g: &Curve, root: u8) -> Option<Crossing> {
    let (mut c, d) = (f.cycle, &g.cycle);
    // From the end of a line that is nearer to the other, so that a crossing near an end is accurate.
    if c.is_line() && d.level(f.end).abs() <= d.level(f.start).abs() {
        c.through = f.end;
    }
    let (place, enters) = c.crossing(d, root, SAME_CARRIER)?;
    let point = c.at(place);
    let large = [&c, d].into_iter().find(|cycle| cycle.is_large());
    let is_near = |cycle: &Cycle| (cycle.place(point).x * cycle.weight).abs() < WIDEST_ARC;
    large
        .is_none_or(is_near)
        .then_some(Crossing { point, enters })
}

#[cfg(test)]
mod tests;

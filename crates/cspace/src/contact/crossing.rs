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
    let (c, d) = (&f.cycle, &g.cycle);
    let named = root == 0 || !(c.is_line() && d.is_line());
    if !named || !c.meets(d, SAME_CARRIER) {
        return None;
    }
    let enters = c.enters(d, root);
    let point = c.at(c.crossed_by(d, enters));
    let large = [c, d]
        .into_iter()
        .find(|cycle| !(cycle.is_centred() || cycle.is_line()));
    let is_near = |cycle: &Cycle| (cycle.place(point).x * cycle.weight).abs() < WIDEST_ARC;
    large
        .is_none_or(is_near)
        .then_some(Crossing { point, enters })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;

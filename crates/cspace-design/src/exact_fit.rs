//! Requirements at configurations at which the parts fit exactly, nominal on nominal.
//!
//! They touch and do not overlap, and their contact space has no room there. What they can do is measured with the moving part smaller by
//! a gap g, and by half of it: 2 f(g/2) − f(g) is f(0) but for a square of the gap, which is below what contacts are known to.

use cspace::{Coordinates, PairSpace, Silent};
use cspace_model::model::{Coordinate, Quantity};
use cspace_plan::with_room;

use crate::measure::measure;
use crate::value::{Measured, Unmeasured, Value};

/// A play is ended by the fit at once where it is below this many gaps.
const AT_ONCE: f64 = 64.0;

/// Measures a quantity where the parts fit exactly, with the gap that was taken.
pub(crate) fn measured(space: &PairSpace, quantity: &Quantity) -> Result<Measured, Unmeasured> {
    let first = measure(space, quantity);
    if first != Err(Unmeasured::Blocked) {
        return first;
    }
    let at = at(quantity);
    let Ok(Some((roomy, gap))) = with_room(space, at, &Silent) else {
        return Err(Unmeasured::Blocked);
    };
    if let Quantity::Clearance { .. } | Quantity::Bottleneck { .. } = quantity {
        // The way begins without any, if there is one.
        let mut found = measure(&roomy[0], quantity)?;
        found.value = Value::Number(0.0);
        found.gap = Some(gap);
        return Ok(found);
    }
    let [whole, half] = [measure(&roomy[0], quantity)?, measure(&roomy[1], quantity)?];
    let without = |whole: f64, half: f64| 2.0 * half - whole;
    let mut found = whole;
    if let (Value::Number(a), Value::Number(b)) = (found.value, half.value) {
        found.value = Value::Number(without(a, b));
    }
    found.range =
        (found.range.zip(half.range)).map(|(a, b)| (without(a.0, b.0), without(a.1, b.1)));
    if let (Quantity::Play { of, at }, Some(range)) = (quantity, found.range) {
        let now = of.of(*at).ok_or(Unmeasured::Blocked)?;
        let lever = match of {
            Coordinate::X | Coordinate::Y => 1.0,
            // A length or an angle: the larger count of gaps.
            _ => roomy[0].moving().size().min(1.0),
        };
        let end = |end: f64| match (end - now).abs() * lever <= AT_ONCE * gap {
            true => now,
            false => end,
        };
        let range = (end(range.0), end(range.1));
        found.range = Some(range);
        found.value = Value::Number(range.1 - range.0);
    }
    found.gap = Some(gap);
    Ok(found)
}

/// The configuration at which a quantity is measured.
fn at(quantity: &Quantity) -> Coordinates {
    match *quantity {
        Quantity::Play { at, .. }
        | Quantity::Clearance { at }
        | Quantity::Angle { at, .. }
        | Quantity::Bottleneck { at, .. }
        | Quantity::Extreme { at, .. }
        | Quantity::Caged { at }
        | Quantity::Fits { at, .. }
        | Quantity::Ranges { at, .. }
        | Quantity::Connected { at, .. } => at,
        Quantity::Position { from, .. } => from,
    }
}

//! Requirements at configurations at which the parts fit exactly, nominal on nominal.
//!
//! They touch and do not overlap, and their contact space has no room there. What they can do is measured with the moving part smaller by a
//! gap, but for a play that the fit ends at once, which is 0.

use cspace::{Coordinates, PairSpace, Silent};
use cspace_io::model::{Coordinate, Quantity};
use cspace_plan::with_room;

use crate::measure::{Measured, Unmeasured, Value, free_range, measure};

/// A play is ended by the fit where it is below this many gaps.
const AT_ONCE: f64 = 64.0;

/// Measures a quantity; where the parts fit exactly, with the gap that was taken.
pub(crate) fn measured(
    space: &PairSpace,
    quantity: &Quantity,
) -> Result<(Measured, Option<f64>), Unmeasured> {
    let first = measure(space, quantity);
    if first != Err(Unmeasured::Blocked) {
        return first.map(|measured| (measured, None));
    }
    let at = at(quantity);
    let Ok(Some((roomy, gap))) = with_room(space, at, &Silent) else {
        return Err(Unmeasured::Blocked);
    };
    let found = match *quantity {
        Quantity::Play { of, at } => play(&roomy, of, at, gap)?,
        Quantity::Clearance { .. } => Measured::number(0.0),
        _ => measure(&roomy, quantity)?,
    };
    Ok((found, Some(gap)))
}

/// A play of parts with a gap between them, without it.
fn play(
    roomy: &PairSpace,
    of: Coordinate,
    at: Coordinates,
    gap: f64,
) -> Result<Measured, Unmeasured> {
    let now = of.of(at).ok_or(Unmeasured::Blocked)?;
    let lever = match (of, roomy) {
        (Coordinate::X | Coordinate::Y, _) => 1.0,
        (Coordinate::Theta, _) => roomy.moving().size(),
        // On axes a coordinate may be a length or an angle: the larger count of gaps.
        _ => 1.0_f64.min(roomy.moving().size()),
    };
    let [Some((lo, first)), Some((hi, second))] = free_range(roomy, of, at)? else {
        return Err(Unmeasured::Unlimited);
    };
    let end = |end: f64| match (end - now).abs() * lever <= AT_ONCE * gap {
        true => now,
        false => end,
    };
    let (lo, hi) = (end(lo), end(hi));
    Ok(Measured {
        value: Value::Number(hi - lo),
        range: Some((lo, hi)),
        stops: vec![first, second],
    })
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
        | Quantity::Connected { at, .. } => at,
        Quantity::Position { from, .. } => from,
    }
}

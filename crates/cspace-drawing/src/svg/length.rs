//! Lengths in SVG.

use core::str::FromStr;

use svgtypes::{Length, LengthUnit};

use crate::drawing::Unit;

/// A length in user units, of which an inch has 96. None of one that is relative to a font or a frame, or is no number.
pub(super) fn user_units(text: &str) -> Option<f64> {
    let (number, unit) = physical(text)?;
    Some(match unit {
        None => number,
        Some(unit) => number * unit.millimetres() / Unit::Pixel.millimetres(),
    })
}

/// A length in the unit it is written in; none where it is in user units.
pub(super) fn physical(text: &str) -> Option<(f64, Option<Unit>)> {
    let length = Length::from_str(text.trim()).ok()?;
    let number = length.number;
    let (number, unit) = match length.unit {
        LengthUnit::None => (number, None),
        LengthUnit::Px => (number, Some(Unit::Pixel)),
        LengthUnit::Mm => (number, Some(Unit::Millimetre)),
        LengthUnit::Cm => (number, Some(Unit::Centimetre)),
        LengthUnit::In => (number, Some(Unit::Inch)),
        LengthUnit::Pt => (number / 72.0, Some(Unit::Inch)),
        LengthUnit::Pc => (number / 6.0, Some(Unit::Inch)),
        _ => return None,
    };
    number.is_finite().then_some((number, unit))
}

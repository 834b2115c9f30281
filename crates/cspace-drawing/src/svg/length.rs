//! Lengths in SVG.

use core::str::FromStr;

use roxmltree::Node;
use svgtypes::{Length, LengthUnit, ViewBox};

use crate::unit::Unit;

/// Frame of percentages: the innermost surrounding view box, in its own coordinates. Unknown sides are `None`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct View {
    pub(super) width: Option<f64>,
    pub(super) height: Option<f64>,
}

/// The side of the frame that a percentage is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Along {
    Width,
    Height,
    /// The diagonal, divided by √2: that of a square is its side.
    Diagonal,
}

impl View {
    /// The sides of a view box.
    pub(super) fn of(view: ViewBox) -> Self {
        Self {
            width: Some(view.w),
            height: Some(view.h),
        }
    }

    /// Length given by an attribute, in user units; `None` if it is missing, or `auto`.
    ///
    /// # Errors
    /// If it is not a length, or relative to a font or to an unknown side.
    pub(super) fn length(self, node: Node<'_, '_>, name: &str) -> Result<Option<f64>, String> {
        let Some(text) = node.attribute(name).filter(|t| t.trim() != "auto") else {
            return Ok(None);
        };
        let along = match name {
            "x" | "cx" | "rx" | "x1" | "x2" | "width" => Along::Width,
            "y" | "cy" | "ry" | "y1" | "y2" | "height" => Along::Height,
            _ => Along::Diagonal,
        };
        let length = match percent(text) {
            Some(share) => self.side(along).map(|side| share / 100.0 * side),
            None => user_units(text),
        };
        length.filter(|l| l.is_finite()).map(Some).ok_or_else(|| {
            let text: String = text.chars().take(40).collect();
            format!("{name} is {text:?}, no length that can be told without a font or frame")
        })
    }

    fn side(self, along: Along) -> Option<f64> {
        match along {
            Along::Width => self.width,
            Along::Height => self.height,
            Along::Diagonal => {
                let (width, height) = (self.width?, self.height?);
                Some(width.hypot(height) / core::f64::consts::SQRT_2)
            }
        }
    }
}

/// The number of a percentage.
fn percent(text: &str) -> Option<f64> {
    let length = Length::from_str(text.trim()).ok()?;
    (length.unit == LengthUnit::Percent).then_some(length.number)
}

/// Length in user units, 96 to the inch. `None` if it is relative to a font or a frame, or not a number.
pub(super) fn user_units(text: &str) -> Option<f64> {
    let (number, unit) = physical(text)?;
    Some(match unit {
        None => number,
        Some(unit) => number * unit.ratio(Unit::Pixel),
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

//! Conversion of points and vectors to pairs of numbers, and to text.

use core::fmt;

use super::{Point, Vector};

/// Writes `(a, b, …)` with the formatter's precision for each number, the last with its unit.
pub(super) fn write_numbers(
    f: &mut fmt::Formatter<'_>,
    numbers: &[f64],
    unit: &str,
) -> fmt::Result {
    f.write_str("(")?;
    for (i, number) in numbers.iter().enumerate() {
        if i > 0 {
            f.write_str(", ")?;
        }
        fmt::Display::fmt(number, f)?;
    }
    f.write_str(unit)?;
    f.write_str(")")
}

/// Text `(x, y)`; a precision such as `{:.3}` applies to each number.
impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_numbers(f, &[self.x, self.y], "")
    }
}

impl From<(f64, f64)> for Point {
    #[inline]
    fn from((x, y): (f64, f64)) -> Self {
        Self::new(x, y)
    }
}

impl From<[f64; 2]> for Point {
    #[inline]
    fn from([x, y]: [f64; 2]) -> Self {
        Self::new(x, y)
    }
}

impl From<Point> for (f64, f64) {
    #[inline]
    fn from(p: Point) -> Self {
        (p.x, p.y)
    }
}

impl From<Point> for [f64; 2] {
    #[inline]
    fn from(p: Point) -> Self {
        [p.x, p.y]
    }
}

/// Text `(x, y)`; a precision such as `{:.3}` applies to each number.
impl fmt::Display for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_numbers(f, &[self.x, self.y], "")
    }
}

impl From<(f64, f64)> for Vector {
    #[inline]
    fn from((x, y): (f64, f64)) -> Self {
        Self::new(x, y)
    }
}

impl From<[f64; 2]> for Vector {
    #[inline]
    fn from([x, y]: [f64; 2]) -> Self {
        Self::new(x, y)
    }
}

impl From<Vector> for (f64, f64) {
    #[inline]
    fn from(p: Vector) -> Self {
        (p.x, p.y)
    }
}

impl From<Vector> for [f64; 2] {
    #[inline]
    fn from(p: Vector) -> Self {
        [p.x, p.y]
    }
}

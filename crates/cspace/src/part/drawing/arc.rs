//! Bulges of arcs from the data that drawings give: the centre, the radius, or a point on the arc.
//!
//! All functions give tan(sweep / 4), positive counter-clockwise, from the two ends. Only differences of points are used, so that the
//! accuracy does not depend on where the arc is drawn.

use crate::geometry::{Point, Vector};
use crate::number::Real;
use crate::part::tolerance::{FULL_BULGE, RESOLUTION};

/// Largest difference of the distances of a centre from the two ends of its arc, as a fraction of the longer distance.
///
/// Drawings give centres in decimals, often six of them. The arc goes exactly through its ends, and its centre is the nearest place equally
/// far from both.
pub const CENTER_TOLERANCE: f64 = 1e-6;

/// Largest excess of a chord over the diameter of its arc, as a fraction, at which the arc is a half circle.
///
/// Half circles are drawn with a radius and ends that were rounded separately, to some six decimals.
pub const CHORD_TOLERANCE: f64 = 1e-6;

/// Rounding of the ratio of a chord to the diameter of its arc.
const HALF_TURN: f64 = 4.0 * f64::EPSILON;

/// Direction in which an arc turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Direction {
    /// To the left: positive bulge.
    CounterClockwise,
    /// To the right: negative bulge.
    Clockwise,
}

/// Choice between the two arcs of one radius, direction and ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum ArcSize {
    /// The arc of at most half a turn.
    Short,
    /// The arc of at least half a turn.
    Long,
}

/// Reasons for which an arc cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ArcError {
    /// A coordinate is not a finite number.
    #[error("a coordinate is not a finite number: give numbers for x and y")]
    NotFinite,
    /// The arc ends where it starts.
    #[error("the arc ends where it starts: draw a full circle as two half circles")]
    NoChord,
    /// A radius is not a positive number.
    #[error("the radius is {radius:?}: give a positive number")]
    BadRadius {
        /// The radius.
        radius: f64,
    },
    /// The ends are farther apart than the diameter.
    #[error(
        "the radius {radius:?} is too small, for the ends are {chord:?} apart: give at least {:?}, or move the ends together",
        0.5 * chord
    )]
    RadiusTooSmall {
        /// The radius.
        radius: f64,
        /// The distance of the ends.
        chord: f64,
    },
    /// The centre is nearer to one end than to the other.
    #[error(
        "the centre is {from_start:?} from the arc's start and {from_end:?} from its end, which differ by more than {CENTER_TOLERANCE:e} of the longer: move the centre to where both are equal"
    )]
    OffCenter {
        /// The distance of the centre from the start.
        from_start: f64,
        /// The distance of the centre from the end.
        from_end: f64,
    },
    /// No arc passes through the point: it is an end, or on the line of the ends but not between them.
    #[error(
        "no arc from ({:?}, {:?}) to ({:?}, {:?}) goes through ({:?}, {:?}): give a point beside the line of the ends, or between them",
        start.x, start.y, end.x, end.y, through.x, through.y
    )]
    NotThrough {
        /// Start of the arc.
        start: Point,
        /// End of the arc.
        end: Point,
        /// The point.
        through: Point,
    },
}

impl Direction {
    /// The sign of the bulge: 1 or −1.
    #[inline]
    pub const fn sign(self) -> f64 {
        match self {
            Self::CounterClockwise => 1.0,
            Self::Clockwise => -1.0,
        }
    }
}

/// The bulge of the arc about a centre.
///
/// With h the height of the centre to the left of the chord and l half the chord's length, it is l / (h + √(h² + l²)) if counter-clockwise.
/// The centre may be nearer to one end by [`CENTER_TOLERANCE`].
///
/// # Errors
/// If a coordinate is not finite, the ends are one place, or the centre is not equally far from both.
///
/// ```
/// use cspace::part::{bulge_about, ArcError, Direction};
/// let bulge = bulge_about([1.0, 0.0], [0.0, 1.0], [0.0, 0.0], Direction::CounterClockwise)?;
/// assert!((bulge - (core::f64::consts::FRAC_PI_8).tan()).abs() < 1e-15);
/// # Ok::<(), ArcError>(())
/// ```
pub fn bulge_about<T: Real>(
    start: impl Into<Point<T>>,
    end: impl Into<Point<T>>,
    center: impl Into<Point<T>>,
    direction: Direction,
) -> Result<T, ArcError> {
    let (start, end, center) = (start.into(), end.into(), center.into());
    let (chord, length) = chord(start, end)?;
    let to_center = center - start;
    let (from_start, from_end) = (size(to_center).value(), size(center - end).value());
    if !(from_start.is_finite() && from_end.is_finite()) {
        return Err(ArcError::NotFinite);
    }
    if (from_start - from_end).abs() > CENTER_TOLERANCE * from_start.max(from_end) {
        return Err(ArcError::OffCenter {
            from_start,
            from_end,
        });
    }
    let sign = T::constant(direction.sign());
    let half = T::constant(0.5) * length;
    let height = sign * chord.unit().cross(to_center);
    let radius = height.hypot(half);
    let bulge = if height.value() >= 0.0 {
        half / (height + radius)
    } else {
        (radius - height) / half
    };
    checked(sign * bulge)
}

/// The bulge of the arc with a radius, which turns in a direction by at most or at least half a turn.
///
/// With s = chord / (2 radius) and c = √(1 − s²), s / (1 + c) for the short arc and (1 + c) / s for the long one. A chord
/// longer than the diameter by no more than [`CHORD_TOLERANCE`] gives a half circle.
///
/// # Errors
/// If a coordinate is not finite, the ends are one place, the radius is not positive, or less than half the chord.
///
/// ```
/// use cspace::part::{bulge_with_radius, ArcError, ArcSize, Direction};
/// let bulge = |r, size| bulge_with_radius([0.0, 0.0], [2.0, 0.0], r, Direction::Clockwise, size);
/// assert_eq!(bulge(1.0, ArcSize::Short)?, -1.0);
/// assert!((bulge(1.25, ArcSize::Short)? + 0.5).abs() < 1e-15);
/// assert!((bulge(1.25, ArcSize::Long)? + 2.0).abs() < 1e-15);
/// assert!(matches!(bulge(0.9, ArcSize::Short), Err(ArcError::RadiusTooSmall { .. })));
/// # Ok::<(), ArcError>(())
/// ```
pub fn bulge_with_radius<T: Real>(
    start: impl Into<Point<T>>,
    end: impl Into<Point<T>>,
    radius: T,
    direction: Direction,
    size: ArcSize,
) -> Result<T, ArcError> {
    let (_, length) = chord(start.into(), end.into())?;
    if !(radius.value().is_finite() && radius.value() > 0.0) {
        return Err(ArcError::BadRadius {
            radius: radius.value(),
        });
    }
    let real = T::constant;
    let ratio = real(0.5) * length / radius;
    if ratio.value() > 1.0 + CHORD_TOLERANCE {
        return Err(ArcError::RadiusTooSmall {
            radius: radius.value(),
            chord: length.value(),
        });
    }
    // A chord that equals the diameter up to rounding gives a half circle, with derivatives ignored.
    if ratio.value() > 1.0 - HALF_TURN {
        return checked(real(direction.sign()));
    }
    let sin = ratio;
    let cos = ((real(1.0) - sin) * (real(1.0) + sin)).sqrt();
    let bulge = match size {
        ArcSize::Short => sin / (real(1.0) + cos),
        ArcSize::Long => (real(1.0) + cos) / sin,
    };
    checked(real(direction.sign()) * bulge)
}

/// The bulge of the arc through a third point; 0, a line, if the point is between the ends on their line.
///
/// The directions from the start to the point and from the point to the end differ by half the sweep.
///
/// # Errors
/// If a coordinate is not finite, the ends are one place, or the point is an end or on their line but not between them.
///
/// ```
/// use cspace::part::{bulge_through, ArcError};
/// assert_eq!(bulge_through([-1.0, 0.0], [1.0, 0.0], [0.0, -1.0])?, 1.0);
/// assert_eq!(bulge_through([-1.0, 0.0], [1.0, 0.0], [0.5, 0.0])?, 0.0);
/// assert!(bulge_through([-1.0, 0.0], [1.0, 0.0], [2.0, 0.0]).is_err());
/// # Ok::<(), ArcError>(())
/// ```
pub fn bulge_through<T: Real>(
    start: impl Into<Point<T>>,
    end: impl Into<Point<T>>,
    through: impl Into<Point<T>>,
) -> Result<T, ArcError> {
    let (start, end, through) = (start.into(), end.into(), through.into());
    let (_, length) = chord(start, end)?;
    let none = ArcError::NotThrough {
        start: start.map(T::value),
        end: end.map(T::value),
        through: through.map(T::value),
    };
    if !through.map(T::value).is_finite() {
        return Err(ArcError::NotFinite);
    }
    let (to, on) = (through - start, end - through);
    if size(to).value().min(size(on).value()) <= RESOLUTION * length.value() {
        return Err(none);
    }
    // Only directions matter; scaled to about unit length, their products neither overflow nor underflow.
    let about_unit = |v: Vector<T>| v * T::constant(1.0 / v.x.value().abs().max(v.y.value().abs()));
    let (to, on) = (about_unit(to), about_unit(on));
    let (cos, sin) = (to.dot(on), to.cross(on));
    let both = sin.hypot(cos);
    let bulge = if cos.value() >= 0.0 {
        sin / (both + cos)
    } else {
        (both - cos) / sin
    };
    checked(bulge).map_err(|_| none)
}

/// The vector from the start of an arc to its end, and its length.
fn chord<T: Real>(start: Point<T>, end: Point<T>) -> Result<(Vector<T>, T), ArcError> {
    let chord = end - start;
    let length = size(chord);
    // Also if a difference overflows.
    if !length.value().is_finite() {
        return Err(ArcError::NotFinite);
    }
    if length.value() == 0.0 {
        return Err(ArcError::NoChord);
    }
    Ok((chord, length))
}

/// The length, also for vectors whose square overflows or underflows.
fn size<T: Real>(v: Vector<T>) -> T {
    v.x.hypot(v.y)
}

/// Checks a bulge: above the largest one an arc cannot be distinguished from a full circle, nor its ends from each other.
fn checked<T: Real>(bulge: T) -> Result<T, ArcError> {
    if bulge.value().abs() <= FULL_BULGE {
        Ok(bulge)
    } else {
        Err(ArcError::NoChord)
    }
}

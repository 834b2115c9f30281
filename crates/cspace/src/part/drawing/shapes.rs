//! Plain shapes: polygons, circles, rectangles and slots.
//!
//! Each comes as a loop, for a part that has other loops, and as a part of one loop.

use crate::geometry::Point;
use crate::number::Real;
use crate::part::tolerance::RESOLUTION;
use crate::part::{Part, PartError, Vertex};

/// The loop of lines from corner to corner, and from the last to the first.
///
/// ```
/// use cspace::part::polygon_loop;
/// let triangle = polygon_loop(&[(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)]);
/// assert_eq!((triangle.len(), triangle[1].bulge), (3, 0.0));
/// ```
pub fn polygon_loop<P: Copy + Into<Point>>(corners: &[P]) -> Vec<Vertex> {
    let corners = corners.iter().map(|&p| p.into());
    corners.map(|p: Point| Vertex::line(p.x, p.y)).collect()
}

/// The loop of a full circle: two vertices, each with a half circle.
///
/// # Errors
/// If the radius is not positive, or a number is not finite.
///
/// ```
/// use cspace::part::{circle_loop, polygon_loop, Part, PartError};
/// let plate = polygon_loop(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
/// let part = Part::new("plate with a hole", vec![plate, circle_loop([2.0, 2.0], 1.0)?])?;
/// assert!((part.area() - (16.0 - core::f64::consts::PI)).abs() < 1e-14);
/// # Ok::<(), PartError>(())
/// ```
pub fn circle_loop<T: Real>(
    center: impl Into<Point<T>>,
    radius: T,
) -> Result<Vec<Vertex<T>>, PartError> {
    let (c, half_turn) = (center.into(), T::constant(1.0));
    positive("radius", radius.value())?;
    Ok(vec![
        Vertex::new(c.x - radius, c.y, half_turn),
        Vertex::new(c.x + radius, c.y, half_turn),
    ])
}

/// The loop of a rectangle with sides along the axes, from its lower left corner.
///
/// # Errors
/// If the width or the height is not positive, or one is negligible compared with the other, or a number is not finite.
///
/// ```
/// use cspace::part::{rectangle_loop, PartError};
/// let corner = rectangle_loop([2.0, 1.0], 4.0, 2.0)?[0];
/// assert_eq!((corner.x, corner.y), (0.0, 0.0));
/// # Ok::<(), PartError>(())
/// ```
pub fn rectangle_loop(
    center: impl Into<Point>,
    width: f64,
    height: f64,
) -> Result<Vec<Vertex>, PartError> {
    let c = center.into();
    positive("width", width)?;
    positive("height", height)?;
    let size = width.hypot(height);
    thick("width", width, size)?;
    thick("height", height, size)?;
    let (x, y) = (0.5 * width, 0.5 * height);
    Ok(polygon_loop(&[
        (c.x - x, c.y - y),
        (c.x + x, c.y - y),
        (c.x + x, c.y + y),
        (c.x - x, c.y + y),
    ]))
}

/// The loop of all places within a radius of a line: two sides and two half circles.
///
/// # Errors
/// If the radius is not positive, the ends are one place, one is negligible compared with the other, or a number is not finite.
///
/// ```
/// use cspace::part::{slot_loop, PartError};
/// let slot = slot_loop([0.0, 0.0], [3.0, 0.0], 1.0)?;
/// assert_eq!((slot[0].x, slot[0].y, slot[0].bulge), (0.0, -1.0, 0.0));
/// # Ok::<(), PartError>(())
/// ```
pub fn slot_loop(
    from: impl Into<Point>,
    to: impl Into<Point>,
    radius: f64,
) -> Result<Vec<Vertex>, PartError> {
    let (from, to) = (from.into(), to.into());
    for (vertex_index, p) in [from, to].into_iter().enumerate() {
        if !p.is_finite() {
            return Err(PartError::BadCoordinate {
                loop_index: 0,
                vertex_index,
            });
        }
    }
    positive("radius", radius)?;
    let along = to - from;
    let length = along.x.hypot(along.y);
    positive("distance of the ends", length)?;
    let size = length + radius;
    thick("radius", radius, size)?;
    thick("distance of the ends", length, size)?;
    let aside = along.unit().left() * radius;
    let vertex = |p: Point, bulge| Vertex::new(p.x, p.y, bulge);
    Ok(vec![
        vertex(from - aside, 0.0),
        vertex(to - aside, 1.0),
        vertex(to + aside, 0.0),
        vertex(from + aside, 1.0),
    ])
}

impl Part {
    /// A polygon: lines from corner to corner, and from the last to the first, in either direction.
    ///
    /// # Errors
    /// As for [`Part::new`]: fewer than three corners, sides that meet, a number that is not finite.
    ///
    /// ```
    /// use cspace::{Part, PartError};
    /// let triangle = Part::polygon("triangle", &[(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)])?;
    /// assert_eq!(triangle.area(), 6.0);
    /// # Ok::<(), PartError>(())
    /// ```
    pub fn polygon<P: Copy + Into<Point>>(
        name: impl Into<String>,
        corners: &[P],
    ) -> Result<Self, PartError> {
        Self::new(name, vec![polygon_loop(corners)])
    }

    /// A disc.
    ///
    /// # Errors
    /// If the radius is not positive, and as for [`Part::new`].
    ///
    /// ```
    /// use cspace::{Part, PartError};
    /// let disc = Part::circle("disc", (0.0, 0.0), 2.0)?;
    /// assert!((disc.area() - 4.0 * core::f64::consts::PI).abs() < 1e-14);
    /// assert!(Part::circle("nothing", (0.0, 0.0), f64::NAN).is_err());
    /// # Ok::<(), PartError>(())
    /// ```
    pub fn circle(
        name: impl Into<String>,
        center: impl Into<Point>,
        radius: f64,
    ) -> Result<Self, PartError> {
        Self::new(name, vec![circle_loop(center, radius)?])
    }

    /// A rectangle with sides along the axes.
    ///
    /// # Errors
    /// If the width or the height is not positive, or one is negligible compared with the other, and as for [`Part::new`].
    ///
    /// ```
    /// use cspace::{Part, PartError, Point};
    /// let block = Part::rectangle("block", Point::ORIGIN, 3.0, 2.0)?;
    /// assert_eq!((block.area(), block.bounds().max.x), (6.0, 1.5));
    /// # Ok::<(), PartError>(())
    /// ```
    pub fn rectangle(
        name: impl Into<String>,
        center: impl Into<Point>,
        width: f64,
        height: f64,
    ) -> Result<Self, PartError> {
        Self::new(name, vec![rectangle_loop(center, width, height)?])
    }

    /// A slot, or stadium: all places within `radius` of the line from one point to another.
    ///
    /// # Errors
    /// If the radius is not positive, the ends are one place, or one is negligible compared with the other, and as for [`Part::new`].
    ///
    /// ```
    /// use cspace::{Part, PartError};
    /// let key = Part::slot("key", (0.0, 0.0), (3.0, 0.0), 1.0)?;
    /// assert!((key.area() - (6.0 + core::f64::consts::PI)).abs() < 1e-14);
    /// # Ok::<(), PartError>(())
    /// ```
    pub fn slot(
        name: impl Into<String>,
        from: impl Into<Point>,
        to: impl Into<Point>,
        radius: f64,
    ) -> Result<Self, PartError> {
        Self::new(name, vec![slot_loop(from, to, radius)?])
    }
}

fn positive(what: &'static str, value: f64) -> Result<(), PartError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(PartError::BadSize { what, value })
    }
}

/// Checks that a size is above the resolution of the whole, so that the error names the size instead of two vertices at one place.
fn thick(what: &'static str, value: f64, size: f64) -> Result<(), PartError> {
    let least = RESOLUTION * size;
    if value > least {
        Ok(())
    } else {
        Err(PartError::TooThin { what, value, least })
    }
}

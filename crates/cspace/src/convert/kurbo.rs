//! Points, arcs, circles and paths of `kurbo`.
//!
//! Paths of Bézier curves are read by `cspace-drawing` with its own feature of this name: it fits arcs to them within a tolerance.

use core::f64::consts::TAU;

use kurbo::{BezPath, Shape};

use crate::geometry::{Point, Vector};
use crate::part::{Edge, Loop, Part, PartError, circle_loop};

impl From<kurbo::Point> for Point {
    fn from(p: kurbo::Point) -> Self {
        Self::new(p.x, p.y)
    }
}

impl From<Point> for kurbo::Point {
    fn from(p: Point) -> Self {
        Self::new(p.x, p.y)
    }
}

impl From<kurbo::Vec2> for Vector {
    fn from(v: kurbo::Vec2) -> Self {
        Self::new(v.x, v.y)
    }
}

impl From<Vector> for kurbo::Vec2 {
    fn from(v: Vector) -> Self {
        Self::new(v.x, v.y)
    }
}

/// An elliptical arc that is no arc of a circle, or goes once around or more.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the arc has the radii {} and {} and turns by {} rad: only an arc of one radius that turns by less than a full circle is an edge",
    .0.radii.x, .0.radii.y, .0.sweep_angle
)]
pub struct NoCircle(kurbo::Arc);

/// The edge along an arc of a circle.
///
/// ```
/// use cspace::Edge;
/// let quarter = kurbo::Arc::new((0.0, 0.0), (2.0, 2.0), 0.0, core::f64::consts::FRAC_PI_2, 0.0);
/// let edge = Edge::try_from(quarter)?;
/// assert!((edge.radius() - 2.0).abs() < 1e-15 && (edge.bulge - 0.41421356).abs() < 1e-8);
/// # Ok::<(), cspace::convert::NoCircle>(())
/// ```
impl TryFrom<kurbo::Arc> for Edge {
    type Error = NoCircle;

    fn try_from(arc: kurbo::Arc) -> Result<Self, NoCircle> {
        let radius = arc.radii.x;
        // Equal as numbers: an ellipse, however near to a circle, is another curve.
        let is_circle = radius == arc.radii.y && radius > 0.0;
        if !(is_circle && arc.center.is_finite() && arc.sweep_angle.abs() < TAU) {
            return Err(NoCircle(arc));
        }
        let at = |angle: f64| {
            let (sin, cos) = (arc.x_rotation + arc.start_angle + angle).sin_cos();
            Point::new(arc.center.x + radius * cos, arc.center.y + radius * sin)
        };
        let bulge = (0.25 * arc.sweep_angle).tan();
        Ok(Self::between(at(0.0), at(arc.sweep_angle), bulge))
    }
}

impl Edge {
    /// The arc along the edge; `None` of a line.
    pub fn to_arc(&self) -> Option<kurbo::Arc> {
        if self.is_line() {
            return None;
        }
        let arm = self.start - self.center();
        let radii = (self.radius(), self.radius());
        let start = arm.y.atan2(arm.x);
        Some(kurbo::Arc::new(
            self.center(),
            radii,
            start,
            self.sweep(),
            0.0,
        ))
    }
}

impl Part {
    /// The disc of a circle.
    ///
    /// # Errors
    /// If the radius is not positive, or a number is not finite.
    ///
    /// ```
    /// use cspace::Part;
    /// let coin = Part::from_circle("coin", kurbo::Circle::new((1.0, 0.0), 2.0))?;
    /// assert!((coin.area() - 4.0 * core::f64::consts::PI).abs() < 1e-14);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn from_circle(name: impl Into<String>, circle: kurbo::Circle) -> Result<Self, PartError> {
        Self::new(name, vec![circle_loop(circle.center, circle.radius)?])
    }

    /// The outline as a path: lines, and arcs as cubic Bézier curves no farther than `tolerance` from them, a length. Each loop is closed.
    ///
    /// ```
    /// use cspace::Part;
    /// use kurbo::Shape;
    /// let slot = Part::slot("slot", [0.0, 0.0], [4.0, 0.0], 1.0)?;
    /// assert!((slot.to_bez_path(1e-9).area() - slot.area()).abs() < 1e-8);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn to_bez_path(&self, tolerance: f64) -> BezPath {
        let mut path = BezPath::new();
        for outline in self.loops() {
            append(&mut path, outline, tolerance);
        }
        path
    }
}

fn append(path: &mut BezPath, outline: &Loop, tolerance: f64) {
    for (i, edge) in outline.edges().enumerate() {
        if i == 0 {
            path.move_to(edge.start);
        }
        match edge.to_arc() {
            None => path.line_to(edge.end),
            Some(arc) => path.extend(arc.path_elements(tolerance).skip(1)),
        }
    }
    path.close_path();
}

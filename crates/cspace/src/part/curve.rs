//! An edge as a curve: its points, its box, its distance from a point.
//!
//! All formulas use the chord and the bulge b = tan(sweep / 4), never the centre, so that they keep
//! their accuracy when the radius is many times the chord.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::geometry::{Point, Rotation, Vector};

use super::tolerance::MAX_VERTICES;
use super::{Bounds, Edge};

/// |bulge| below which [`Edge::segment_area`] sums a series (dimensionless).
///
/// Above it, the closed form loses at most a factor b² ≥ 2⁻⁸ of its accuracy; below it, the first omitted term of the series is under
/// 10⁻¹⁷.
const SERIES_BULGE: f64 = 1.0 / 16.0;

impl Edge {
    /// The curve traversed backwards.
    #[inline]
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            start: self.end,
            end: self.start,
            bulge: -self.bulge,
            index: self.index,
        }
    }

    /// The point at fraction `u` of the length.
    ///
    /// ```
    /// use cspace::{Edge, Point};
    /// let (start, end) = (Point::new(-1.0, 0.0), Point::new(1.0, 0.0));
    /// let half_circle = Edge::between(start, end, 1.0);
    /// assert!(half_circle.at(0.5).distance(Point::new(0.0, -1.0)) < 1e-15);
    /// ```
    pub fn at(&self, u: f64) -> Point {
        if self.bulge == 0.0 {
            return self.start.lerp(self.end, u);
        }
        let half = 0.5 * u * self.sweep();
        let ratio = if half == 0.0 { 1.0 } else { half.sin() / half };
        self.start + Rotation::by(half) * self.start_direction() * (self.length() * u * ratio)
    }

    /// The start and points between it and the end, which is left out, with chords no farther than `tolerance` from the curve, a length: a
    /// chord of the angle a is r (1 − cos a/2) from its arc. No chord turns by more than a quarter, and there are at most [`MAX_VERTICES`].
    ///
    /// ```
    /// use cspace::{Edge, Point};
    /// let half_circle = Edge::between(Point::new(-1.0, 0.0), Point::new(1.0, 0.0), 1.0);
    /// assert_eq!(half_circle.points(0.3).count(), 2);
    /// ```
    pub fn points(&self, tolerance: f64) -> impl Iterator<Item = Point> + use<> {
        let half = (1.0 - (tolerance / self.radius()).min(1.0)).acos();
        let chords = self.sweep().abs() / (2.0 * half).min(FRAC_PI_2);
        // A line has no sweep, and one chord.
        let chords = chords.ceil().max(1.0).min(MAX_VERTICES as f64) as u32;
        let edge = *self;
        (0..chords).map(move |k| edge.at(f64::from(k) / f64::from(chords)))
    }

    /// The fraction of the length at which a point of the curve lies; for a point near the curve, that of a point about as near.
    ///
    /// As seen from the start, a point is in the direction of the edge half way to it.
    pub fn fraction_at(&self, p: Point) -> f64 {
        let (chord, way) = (self.end - self.start, p - self.start);
        if self.is_line() {
            return (chord.dot(way) / chord.length_squared()).clamp(0.0, 1.0);
        }
        let from = self.start_direction();
        let half = self.bulge.signum() * from.cross(way).atan2(from.dot(way));
        // Behind the start: the nearer end.
        if half < 0.0 {
            return if p.distance(self.start) <= p.distance(self.end) {
                0.0
            } else {
                1.0
            };
        }
        (2.0 * half / self.sweep().abs()).min(1.0)
    }

    /// The unit direction of travel at fraction `u` of the length.
    #[inline]
    pub fn direction_at(&self, u: f64) -> Vector {
        Rotation::by(u * self.sweep()) * self.start_direction()
    }

    /// The fraction of the length at which an arc's unit direction of travel is `direction`, or
    /// `None` where it never is; always `None` for a line.
    pub fn fraction_heading(&self, direction: Vector) -> Option<f64> {
        let sweep = self.sweep();
        if sweep == 0.0 {
            return None;
        }
        let from = self.start_direction();
        let turn = from.cross(direction).atan2(from.dot(direction)) * sweep.signum();
        let turn = if turn < 0.0 { turn + TAU } else { turn };
        let u = turn / sweep.abs();
        (u <= 1.0).then_some(u)
    }

    /// The smallest axis-aligned box that contains the curve.
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::of(self.start, self.end);
        if self.is_line() {
            return bounds;
        }
        // From the start, the arc rises along u by r (1 − cos φ) = r sin² φ / (1 + cos φ) after it has turned by φ to where it is
        // perpendicular to u; the form without cancellation is used.
        let rise = |u: Vector| {
            let heading = if self.bulge > 0.0 {
                u.left()
            } else {
                u.right()
            };
            self.fraction_heading(heading)?;
            let from = self.start_direction();
            let (cos, sin) = (from.dot(heading), from.cross(heading));
            let share = if cos > 0.0 {
                sin * sin / (1.0 + cos)
            } else {
                1.0 - cos
            };
            Some(self.radius() * share)
        };
        if let Some(rise) = rise(Vector::new(1.0, 0.0)) {
            bounds.max.x = bounds.max.x.max(self.start.x + rise);
        }
        if let Some(rise) = rise(Vector::new(0.0, 1.0)) {
            bounds.max.y = bounds.max.y.max(self.start.y + rise);
        }
        if let Some(rise) = rise(Vector::new(-1.0, 0.0)) {
            bounds.min.x = bounds.min.x.min(self.start.x - rise);
        }
        if let Some(rise) = rise(Vector::new(0.0, -1.0)) {
            bounds.min.y = bounds.min.y.min(self.start.y - rise);
        }
        bounds
    }

    /// The centre and radius of a disc that contains the curve: the centre is the middle of the chord; the radius is half the chord for
    /// arcs up to a half circle, and the height of larger arcs.
    pub(crate) fn disc(&self) -> (Point, f64) {
        let reach = 0.5 * self.chord() * self.bulge.abs().max(1.0);
        (
            self.start.midpoint(self.end),
            reach * (1.0 + 4.0 * f64::EPSILON),
        )
    }

    /// The distance from a point to the nearest point of the curve.
    ///
    /// ```
    /// use cspace::{Edge, Point};
    /// let (start, end) = (Point::new(-1.0, 0.0), Point::new(1.0, 0.0));
    /// let half_circle = Edge::between(start, end, 1.0);
    /// assert!((half_circle.distance(Point::new(0.0, -3.0)) - 2.0).abs() < 1e-15);
    /// assert!((half_circle.distance(Point::new(1.0, 3.0)) - 3.0).abs() < 1e-15);
    /// ```
    pub fn distance(&self, p: Point) -> f64 {
        let ends = p.distance(self.start).min(p.distance(self.end));
        if self.is_line() {
            let (c, q) = (self.end - self.start, p - self.start);
            let beside = self.covers_way(q);
            return if beside {
                c.cross(q).abs() / c.length()
            } else {
                ends
            };
        }
        self.nearest_of_circle(p)
            .map_or(ends, |(_, offset)| ends.min(offset.abs()))
    }

    /// The point of the curve that is nearest to a point; of equally near ends the end.
    pub fn nearest(&self, p: Point) -> Point {
        if self.is_line() {
            let (c, q) = (self.end - self.start, p - self.start);
            return self.start + c * (q.dot(c) / c.length_squared()).clamp(0.0, 1.0);
        }
        self.foot(p)
            .unwrap_or_else(|| match p.distance(self.start) < p.distance(self.end) {
                true => self.start,
                false => self.end,
            })
    }

    /// The place of an arc at which its normal passes through a point, if there is one on this side of the centre.
    pub(crate) fn foot(&self, p: Point) -> Option<Point> {
        self.nearest_of_circle(p).map(|(foot, _)| foot)
    }

    /// The nearest place of the arc's circle and the signed distance, positive to the left; `None` if it does not lie on the arc.
    fn nearest_of_circle(&self, p: Point) -> Option<(Point, f64)> {
        let curvature = self.curvature();
        let level = self.level(p) / (self.chord() * (1.0 + self.bulge * self.bulge));
        let gradient = self.start_direction().left() - (p - self.start) * curvature;
        let slope = gradient.length();
        let offset = 2.0 * level / (1.0 + slope);
        if slope == 0.0 {
            return None; // The arc's centre: all points of the arc are equally far.
        }
        let foot = p + gradient * (-offset / slope);
        self.covers(foot).then_some((foot, offset))
    }

    /// Level function of the line or circle of the edge: positive to the left, negative to the right.
    ///
    /// With chord c and q from the start to the point, (1 − b²) c × q + 2 b q · (c − q), which is
    /// chord (1 + b²) (n · q − κ q² / 2), n the left normal at the start and κ the curvature.
    #[inline]
    pub(crate) fn level(&self, p: Point) -> f64 {
        let (b, c, q) = (self.bulge, self.end - self.start, p - self.start);
        (1.0 - b) * (1.0 + b) * c.cross(q) + 2.0 * b * q.dot(c - q)
    }

    /// Whether a point of the edge's line or circle lies on the edge.
    pub(crate) fn covers(&self, p: Point) -> bool {
        self.covers_way(p - self.start)
    }

    /// Whether the point at a vector `q` from the start lies on the edge, given that it lies on the edge's line or circle.
    pub(crate) fn covers_way(&self, q: Vector) -> bool {
        let (b, c) = (self.bulge.abs(), self.end - self.start);
        let height = -self.bulge.signum() * c.cross(q);
        if (0.5..=2.0).contains(&b) {
            // The circle meets the chord at a wide angle: the arc is the part on its own side.
            return height >= 0.0;
        }
        let along = c.dot(q);
        let beside = 0.0 <= along && along <= c.length_squared();
        if b == 0.0 {
            return beside;
        }
        // A point of the circle is on an arc of less than half a turn if it is beside the chord, on the chord's side of the centre, which
        // is (1 − b²) / (4 b) chords from the chord. A longer arc is the rest of the circle.
        let center = (1.0 - b) * (1.0 + b) / (4.0 * b) * c.length_squared();
        if b < 1.0 {
            beside && height >= -center
        } else {
            !(beside && height <= -center)
        }
    }

    /// The signed area between chord and arc, positive for a counter-clockwise arc:
    /// chord² / 8 · ((1 + b²)² atan b − b (1 − b²)) / b².
    pub(crate) fn segment_area(&self) -> f64 {
        let b = self.bulge;
        let square = b * b;
        let shape = if b.abs() < SERIES_BULGE {
            let tail = 1.0 / 693.0 - square / 1287.0;
            let tail = 1.0 / 105.0 - square * (1.0 / 315.0 - square * tail);
            b * (1.0 / 3.0 + square * (1.0 / 15.0 - square * tail))
        } else {
            let q = 1.0 + square;
            (q * q * b.atan() - b * (1.0 - square)) / (8.0 * square)
        };
        (self.end - self.start).length_squared() * shape
    }
}

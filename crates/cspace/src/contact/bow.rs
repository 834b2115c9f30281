//! Circles much larger than the parts, as curves through a point near these.
//!
//! A circle with the curvature κ = 1/r through a point P with the unit normal n is n·d + κ d²/2 = 0 for the way d from P.
//! Nothing in it is large, so that a place on it is as exact as P is, however far away the centre. A line is one with κ = 0.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;

use super::carrier::{Carrier, dot, minus};
use super::spiral::{Spiral, turned};

/// A circle, or a line, through a point.
///
/// Places on it are told by a number u = 2/κ tan(φ/2) that grows with travel to the left of the normal, φ being the angle
/// about the centre from P: nearly the length, and for a line just that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bow<T> {
    pub(crate) through: (T, T),
    pub(crate) normal: (T, T),
    pub(crate) curvature: f64,
}

/// A carrier seen from a point: a·d + k d²/2 + c is zero on it and positive on its free side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Level<T> {
    pub(crate) a: (T, T),
    pub(crate) k: f64,
    pub(crate) c: T,
}

/// Bows are followed up to this angle about their centres, radians: what is near the parts is far below.
pub(crate) const WIDEST: f64 = 0.5;

impl<T: Real> Level<T> {
    /// A carrier as seen from a point; of a circle that is no bow it is multiplied with the radius.
    pub(crate) fn of(carrier: &Carrier<T>, from: (T, T)) -> Self {
        let real = T::constant;
        match *carrier {
            Carrier::Line { normal, through } => Self {
                a: normal,
                k: 0.0,
                c: -dot(normal, minus(through, from)),
            },
            Carrier::Bow(Bow {
                through,
                normal,
                curvature,
            }) => {
                let e = minus(through, from);
                let k = real(curvature);
                Self {
                    a: (normal.0 - k * e.0, normal.1 - k * e.1),
                    k: curvature,
                    c: k * real(0.5) * dot(e, e) - dot(normal, e),
                }
            }
            Carrier::Circle { center, radius } => {
                let e = minus(center, from);
                let side = radius.signum();
                let s = real(side);
                Self {
                    a: (-(s * e.0), -(s * e.1)),
                    k: side,
                    c: s * real(0.5) * (dot(e, e) - real(radius * radius)),
                }
            }
        }
    }
}

impl<T: Real> Bow<T> {
    /// The circle of a radius through a spiral, with a normal that turns or does not.
    #[cold]
    #[inline(never)]
    pub(super) fn of(
        through: &Spiral,
        normal: Vector,
        turns: bool,
        radius: f64,
        cos: T,
        sin: T,
    ) -> Self {
        let normal = if turns {
            turned(normal, cos, sin)
        } else {
            (T::constant(normal.x), T::constant(normal.y))
        };
        Self {
            through: through.place(cos, sin),
            normal,
            curvature: 1.0 / radius,
        }
    }

    /// The place at which another carrier is crossed, its blocked side being entered or left. Where the crossing is just
    /// lost, the nearest place to one.
    ///
    /// With d = (u t − κ u²/2 n) / (1 + κ²u²/4), the level of the other is ((k − κ a·n)/2 + c κ²/4) u² + a·t u + c over the
    /// same denominator; its derivative by u is negative where its blocked side is entered.
    pub(crate) fn crossing(&self, other: &Level<T>, enters: bool) -> T {
        let real = T::constant;
        let (n, kappa) = (self.normal, self.curvature);
        let along = (-n.1, n.0);
        let square = (real(other.k) - real(kappa) * dot(other.a, n)) * real(0.5)
            + other.c * real(0.25 * kappa * kappa);
        let slope = dot(other.a, along);
        let root = (slope * slope - real(4.0) * square * other.c).root();
        let steep = if enters { -root } else { root };
        // Of two forms that are equal the one in which nothing cancels.
        if enters == (slope.rough() < 0.0) {
            (real(-2.0) * other.c).over(slope + steep)
        } else {
            (steep - slope).over(real(2.0) * square)
        }
    }

    /// The way from the point it goes through to a place.
    pub(crate) fn way(&self, u: T) -> (T, T) {
        let real = T::constant;
        let n = self.normal;
        let half = u * real(0.5 * self.curvature);
        let t = u.over(real(1.0) + half * half);
        let fall = -(t * half);
        (fall * n.0 - t * n.1, fall * n.1 + t * n.0)
    }
}

impl Bow<f64> {
    pub(crate) fn new(through: Point, normal: Vector, curvature: f64) -> Self {
        Self {
            through: (through.x, through.y),
            normal: (normal.x, normal.y),
            curvature,
        }
    }

    /// Turned, and then moved.
    pub(crate) fn moved(&self, turn: Rotation, by: Vector) -> Self {
        Self::new(turn * self.from() + by, turn * self.axis(), self.curvature)
    }

    fn from(&self) -> Point {
        Point::new(self.through.0, self.through.1)
    }

    fn axis(&self) -> Vector {
        Vector::new(self.normal.0, self.normal.1)
    }

    /// The point at a place.
    pub(crate) fn point(&self, u: f64) -> Point {
        let d = self.way(u);
        self.from() + Vector::new(d.0, d.1)
    }

    /// The place of a point of it.
    pub(crate) fn place(&self, p: Point) -> f64 {
        let (d, n) = (p - self.from(), self.axis());
        n.left().dot(d) / (1.0 + 0.5 * self.curvature * n.dot(d))
    }

    /// The unit normal at a point of it.
    pub(crate) fn normal_at(&self, p: Point) -> Vector {
        (self.axis() + (p - self.from()) * self.curvature).unit()
    }

    /// The signed distance of a point near it, positive on the free side: 2 f / (1 + √(1 + 2 κ f)) with f = n·d + κ d²/2.
    pub(crate) fn distance(&self, p: Point) -> f64 {
        let d = p - self.from();
        let f = self.axis().dot(d) + 0.5 * self.curvature * d.length_squared();
        2.0 * f / (1.0 + (1.0 + 2.0 * self.curvature * f).max(0.0).sqrt())
    }

    /// The angle about the centre from one place to another.
    pub(crate) fn angle(&self, from: f64, to: f64) -> f64 {
        let half = 0.5 * self.curvature;
        2.0 * ((half * (to - from)) / (1.0 + half * half * from * to)).atan()
    }

    /// tan(φ/4) of the angle from one place to another, positive counter-clockwise; 0 if they have passed each other.
    pub(crate) fn bulge(&self, from: f64, to: f64) -> f64 {
        (0.25 * self.angle(from, to.max(from))).tan()
    }

    /// Where another carrier is crossed, if it is near.
    pub(crate) fn crossed(&self, other: &Level<f64>, enters: bool) -> Option<Point> {
        let n = self.axis();
        let a = Vector::new(other.a.0, other.a.1);
        let slope = a.dot(n.left());
        let square = 0.5 * (other.k - self.curvature * a.dot(n))
            + 0.25 * other.c * self.curvature * self.curvature;
        if slope * slope - 4.0 * square * other.c <= 0.0 {
            return None;
        }
        let u = self.crossing(other, enters);
        ((u * self.curvature).abs() < WIDEST).then(|| self.point(u))
    }

    /// The distances at which the ray p + t d meets it, d being a unit vector.
    pub(crate) fn met(&self, p: Point, d: Vector) -> [f64; 2] {
        let (q, n, k) = (p - self.from(), self.axis(), self.curvature);
        let square = 0.5 * k;
        let slope = d.dot(n) + k * q.dot(d);
        let level = n.dot(q) + 0.5 * k * q.length_squared();
        let root = (slope * slope - 4.0 * square * level).sqrt();
        let sum = -(slope + root.copysign(slope));
        [2.0 * level / sum, sum / (2.0 * square)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(center: Point, radius: f64, at: f64) -> (Bow<f64>, Carrier<f64>) {
        let n = Vector::from_angle(at);
        (
            Bow::new(center + n * radius, n, 1.0 / radius),
            Carrier::Circle {
                center: (center.x, center.y),
                radius,
            },
        )
    }

    /// Crossings with lines, bows and circles are where circles by their centres say.
    #[test]
    fn crossings_are_on_both_carriers() {
        for r in [3.0, -3.0] {
            let (bow, own) = circle(
                Point::new(0.3, -3.0),
                r,
                1.5 + if r < 0.0 { 3.1 } else { 0.0 },
            );
            let (other, far) = circle(Point::new(-0.4, 4.6), -5.0, 4.9);
            let line = Carrier::Line {
                normal: (0.6, 0.8),
                through: (0.1, 0.05),
            };
            let small = Carrier::Circle {
                center: (0.2, -0.1),
                radius: -0.6,
            };
            for g in [line, Carrier::Bow(other), far, small] {
                for enters in [true, false] {
                    let Some(p) = bow.crossed(&Level::of(&g, bow.through), enters) else {
                        continue;
                    };
                    let off = |c: &Carrier<f64>, p: Point| Level::of(c, (p.x, p.y)).c;
                    assert!(off(&own, p).abs() < 1e-13, "{g:?} {p:?}");
                    assert!(off(&g, p).abs() < 1e-13);
                    let u = bow.place(p);
                    assert!(bow.point(u).distance(p) < 1e-14);
                    let later = off(&g, bow.point(u + 1e-6));
                    assert_eq!(later < 0.0, enters);
                }
            }
        }
    }
}

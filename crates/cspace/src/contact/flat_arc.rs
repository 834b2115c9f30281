//! Flat arcs: circles much larger than the parts, as curves through a point near these.
//!
//! A circle with the curvature κ = 1/r through a point P with the unit normal n is n·d + κ d²/2 = 0 for the way d from P.
//! Nothing in it is large, so that a place on it is as exact as P is, however far away the centre. A line is one with κ = 0.

use crate::feature::tolerance::WIDEST_ARC;
use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;
use crate::number::plane::dot;

use super::spiral::{Spiral, turned};

/// A circle, or a line, through a point.
///
/// Places on it are told by a number u = 2/κ tan(φ/2) that grows with travel to the left of the normal, φ being the angle
/// about the centre from P: nearly the length, and for a line just that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FlatArc<T> {
    pub(crate) through: (T, T),
    pub(crate) normal: (T, T),
    pub(crate) curvature: f64,
}

/// The equation a·d + k d²/2 + c = 0 of a line or circle, for the way d from a point; its left side is positive on the free side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Equation<T> {
    pub(crate) a: (T, T),
    pub(crate) k: f64,
    pub(crate) c: T,
}

impl<T: Real> FlatArc<T> {
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
    pub(crate) fn crossing(&self, other: &Equation<T>, enters: bool) -> T {
        let real = T::constant;
        let (n, kappa) = (self.normal, self.curvature);
        let along = (-n.1, n.0);
        let square = (real(other.k) - real(kappa) * dot(other.a, n)) * real(0.5)
            + other.c * real(0.25 * kappa * kappa);
        let slope = dot(other.a, along);
        let root = (slope * slope - real(4.0) * square * other.c).sqrt();
        let steep = if enters { -root } else { root };
        // Of two forms that are equal the one in which nothing cancels.
        if enters == (slope.value() < 0.0) {
            real(-2.0) * other.c / (slope + steep)
        } else {
            (steep - slope) / (real(2.0) * square)
        }
    }

    /// The way from the point it goes through to a place.
    pub(crate) fn way(&self, u: T) -> (T, T) {
        let real = T::constant;
        let n = self.normal;
        let half = u * real(0.5 * self.curvature);
        let t = u / (real(1.0) + half * half);
        let fall = -(t * half);
        (fall * n.0 - t * n.1, fall * n.1 + t * n.0)
    }
}

impl FlatArc<f64> {
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
    pub(crate) fn crossed(&self, other: &Equation<f64>, enters: bool) -> Option<Point> {
        let n = self.axis();
        let a = Vector::new(other.a.0, other.a.1);
        let slope = a.dot(n.left());
        let square = 0.5 * (other.k - self.curvature * a.dot(n))
            + 0.25 * other.c * self.curvature * self.curvature;
        if slope * slope - 4.0 * square * other.c <= 0.0 {
            return None;
        }
        let u = self.crossing(other, enters);
        ((u * self.curvature).abs() < WIDEST_ARC).then(|| self.point(u))
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
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::carrier::Carrier;
    use super::*;

    fn circle(center: Point, radius: f64, at: f64) -> (FlatArc<f64>, Carrier<f64>) {
        let n = Vector::from_angle(at);
        (
            FlatArc::new(center + n * radius, n, 1.0 / radius),
            Carrier::Circle {
                center: (center.x, center.y),
                radius,
            },
        )
    }

    /// Crossings with lines, flat arcs and circles are where circles by their centres say.
    #[test]
    fn crossings_are_on_both_carriers() {
        for r in [3.0, -3.0] {
            let (arc, own) = circle(
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
            for g in [line, Carrier::FlatArc(other), far, small] {
                for enters in [true, false] {
                    let Some(p) = arc.crossed(&g.equation(arc.through), enters) else {
                        continue;
                    };
                    let off = |c: &Carrier<f64>, p: Point| c.equation((p.x, p.y)).c;
                    assert!(off(&own, p).abs() < 1e-13, "{g:?} {p:?}");
                    assert!(off(&g, p).abs() < 1e-13);
                    let u = arc.place(p);
                    assert!(arc.point(u).distance(p) < 1e-14);
                    let later = off(&g, arc.point(u + 1e-6));
                    assert_eq!(later < 0.0, enters);
                }
            }
        }
    }

    /// What a carrier is from one point tells its level at any other.
    #[test]
    fn a_level_is_the_same_from_wherever_it_is_seen() {
        let (near, far) = circle(Point::new(0.3, -3.0), 3.2, 1.4);
        let line = Carrier::Line {
            normal: (0.6, -0.8),
            through: (0.1, 0.05),
        };
        let small = Carrier::Circle {
            center: (0.2, -0.1),
            radius: -0.6,
        };
        for carrier in [line, Carrier::FlatArc(near), far, small] {
            for (from, to) in [
                (Point::new(0.4, 0.7), Point::new(-1.1, 0.2)),
                (Point::new(-0.3, -0.9), Point::new(0.8, -0.5)),
            ] {
                let d = to - from;
                let seen = carrier.equation((from.x, from.y));
                let at = seen.a.0 * d.x + seen.a.1 * d.y + 0.5 * seen.k * d.dot(d) + seen.c;
                let there = carrier.equation((to.x, to.y)).c;
                assert!((at - there).abs() < 1e-14, "{carrier:?}");
                // Free is away from the centre of a circle, unless its radius is negative.
                let free = match carrier {
                    Carrier::Line { normal, through } => {
                        normal.0 * (to.x - through.0) + normal.1 * (to.y - through.1) > 0.0
                    }
                    Carrier::FlatArc(_) => to.distance(Point::new(0.3, -3.0)) > 3.2,
                    Carrier::Circle { center, radius } => {
                        let off = to.distance(Point::new(center.0, center.1)) - radius.abs();
                        off * radius > 0.0
                    }
                };
                assert_eq!(there > 0.0, free, "{carrier:?}");
            }
        }
    }

    /// A line at a slant crosses an arc that is nearly one where it crosses the tangent, but for second order.
    #[test]
    fn crossings_with_lines_are_exact_however_large_the_radius() {
        for radius in [1e3, 1e6, 1e9, -1e9] {
            let arc = FlatArc::new(Point::new(0.2, 0.1), Vector::new(0.0, 1.0), 1.0 / radius);
            for (angle, enters) in [(0.4_f64, true), (-0.4, false)] {
                // Through a point 0.7 to the left of where the flat arc is told.
                let (sin, cos) = angle.sin_cos();
                let through = (0.2 - 0.7, 0.1);
                let line = Carrier::Line {
                    normal: (sin, cos),
                    through,
                };
                let p = arc.crossed(&line.equation(arc.through), enters).unwrap();
                // The flat arc is d²/2r below its tangent there; along the line that is so much further.
                let (mut x, mut y) = (through.0, through.1);
                for _ in 0..20 {
                    let d = x - 0.2;
                    y = 0.1 - d * d / (radius + (radius * radius - d * d).sqrt() * radius.signum());
                    x = through.0 - (y - through.1) * cos / sin;
                }
                assert!(
                    p.distance(Point::new(x, y)) < 1e-15,
                    "{radius} {p:?} {x} {y}"
                );
                // It has no other crossing near.
                assert!(arc.crossed(&line.equation(arc.through), !enters).is_none());
            }
        }
    }

    /// Rays to a place on an arc that is nearly a line.
    #[test]
    fn rays_are_exact_however_large_the_radius() {
        for radius in [1e3, 1e6, 1e9, -1e9] {
            let arc = FlatArc::new(Point::new(0.2, 0.1), Vector::new(0.0, 1.0), 1.0 / radius);
            let x = 0.7;
            let below = x * x / (radius + (radius * radius - x * x).sqrt() * radius.signum());
            let place = Point::new(0.2 + x, 0.1 - below);
            for angle in [0.4, 1.5, 2.6, 4.0, 5.5] {
                let d = Vector::from_angle(angle);
                let met = arc.met(place - d * 0.9, d);
                assert!(met.iter().any(|t| (t - 0.9).abs() < 1e-14), "{met:?}");
            }
        }
    }

    /// Circles cross if the distance of their centres is between the difference and the sum of their radii.
    #[test]
    fn circles_that_just_touch_are_told_from_those_that_do_not() {
        const GAP: f64 = 1e-9;
        let center = Point::new(0.3, -3.0);
        for (at, towards) in [(1.2, 1.5), (1.7, 1.5), (1.5, 1.5)] {
            let (arc, _) = circle(center, 3.0, at);
            for radius in [0.5, -0.5] {
                for (distance, inside) in [(3.5, -1.0), (2.5, 1.0)] {
                    for sign in [-1.0, 1.0] {
                        let other = center + Vector::from_angle(towards) * (distance + sign * GAP);
                        let small = Carrier::Circle {
                            center: (other.x, other.y),
                            radius,
                        };
                        let level = small.equation(arc.through);
                        for enters in [true, false] {
                            let found = arc.crossed(&level, enters).is_some();
                            assert_eq!(found, sign == inside, "{at} {radius} {distance} {sign}");
                        }
                    }
                }
            }
        }
    }

    /// Places, normals, distances and angles against those of a circle about its centre.
    #[test]
    fn a_flat_arc_is_a_circle() {
        let center = Point::new(0.3, -3.0);
        for radius in [3.0, -3.0] {
            let at = 1.4
                + if radius < 0.0 {
                    core::f64::consts::PI
                } else {
                    0.0
                };
            let (arc, _) = circle(center, radius, at);
            let on = |angle: f64| center + Vector::from_angle(at + angle) * radius;
            // Travel is to the left of the normal: with the angle on a circle of positive radius.
            let place = |angle: f64| 2.0 * radius * (0.5 * angle).tan();
            for angle in [-0.4, -0.1, 0.0, 0.25, 0.45] {
                let (p, u) = (on(angle), place(angle));
                assert!((arc.place(p) - u).abs() < 1e-14);
                assert!(arc.point(u).distance(p) < 1e-14);
                let normal = Vector::from_angle(at + angle);
                assert!((arc.normal_at(p) - normal).length() < 1e-14);
                for off in [-0.3, -1e-3, 0.2] {
                    assert!((arc.distance(p + normal * off) - off).abs() < 1e-14);
                }
                for other in [-0.3, 0.2] {
                    let (from, to) = (place(other), u);
                    assert!((arc.angle(from, to) - (angle - other)).abs() < 1e-14);
                    let turned = if from < to { angle - other } else { 0.0 };
                    assert!((arc.bulge(from, to) - (0.25 * turned).tan()).abs() < 1e-14);
                }
                let (turn, by) = (Rotation::by(0.7), Vector::new(0.4, -0.2));
                let moved = arc.moved(turn, by);
                assert!(moved.point(u).distance(turn * p + by) < 1e-14);
            }
            for (p, angle) in [(Point::new(0.1, 0.4), 4.5), (Point::new(0.5, -0.3), 1.7)] {
                let d = Vector::from_angle(angle);
                let v = center - p;
                let half = (9.0 - v.cross(d) * v.cross(d)).sqrt();
                let expected = [v.dot(d) - half, v.dot(d) + half];
                let mut met = arc.met(p, d);
                met.sort_by(f64::total_cmp);
                for (a, b) in met.into_iter().zip(expected) {
                    assert!((a - b).abs() < 1e-13, "{met:?} {expected:?}");
                }
            }
        }
    }
}

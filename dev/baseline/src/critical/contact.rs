//! Contacts of two features, and the lines and circles of positions that they are at one orientation.

use core::f64::consts::{PI, TAU};

use cspace::{Point, Rotation, Vector};

use super::bernstein::Polynomial;
use super::outline::{Feature, Outline, Shape};
use super::span::{Interval, Span};
use super::tolerance::BEYOND;

/// c₀ + c₁ cos θ + c₂ sin θ.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Wave(pub(super) [f64; 3]);

impl Wave {
    pub(super) fn at(&self, turn: Rotation) -> f64 {
        self.0[0] + self.0[1] * turn.cos + self.0[2] * turn.sin
    }

    /// Derivative by θ.
    pub(super) fn slope(&self, turn: Rotation) -> f64 {
        self.0[2] * turn.cos - self.0[1] * turn.sin
    }

    /// Times 1 + t², as a polynomial in s = t / T on the interval, where t = tan((θ − middle) / 2) and T its value at the end.
    pub(super) fn over(&self, on: &Interval) -> Polynomial {
        let [c, cos, sin] = self.0;
        let (along, across) = (
            cos * on.turn.cos + sin * on.turn.sin,
            sin * on.turn.cos - cos * on.turn.sin,
        );
        let t = on.tangent;
        Polynomial::quadratic([c + along, 2.0 * across * t, (c - along) * t * t])
    }
}

/// The positions of a contact, its features carried on: k |p|² + a x + b y + c = 0, a circle for k = 1 and a line for k = 0,
/// then with a unit vector (a, b). Equations 1 and 3 of Sacks (1999).
#[derive(Debug, Clone, Copy)]
pub(super) struct Carrier {
    pub(super) round: bool,
    pub(super) a: Wave,
    pub(super) b: Wave,
    pub(super) c: Wave,
    /// Sum of the signed radii of a circle.
    pub(super) radius: f64,
}

impl Carrier {
    /// The circle's centre, as waves.
    pub(super) fn center(&self) -> [Wave; 2] {
        [self.a, self.b].map(|w| Wave(w.0.map(|c| -0.5 * c)))
    }

    /// The distance of a position from the carrier, with its derivatives by position and orientation: of a circle to first order.
    pub(super) fn distance(&self, p: Point, turn: Rotation) -> (f64, Vector, f64) {
        let value = |w: &Wave| w.at(turn);
        let (a, b) = (value(&self.a), value(&self.b));
        let plain = a * p.x + b * p.y + value(&self.c);
        let slope = self.a.slope(turn) * p.x + self.b.slope(turn) * p.y + self.c.slope(turn);
        if !self.round {
            return (plain, Vector::new(a, b), slope);
        }
        let per = 0.5 / self.radius.abs();
        let square = p.to_vector().length_squared();
        let normal = Vector::new(2.0 * p.x + a, 2.0 * p.y + b) * per;
        ((square + plain) * per, normal, slope * per)
    }
}

/// A feature of the fixed part against one of the moving part.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    pub(super) fixed: u32,
    pub(super) moving: u32,
    /// The orientations at which their normals oppose each other.
    pub(super) span: Span,
    pub(super) carrier: Carrier,
}

/// Contacts that the shapes of two features allow.
pub(super) fn contacts(fixed: &Outline, moving: &Outline) -> Vec<Contact> {
    let mut all = Vec::new();
    for (i, a) in (0u32..).zip(&fixed.features) {
        for (j, b) in (0u32..).zip(&moving.features) {
            if let Some(carrier) = carrier(a, b) {
                all.push(Contact {
                    fixed: i,
                    moving: j,
                    span: Span::new(a.lo - b.hi - PI, a.width() + b.width()),
                    carrier,
                });
            }
        }
    }
    all
}

/// `None` for two lines, for a concave arc against anything but a more sharply rounded convex one, and for two vertices.
fn carrier(a: &Feature, b: &Feature) -> Option<Carrier> {
    match (a.shape, b.shape) {
        (Shape::Line { .. }, Shape::Line { .. }) => None,
        (Shape::Line { start, .. }, Shape::Round { center: q, radius }) => {
            // n·(p + R q) = n·start + r.
            let (n, q) = (Vector::from_angle(a.lo), q.to_vector());
            (radius >= 0.0).then(|| Carrier {
                round: false,
                a: Wave([n.x, 0.0, 0.0]),
                b: Wave([n.y, 0.0, 0.0]),
                c: Wave([-radius - n.dot(start.to_vector()), n.dot(q), -n.cross(q)]),
                radius,
            })
        }
        (Shape::Round { center: p, radius }, Shape::Line { start, .. }) => {
            // R m·(centre − p) = m·start + r.
            let (m, p) = (Vector::from_angle(b.lo), p.to_vector());
            (radius >= 0.0).then(|| Carrier {
                round: false,
                a: Wave([0.0, m.x, -m.y]),
                b: Wave([0.0, m.y, m.x]),
                c: Wave([m.dot(start.to_vector()) + radius, -m.dot(p), -m.cross(p)]),
                radius,
            })
        }
        (
            Shape::Round {
                center: p,
                radius: r,
            },
            Shape::Round {
                center: q,
                radius: s,
            },
        ) => {
            // |p' + R q − p|² = (r + s)².
            let (p, q, radius) = (p.to_vector(), q.to_vector(), r + s);
            let convex = r >= 0.0 && s >= 0.0 && radius > 0.0;
            let nested = r.min(s) < 0.0 && r.max(s) >= 0.0 && radius < 0.0;
            (convex || nested).then(|| Carrier {
                round: true,
                a: Wave([-2.0 * p.x, 2.0 * q.x, -2.0 * q.y]),
                b: Wave([-2.0 * p.y, 2.0 * q.y, 2.0 * q.x]),
                c: Wave([
                    p.length_squared() + q.length_squared() - radius * radius,
                    -2.0 * p.dot(q),
                    -2.0 * q.cross(p),
                ]),
                radius,
            })
        }
    }
}

impl Contact {
    /// Whether the features themselves touch, and not only their carriers, at a configuration on the carrier.
    pub(super) fn touches(
        &self,
        fixed: &Outline,
        moving: &Outline,
        p: Point,
        theta: f64,
        turn: Rotation,
    ) -> bool {
        let a = &fixed.features[self.fixed as usize];
        let b = &moving.features[self.moving as usize];
        match (a.shape, b.shape) {
            (Shape::Line { start, end }, Shape::Round { center, radius }) => {
                let n = Vector::from_angle(a.lo);
                let at = p + turn * center.to_vector() + n * -radius;
                is_between(start, end, at) && has_normal(b, a.lo + PI - theta)
            }
            (Shape::Round { center, radius }, Shape::Line { start, end }) => {
                let n = -(turn * Vector::from_angle(b.lo));
                let at = turn.inverse() * (center + n * radius - p);
                is_between(start, end, Point::ORIGIN + at) && has_normal(a, b.lo + PI + theta)
            }
            (Shape::Round { center: o, .. }, Shape::Round { center: q, .. }) => {
                let n = (p + turn * q.to_vector() - o) * self.carrier.radius.signum();
                let angle = n.angle();
                has_normal(a, angle) && has_normal(b, angle + PI - theta)
            }
            (Shape::Line { .. }, Shape::Line { .. }) => false,
        }
    }
}

fn is_between(start: Point, end: Point, p: Point) -> bool {
    let v = end - start;
    let along = (p - start).dot(v.unit());
    (-BEYOND..=v.length() + BEYOND).contains(&along)
}

/// Whether a round feature has a normal of a given angle.
fn has_normal(f: &Feature, angle: f64) -> bool {
    let above = angle - f.lo + BEYOND;
    above - TAU * (above / TAU).floor() <= f.width() + 2.0 * BEYOND
}

//! Contact functions: zero where two features touch, positive where they are apart.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;

use super::carrier::{Carrier, SheetKind};
use super::cycle::Cycle;
use super::spiral::Spiral;

/// The contact function of a pair of features, equations (1)–(3) of Sacks 1999, in the pair's frame.
///
/// Its value at a position p and orientation θ is the distance of the features' carriers along the contact normal:
/// zero on the contact patch, positive on its free side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case", tag = "kind"))]
pub enum ContactFunction {
    /// Fixed line against moving arc or vertex (equation 1, the line fixed): n·(p − c(θ)).
    FixedLine {
        /// Outward unit normal of the fixed line.
        normal: Vector,
        /// A position in contact.
        through: Spiral,
    },
    /// Moving line against fixed arc or vertex (equation 1, the line moving): R n·(p − c(θ)).
    MovingLine {
        /// Minus the outward unit normal of the moving line, in the moving part's frame.
        normal: Vector,
        /// A position in contact.
        through: Spiral,
    },
    /// Two arcs, or an arc and a vertex (equations 2 and 3): ±(|p − c(θ)| − |r|), with the sign of r.
    Circle {
        /// Position at which the two centres coincide.
        center: Spiral,
        /// Sum of the signed radii (convex positive): negative for a convex arc inside a concave one.
        radius: f64,
    },
    /// As `Circle`, for an arc so large that all digits would be lost between its centre and the parts: a circle of the curvature κ = 1/r
    /// through c(θ) with the normal n there, 2 f / (1 + √(1 + 2 κ f)) with f = n·d + κ d²/2, d = p − c(θ).
    FlatCircle {
        /// A position near the parts on the circle.
        through: Spiral,
        /// The unit normal there towards the free side: of the arc of the fixed part; or minus that of the arc of the moving
        /// part, in its frame.
        normal: Vector,
        /// Whether the normal turns with the moving part.
        turns: bool,
        /// Sum of the signed radii.
        radius: f64,
    },
}

impl ContactFunction {
    /// Whether its curves at one orientation are circles rather than lines.
    #[inline]
    pub fn is_circular(&self) -> bool {
        matches!(self, Self::Circle { .. } | Self::FlatCircle { .. })
    }

    /// The value at a position of the pair's frame and orientation `theta`.
    pub fn value(&self, p: Point, theta: f64) -> f64 {
        self.cycle(Rotation::by(theta)).distance(p)
    }

    /// The gradient by position and orientation: (∂/∂p, ∂/∂θ).
    ///
    /// It follows from the level n·d + λ d²/2 with d = p − c(θ): the turning part R w of a spiral moves by left(R w) per radian, and so
    /// does a normal that turns.
    pub fn gradient(&self, p: Point, theta: f64) -> (Vector, f64) {
        let turn = Rotation::by(theta);
        let carrier = self.carrier();
        let cycle = carrier.cycle(turn);
        let slope = cycle.slope(p);
        let moves = (turn * carrier.through.turning()).left();
        let drift = if carrier.turns() {
            cycle.normal.left().dot(p - cycle.through)
        } else {
            0.0
        };
        let rate = 1.0 / slope.length();
        (slope * rate, (drift - slope.dot(moves)) * rate)
    }

    /// The whole line or circle at an orientation.
    #[inline(always)]
    pub(crate) fn cycle<T: Real>(&self, turn: Rotation<T>) -> Cycle<T> {
        self.carrier().lift().cycle(turn)
    }

    /// The line or circle as one that moves with orientation.
    #[inline(always)]
    pub(crate) fn carrier(&self) -> Carrier {
        let of = |kind, through, normal, radius| Carrier {
            kind,
            through,
            normal,
            radius,
        };
        match *self {
            Self::FixedLine { normal, through } => of(SheetKind::LineRound, through, normal, 0.0),
            Self::MovingLine { normal, through } => of(SheetKind::RoundLine, through, normal, 0.0),
            Self::Circle { center, radius } => {
                of(SheetKind::RoundRound, center, Vector::ZERO, radius)
            }
            Self::FlatCircle {
                through,
                normal,
                turns,
                radius,
            } => {
                let kind = match turns {
                    true => SheetKind::MovingFlatArc,
                    false => SheetKind::FixedFlatArc,
                };
                of(kind, through, normal, radius)
            }
        }
    }
}

impl Carrier {
    /// The contact function.
    pub(crate) fn function(&self) -> ContactFunction {
        let Self {
            through,
            normal,
            radius,
            ..
        } = *self;
        match self.kind {
            SheetKind::LineRound => ContactFunction::FixedLine { normal, through },
            SheetKind::RoundLine => ContactFunction::MovingLine { normal, through },
            SheetKind::RoundRound => ContactFunction::Circle {
                center: through,
                radius,
            },
            SheetKind::FixedFlatArc | SheetKind::MovingFlatArc => ContactFunction::FlatCircle {
                through,
                normal,
                turns: self.turns(),
                radius,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::spiral::Swing;
    use super::*;

    fn normal() -> Vector {
        Vector::from_angle(0.7)
    }

    #[test]
    fn gradients_agree_with_differences() {
        let s = Spiral::new(Point::new(0.3, -0.2), Vector::new(0.5, 0.1));
        let long = Spiral {
            swing: Swing {
                arm: normal() * -30.0,
                rest: 0.29,
            },
            ..s
        };
        let normal = normal();
        let flat = |turns| ContactFunction::FlatCircle {
            through: long,
            normal,
            turns,
            radius: -20.0,
        };
        for f in [
            flat(false),
            flat(true),
            ContactFunction::FixedLine { normal, through: s },
            ContactFunction::MovingLine { normal, through: s },
            ContactFunction::Circle {
                center: s,
                radius: 0.4,
            },
            ContactFunction::Circle {
                center: s,
                radius: -0.4,
            },
        ] {
            let (p, theta, h) = (Point::new(1.1, 0.4), 0.3, 1e-6);
            let (by_p, by_theta) = f.gradient(p, theta);
            let difference = |a: f64, b: f64| (a - b) / (2.0 * h);
            let dx = difference(
                f.value(p + Vector::new(h, 0.0), theta),
                f.value(p + Vector::new(-h, 0.0), theta),
            );
            let dy = difference(
                f.value(p + Vector::new(0.0, h), theta),
                f.value(p + Vector::new(0.0, -h), theta),
            );
            let dt = difference(f.value(p, theta + h), f.value(p, theta - h));
            assert!((dx - by_p.x).abs() < 1e-9 && (dy - by_p.y).abs() < 1e-9);
            assert!((dt - by_theta).abs() < 1e-8, "{f:?}: {dt} {by_theta}");
        }
    }

    /// The function vanishes on its cycle, and beside it, along the normal, it equals the distance.
    #[test]
    fn cycles_are_where_functions_vanish() {
        let s = Spiral::new(Point::new(0.3, -0.2), Vector::new(0.5, 0.1));
        let normal = Vector::from_angle(0.7);
        let theta = 0.3_f64;
        // Turned as complex numbers are multiplied.
        let turned = Point::new(
            0.3 + theta.cos() * 0.5 - theta.sin() * 0.1,
            -0.2 + theta.sin() * 0.5 + theta.cos() * 0.1,
        );
        for (f, angle) in [
            (ContactFunction::FixedLine { normal, through: s }, 0.7),
            (ContactFunction::MovingLine { normal, through: s }, 1.0),
        ] {
            let line = f.cycle(Rotation::by(theta));
            let (n, o) = (line.normal, line.through);
            assert!(!f.is_circular() && line.is_line());
            assert!((n - Vector::from_angle(angle)).length() < 1e-15);
            assert!(o.distance(turned) < 1e-15);
            assert!((f.value(o + n.left() * 0.8 + n * 0.2, theta) - 0.2).abs() < 1e-15);
        }
        for radius in [0.4, -0.4] {
            let f = ContactFunction::Circle { center: s, radius };
            let circle = f.cycle(Rotation::by(theta));
            let c = circle.through;
            assert!(f.is_circular() && circle.is_centred());
            assert!(circle.size == 0.4 && c.distance(turned) < 1e-15);
            for k in 0..6 {
                let n = Vector::from_angle(f64::from(k));
                assert!((f.value(c + n * 0.5, theta) - 0.1 * radius.signum()).abs() < 1e-15);
            }
        }
    }
}

//! The resultant of two conditions: a polynomial that vanishes where one y meets both.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::TrigPolynomial;

use super::condition::{Carriers, Condition};
use super::cycle::{self, along};
use super::motion::{Motion, Placement};
use super::tolerance::INDEPENDENT;

/// Intervals of x are not halved below this when crossings are isolated (radians or length); two crossings nearer than
/// that, between which the pieces are a hundred times nearer than rounding, may go unnoticed as a pair.
const NARROWEST: f64 = 1e-8;

/// Whether two conditions are levels of one function of (x, y), so that their curves never cross.
pub(super) fn parallel(f: &Condition, g: &Condition) -> bool {
    let same = |a: Point, b: Point| a.distance(b) < INDEPENDENT;
    match (f.carriers, g.carriers) {
        (
            Carriers::FirstLine {
                normal: n,
                point: p,
                ..
            },
            Carriers::FirstLine {
                normal: m,
                point: q,
                ..
            },
        )
        | (
            Carriers::SecondLine {
                normal: n,
                point: p,
                ..
            },
            Carriers::SecondLine {
                normal: m,
                point: q,
                ..
            },
        ) => n.cross(m).abs() < INDEPENDENT && same(p, q),
        (
            Carriers::Circles {
                first: p,
                second: q,
                ..
            },
            Carriers::Circles {
                first: r,
                second: s,
                ..
            },
        ) => same(p, r) && same(q, s),
        _ => false,
    }
}

/// Calls `mark` with intervals that hold all x at which the conditions are met by one y.
pub(super) fn isolate(
    f: &Condition,
    g: &Condition,
    lo: f64,
    hi: f64,
    mark: &mut impl FnMut(f64, f64),
) {
    let resultant = |first: Placement| resultant(&f.at(first), &g.at(first));
    if let Motion::Turn { center } = f.motions.first {
        let polynomial = TrigPolynomial::sampled(|cos: f64, sin: f64| {
            let turn = Rotation { cos, sin };
            let shift = center.to_vector() - turn * center.to_vector();
            resultant(Placement { turn, shift })
        });
        let mut vague = Vec::new();
        polynomial.brackets(lo, hi, NARROWEST, mark, &mut |a, b| vague.push((a, b)));
        for (a, b) in vague {
            mark(a, b);
        }
        return;
    }
    // A polynomial of x = m + h cos φ is a trigonometric one of φ.
    let (m, h) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let x = |angle: f64| m + h * angle.cos();
    let polynomial = TrigPolynomial::sampled(|cos: f64, _| {
        let shift = match f.motions.first {
            Motion::Slide { direction } => direction * (m + h * cos),
            _ => Vector::ZERO,
        };
        let turn = Rotation::IDENTITY;
        resultant(Placement { turn, shift })
    });
    let mut both = Vec::new();
    let mut vague = Vec::new();
    polynomial.brackets(
        0.0,
        core::f64::consts::PI,
        NARROWEST,
        &mut |a, b| both.push((a, b)),
        &mut |a, b| vague.push((a, b)),
    );
    for (a, b) in both.into_iter().chain(vague) {
        mark(x(b).max(lo), x(a).min(hi));
    }
}

/// What a condition asks of y at one x.
#[derive(Debug, Clone, Copy)]
enum InY {
    /// a cos y + b sin y = c.
    Turn(f64, f64, f64),
    /// b y = c.
    Line(f64, f64),
    /// a y² + b y + c = 0.
    Square(f64, f64, f64),
}

impl Condition {
    /// What it asks with the first part at its place at some x.
    fn at(&self, first: Placement) -> InY {
        match (self.carriers, self.motions.second) {
            (
                Carriers::FirstLine {
                    normal,
                    through,
                    point,
                    radius,
                },
                second,
            ) => {
                let (n, l) = (first.turn * normal, first.point(through));
                match second {
                    Motion::Turn { center } => {
                        let w = point - center;
                        InY::Turn(n.dot(w), n.dot(w.left()), n.dot(l - center) + radius)
                    }
                    Motion::Slide { direction } => {
                        InY::Line(n.dot(direction), n.dot(l - point) + radius)
                    }
                    Motion::Still => InY::Line(0.0, 0.0),
                }
            }
            (
                Carriers::SecondLine {
                    normal,
                    through,
                    point,
                    radius,
                },
                second,
            ) => {
                let p = first.point(point);
                match second {
                    Motion::Turn { center } => {
                        let v = p - center;
                        let offset = normal.dot(through - center) + radius;
                        InY::Turn(normal.dot(v), normal.left().dot(v), offset)
                    }
                    Motion::Slide { direction } => {
                        InY::Line(normal.dot(direction), normal.dot(p - through) - radius)
                    }
                    Motion::Still => InY::Line(0.0, 0.0),
                }
            }
            (
                Carriers::Circles {
                    first: p,
                    second: q,
                    radius,
                },
                second,
            ) => {
                let p = first.point(p);
                match second {
                    Motion::Turn { center } => {
                        let (v, w) = (p - center, q - center);
                        let c = 0.5 * (v.length_squared() + w.length_squared() - radius * radius);
                        InY::Turn(v.dot(w), v.dot(w.left()), c)
                    }
                    Motion::Slide { direction } => {
                        let v = p - q;
                        InY::Square(
                            1.0,
                            -2.0 * direction.dot(v),
                            v.length_squared() - radius * radius,
                        )
                    }
                    Motion::Still => InY::Line(0.0, 0.0),
                }
            }
            (
                Carriers::Cycles {
                    first: a,
                    second: b,
                },
                second,
            ) => {
                let a = a.placed(|p| first.point(p), |v| first.turn * v);
                match second {
                    Motion::Turn { center } => {
                        let (p, q) = (a.arm(center), b.arm(center));
                        let moments = (a.moment(center), self.offset);
                        InY::Turn(p.dot(q), p.dot(q.left()), cycle::level(&a, &b, moments))
                    }
                    Motion::Slide { direction } => {
                        let (square, slope, still) = along(&a, &b, direction);
                        if square == 0.0 {
                            InY::Line(slope, -still)
                        } else {
                            InY::Square(0.5 * square, slope, still)
                        }
                    }
                    Motion::Still => InY::Line(0.0, 0.0),
                }
            }
        }
    }
}

/// Zero where both conditions are met by one y, and the size of the terms it was summed from.
fn resultant(f: &InY, g: &InY) -> (f64, f64) {
    match (*f, *g) {
        (InY::Turn(a, b, c), InY::Turn(d, e, f)) => {
            // Cramer's rule for (cos y, sin y), whose length is one.
            let (p, q, r) = (c * e - f * b, a * f - d * c, a * e - d * b);
            let size = |a: f64, b: f64| (a.abs() + b.abs()).powi(2);
            let terms = size(c * e, f * b) + size(a * f, d * c) + size(a * e, d * b);
            (p * p + q * q - r * r, terms)
        }
        (InY::Line(b, c), InY::Line(d, e)) => (b * e - d * c, (b * e).abs() + (d * c).abs()),
        (InY::Line(d, e), InY::Square(a, b, c)) | (InY::Square(a, b, c), InY::Line(d, e)) => (
            a * e * e + b * e * d + c * d * d,
            (a * e * e).abs() + (b * e * d).abs() + (c * d * d).abs(),
        ),
        (InY::Square(a, b, c), InY::Square(d, e, f)) => {
            let (p, q, r) = (a * e - d * b, a * f - d * c, b * f - e * c);
            let size = |a: f64, b: f64| a.abs() + b.abs();
            (
                q * q - p * r,
                size(a * f, d * c).powi(2) + size(a * e, d * b) * size(b * f, e * c),
            )
        }
        _ => (f64::NAN, 0.0),
    }
}

//! Equations in one coordinate: trigonometric for a part that turns, quadratic for one that slides.

use crate::geometry::{Point, Rotation, Vector};

use super::cycle::Cycle;
use super::motion::Motion;
use super::tolerance::INDEPENDENT;

/// A function of one coordinate whose roots have a closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Equation {
    /// α cos t + β sin t + γ.
    Trig { alpha: f64, beta: f64, gamma: f64 },
    /// a t² + b t + c.
    Quadratic { a: f64, b: f64, c: f64 },
}

impl Equation {
    /// n(t)·(l(t) − c): the distance of a carried line from a point.
    pub(super) fn line_offset(motion: Motion, normal: Vector, through: Point, c: Point) -> Self {
        match motion {
            Motion::Turn { center } => Self::Trig {
                alpha: normal.dot(center - c),
                beta: normal.left().dot(center - c),
                gamma: normal.dot(through - center),
            },
            Motion::Slide { direction } => Self::Quadratic {
                a: 0.0,
                b: normal.dot(direction),
                c: normal.dot(through - c),
            },
            Motion::Still => Self::constant(normal.dot(through - c)),
        }
    }

    /// |p(t) − c|².
    pub(super) fn distance_squared(motion: Motion, p: Point, c: Point) -> Self {
        match motion {
            Motion::Turn { center } => {
                let (d, w) = (center - c, p - center);
                Self::Trig {
                    alpha: 2.0 * d.dot(w),
                    beta: 2.0 * d.dot(w.left()),
                    gamma: d.length_squared() + w.length_squared(),
                }
            }
            Motion::Slide { direction } => Self::Quadratic {
                a: 1.0,
                b: 2.0 * direction.dot(p - c),
                c: (p - c).length_squared(),
            },
            Motion::Still => Self::constant((p - c).length_squared()),
        }
    }

    /// The moment of a carried cycle, seen from a point.
    pub(super) fn moment(motion: Motion, cycle: &Cycle, c: Point) -> Self {
        match motion {
            Motion::Turn { center } => {
                let (d, arm) = (center - c, cycle.arm(center));
                Self::Trig {
                    alpha: arm.dot(d),
                    beta: arm.left().dot(d),
                    gamma: cycle.moment(center) + 0.5 * cycle.weight * d.length_squared(),
                }
            }
            Motion::Slide { direction } => Self::Quadratic {
                a: 0.5 * cycle.weight,
                b: direction.dot(cycle.arm(c)),
                c: cycle.moment(c),
            },
            Motion::Still => Self::constant(cycle.moment(c)),
        }
    }

    /// n·(p(t) − q), the direction n staying.
    pub(super) fn position(motion: Motion, p: Point, n: Vector, q: Point) -> Self {
        match motion {
            Motion::Turn { center } => {
                let w = p - center;
                Self::Trig {
                    alpha: n.dot(w),
                    beta: n.dot(w.left()),
                    gamma: n.dot(center - q),
                }
            }
            Motion::Slide { direction } => Self::Quadratic {
                a: 0.0,
                b: n.dot(direction),
                c: n.dot(p - q),
            },
            Motion::Still => Self::constant(n.dot(p - q)),
        }
    }

    /// v(t)·d.
    pub(super) fn direction(motion: Motion, v: Vector, d: Vector) -> Self {
        match motion {
            Motion::Turn { .. } => Self::Trig {
                alpha: v.dot(d),
                beta: v.left().dot(d),
                gamma: 0.0,
            },
            _ => Self::constant(v.dot(d)),
        }
    }

    fn constant(c: f64) -> Self {
        Self::Quadratic { a: 0.0, b: 0.0, c }
    }

    pub(super) fn plus(self, constant: f64) -> Self {
        match self {
            Self::Trig { alpha, beta, gamma } => Self::Trig {
                alpha,
                beta,
                gamma: gamma + constant,
            },
            Self::Quadratic { a, b, c } => Self::Quadratic {
                a,
                b,
                c: c + constant,
            },
        }
    }

    /// The roots of a trigonometric equation as directions (cos t, sin t), not quite of length one; none of another.
    pub(super) fn directions(self) -> [Option<Vector>; 2] {
        let Self::Trig { alpha, beta, gamma } = self else {
            return [None, None];
        };
        let amplitude = alpha.hypot(beta);
        let square = (amplitude - gamma) * (amplitude + gamma);
        if amplitude < INDEPENDENT || square < 0.0 {
            return [None, None];
        }
        let unit = Vector::new(alpha, beta) * (1.0 / amplitude);
        let (along, aside) = (-gamma / amplitude, square.sqrt() / amplitude);
        [-aside, aside].map(|a| Some(unit * along + unit.left() * a))
    }

    /// Calls `found` with the roots, at most two; with none if the function is constant.
    pub(super) fn roots(self, found: &mut impl FnMut(f64)) {
        match self {
            Self::Trig { alpha, beta, gamma } => {
                let amplitude = alpha.hypot(beta);
                let square = (amplitude - gamma) * (amplitude + gamma);
                if amplitude >= INDEPENDENT {
                    self.roots_of(square, found);
                }
            }
            Self::Quadratic { a, b, c } => {
                if a == 0.0 {
                    if b.abs() >= INDEPENDENT {
                        found(-c / b);
                    }
                    return;
                }
                let square = b * b - 4.0 * a * c;
                if square < 0.0 {
                    return;
                }
                let sum = -0.5 * (b + square.sqrt().copysign(b));
                let (s, t) = if sum == 0.0 {
                    (0.0, 0.0)
                } else {
                    (sum / a, c / sum)
                };
                found(s.min(t));
                found(s.max(t));
            }
        }
    }

    /// The roots of a trigonometric equation of which α² + β² − γ² is known.
    pub(super) fn roots_of(self, square: f64, found: &mut impl FnMut(f64)) {
        let Self::Trig { alpha, beta, gamma } = self else {
            return;
        };
        if square >= 0.0 {
            let middle = beta.atan2(alpha);
            let aside = square.sqrt().atan2(-gamma);
            found(middle - aside);
            found(middle + aside);
        }
    }
}

/// Coordinates (s, t) at which a point of one part is at a point of another: two at most, and those only that are plausible
/// for the second part's orientation seen from the first, t − s.
pub(super) fn coincidences(
    first: Motion,
    p: Point,
    second: Motion,
    q: Point,
    plausible: impl Fn(Rotation) -> bool,
    mut found: impl FnMut(u8, f64, f64),
) {
    match (first, second) {
        (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
            let (v, w, between) = (p - c, q - d, d - c);
            let (e, f, apart) = (v.length(), w.length(), between.length());
            let square = (apart + e - f) * (apart + e + f) * (f - apart + e) * (f + apart - e);
            // A point that is the pivot stays where it is: the other is there at every orientation or at none.
            if square < 0.0 || apart.min(e).min(f) < INDEPENDENT {
                return;
            }
            for (root, [from_first, from_second]) in apexes(between, (e - f) * (e + f), square) {
                // v (1 / |v|²) times the conjugate is the turn, up to rounding.
                let turn = |a: Vector, b: Vector, square: f64| Rotation {
                    cos: a.dot(b) / square,
                    sin: a.cross(b) / square,
                };
                let (s, t) = (turn(v, from_first, e * e), turn(w, from_second, f * f));
                let theta = Rotation {
                    cos: s.cos * t.cos + s.sin * t.sin,
                    sin: s.cos * t.sin - s.sin * t.cos,
                };
                if plausible(theta) {
                    found(root, s.sin.atan2(s.cos), t.sin.atan2(t.cos));
                }
            }
        }
        (Motion::Turn { center }, Motion::Slide { direction }) => {
            for (root, s, t) in on_circle(p, center, q, direction).into_iter().flatten() {
                found(root, s, t);
            }
        }
        (Motion::Slide { direction }, Motion::Turn { center }) => {
            for (root, t, s) in on_circle(q, center, p, direction).into_iter().flatten() {
                found(root, s, t);
            }
        }
        (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => {
            // p + s d = q + t e.
            let (area, v) = (d.cross(e), q - p);
            if area.abs() >= INDEPENDENT {
                found(0, v.cross(e) / area, v.cross(d) / area);
            }
        }
        (Motion::Still, _) | (_, Motion::Still) => {}
    }
}

/// The two places of a point that is at given distances from two pivots, each seen from both: `between` leads from the one
/// pivot to the other, `differ` is what the squares of the distances differ by, and `square` is 16 times the square of the
/// triangle's area.
pub(super) fn apexes(between: Vector, differ: f64, square: f64) -> [(u8, [Vector; 2]); 2] {
    let apart = between.length();
    // Twice the area over the base, and the base's parts.
    let height = 0.5 * square.sqrt() / apart;
    let along = 0.5 * (apart + differ / apart);
    let base = between * (1.0 / apart);
    [(0, height), (1, -height)].map(|(root, up)| {
        let at = |along: f64| base * along + base.left() * up;
        (root, [at(along), at(along - apart)])
    })
}

/// Root, angle and way at which a point that turns is at one that slides.
fn on_circle(p: Point, center: Point, q: Point, d: Vector) -> [Option<(u8, f64, f64)>; 2] {
    // A point that is the pivot stays where it is.
    if p.distance(center) < INDEPENDENT {
        return [None, None];
    }
    let v = p - center;
    let (aside, along, e) = (d.cross(q - center), d.dot(q - center), v.length());
    let square = (e - aside) * (e + aside);
    if square < 0.0 {
        return [None, None];
    }
    [(0, square.sqrt()), (1, -square.sqrt())].map(|(root, half)| {
        let at = d * half + d.left() * aside;
        Some((root, at.angle() - v.angle(), half - along))
    })
}

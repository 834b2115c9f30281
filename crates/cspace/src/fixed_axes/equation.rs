//! Equations in one coordinate: trigonometric for a part that turns, quadratic for one that slides.

use super::condition::Carriers;
use super::condition::Condition;
use super::cycle;
use super::cycle::Cycle;
use super::motion::Motion;
use super::motion::Motions;
use super::tolerance::INDEPENDENT;
use crate::geometry::Point;
use crate::geometry::Rotation;
use crate::geometry::Vector;

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

// Closed-form solutions of contact conditions for one coordinate.

impl Condition {
    /// Whether the root exists at x.
    pub(super) fn exists(&self, x: f64, root: u8) -> bool {
        let rises = root == 0;
        match (self.carriers, self.motions.second) {
            (_, Motion::Still) => false,
            (Carriers::FirstLine { .. }, Motion::Turn { .. }) => {
                self.arm >= self.line_offset(x).abs()
            }
            (Carriers::SecondLine { .. }, Motion::Turn { .. }) => {
                self.bearing.vector(x).length() >= self.offset.abs()
            }
            (Carriers::Circles { radius, .. }, Motion::Turn { .. }) => {
                let m = self.bearing.vector(x).length();
                let (q, r) = (self.arm, radius.abs());
                (q - r).abs() <= m && m <= q + r
            }
            (Carriers::FirstLine { normal, .. }, Motion::Slide { direction }) => {
                let rate = self.motions.first.vector(x, normal).dot(direction);
                if rises { rate > 0.0 } else { rate < 0.0 }
            }
            (Carriers::SecondLine { normal, .. }, Motion::Slide { direction }) => {
                let rate = -normal.dot(direction);
                if rises { rate > 0.0 } else { rate < 0.0 }
            }
            (
                Carriers::Circles {
                    first,
                    second,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let p = self.motions.first.point(x, first);
                direction.cross(p - second).abs() <= radius.abs()
            }
            (Carriers::Cycles { .. }, Motion::Turn { .. }) => {
                self.turned(x).is_some_and(|t| t.0 >= 0.0)
            }
            (Carriers::Cycles { first, second }, Motion::Slide { direction }) => {
                let (square, slope, still) =
                    cycle::along(&first.moved(self.motions.first, x), &second, direction);
                if square != 0.0 {
                    slope * slope >= 2.0 * square * still
                } else if rises {
                    slope > 0.0
                } else {
                    slope < 0.0
                }
            }
        }
    }

    /// n(x)·(l(x) − c₂) + ρ: how far the line, moved out by the radius, is from the second part's pivot.
    fn line_offset(&self, x: f64) -> f64 {
        let (
            Carriers::FirstLine {
                normal,
                through,
                radius,
                ..
            },
            Motion::Turn { center },
        ) = (self.carriers, self.motions.second)
        else {
            return f64::NAN;
        };
        let n = self.motions.first.vector(x, normal);
        n.dot(self.motions.first.point(x, through) - center) + radius
    }

    /// The root at x: continuous in x where it exists; where rounding has just lost it, the double root.
    ///
    /// For a turning second part the condition is a cos (y − φ) = c with y = φ ± acos (c / a), and φ continuous.
    pub(super) fn y(&self, x: f64, root: u8) -> f64 {
        // Root 0 is φ − acos for lines and concave circles, φ + acos for convex ones.
        let sign = if root == 0 { 1.0 } else { -1.0 };
        match (self.carriers, self.motions.second) {
            (_, Motion::Still) => f64::NAN,
            (Carriers::FirstLine { .. }, Motion::Turn { .. }) => {
                let (q, c) = (self.arm, self.line_offset(x));
                let middle = self.motions.first.angle(x) + self.angle;
                middle - sign * root_of((q - c) * (q + c)).atan2(c)
            }
            (Carriers::SecondLine { .. }, Motion::Turn { .. }) => {
                let v = self.bearing.vector(x);
                let (m, c) = (v.length(), self.offset);
                let aside = (c, root_of((m - c) * (m + c)));
                self.angle + self.bearing.turned(x, v, aside, -sign)
            }
            (Carriers::Circles { radius, .. }, Motion::Turn { .. }) => {
                let v = self.bearing.vector(x);
                let (m, q, r) = (v.length(), self.arm, radius.abs());
                // Heron: (2 m q)² − (m² + q² − r²)² = ((m + q)² − r²) (r² − (m − q)²).
                let square = (m + q - r) * (m + q + r) * (r - m + q) * (r + m - q);
                let aside = (m * m + (q - r) * (q + r), root_of(square));
                let sign = sign * radius.signum();
                self.angle + self.bearing.turned(x, v, aside, sign)
            }
            (
                Carriers::FirstLine {
                    normal,
                    through,
                    point,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let n = self.motions.first.vector(x, normal);
                let l = self.motions.first.point(x, through);
                (radius + n.dot(l - point)) / n.dot(direction)
            }
            (
                Carriers::SecondLine {
                    normal,
                    through,
                    point,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let p = self.motions.first.point(x, point);
                (normal.dot(p - through) - radius) / normal.dot(direction)
            }
            (
                Carriers::Circles {
                    first,
                    second,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let v = self.motions.first.point(x, first) - second;
                let (aside, r) = (direction.cross(v), radius.abs());
                direction.dot(v) + sign * radius.signum() * root_of((r - aside) * (r + aside))
            }
            (Carriers::Cycles { .. }, Motion::Turn { .. }) => {
                let Some((room, level)) = self.turned(x) else {
                    return f64::NAN;
                };
                let v = self.bearing.vector(x);
                self.angle + self.bearing.turned(x, v, (level, root_of(room)), sign)
            }
            (Carriers::Cycles { first, second }, Motion::Slide { direction }) => {
                let (square, slope, still) =
                    cycle::along(&first.moved(self.motions.first, x), &second, direction);
                let rate = sign * root_of(slope * slope - 2.0 * square * still);
                // Of two forms that are equal the one in which nothing cancels.
                if (slope < 0.0) == (rate < 0.0) {
                    -2.0 * still / (slope + rate)
                } else {
                    (rate - slope) / square
                }
            }
        }
    }

    /// Calls `found` with every x at which the roots may come or go: where they are double, or infinite.
    pub(super) fn turnings(&self, mut found: impl FnMut(f64)) {
        let Motions { first, second } = self.motions;
        let mut solve = |equation: Equation| equation.roots(&mut found);
        match (self.carriers, second) {
            (_, Motion::Still) | (Carriers::SecondLine { .. }, Motion::Slide { .. }) => {}
            (
                Carriers::FirstLine {
                    normal,
                    through,
                    radius,
                    ..
                },
                Motion::Turn { center },
            ) => {
                let offset = Equation::line_offset(first, normal, through, center);
                solve(offset.plus(radius - self.arm));
                solve(offset.plus(radius + self.arm));
            }
            (Carriers::SecondLine { point, .. }, Motion::Turn { center }) => {
                let square = Equation::distance_squared(first, point, center);
                solve(square.plus(-self.offset * self.offset));
            }
            (
                Carriers::Circles {
                    first: p, radius, ..
                },
                Motion::Turn { center },
            ) => {
                let square = Equation::distance_squared(first, p, center);
                let (q, r) = (self.arm, radius.abs());
                solve(square.plus(-(q + r) * (q + r)));
                solve(square.plus(-(q - r) * (q - r)));
            }
            (Carriers::FirstLine { normal, .. }, Motion::Slide { direction }) => {
                solve(Equation::direction(first, normal, direction));
            }
            (
                Carriers::Circles {
                    first: p,
                    second: q,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let aside = Equation::position(first, p, direction.left(), q);
                solve(aside.plus(-radius));
                solve(aside.plus(radius));
            }
            (
                Carriers::Cycles {
                    first: a,
                    second: b,
                },
                Motion::Turn { center },
            ) => {
                let moment = Equation::moment(first, &a, center);
                for level in cycle::turning_moments(&a, &b, (self.arm, self.offset)) {
                    solve(moment.plus(-level));
                }
            }
            (
                Carriers::Cycles {
                    first: a,
                    second: b,
                },
                Motion::Slide { direction },
            ) => {
                turnings_of_slides(first, &a, &b, direction, &mut found);
            }
        }
    }

    /// With a second part that turns, for cycles at x: what is left of the product of their arms, squared, beside what does not
    /// depend on y, and that.
    fn turned(&self, x: f64) -> Option<(f64, f64)> {
        let (Carriers::Cycles { first, second }, Motion::Turn { center }) =
            (self.carriers, self.motions.second)
        else {
            return None;
        };
        let moments = (
            first.moved(self.motions.first, x).moment(center),
            self.offset,
        );
        Some((
            cycle::room(&first, &second, moments),
            cycle::level(&first, &second, moments),
        ))
    }
}

/// Where the second of two cycles, which slides, passes along the first: (e × V)² = K², V being what [`cycle::centres`] is.
fn turnings_of_slides(first: Motion, a: &Cycle, b: &Cycle, e: Vector, found: &mut impl FnMut(f64)) {
    let total = cycle::total(a, b);
    if b.weight == 0.0 {
        return;
    }
    if a.weight == 0.0 {
        // Along a line.
        Equation::direction(first, a.normal, e).roots(found);
        return;
    }
    match first {
        Motion::Turn { center } => {
            // e × V = λ₁ e × a₂ − λ₂ e × R a₁, seen from the pivot: with T = |e × a₂| and τ = ±T − ρ₂ it is ±K where
            // λ₂ e × R a₁ is λ₁ τ − λ₂ ρ₁, but for the sign. One τ is a difference: both together are ρ₂² − T².
            let (arm, other) = (a.arm(center), b.arm(center));
            let (aside, along) = (e.cross(other), e.dot(other));
            let product = along * along - 2.0 * b.weight * b.moment(center);
            let most = -(aside.abs().copysign(b.size) + b.size);
            let least = if most == 0.0 { 0.0 } else { product / most };
            for (tau, side) in [(most, -b.size), (least, b.size)] {
                let side = 1.0_f64.copysign(side) * 1.0_f64.copysign(aside);
                let equation = Equation::Trig {
                    alpha: -b.weight * e.cross(arm),
                    beta: -b.weight * e.cross(arm.left()),
                    gamma: side * (a.weight * tau - b.weight * a.size),
                };
                // λ₂² |a₁|² − (λ₁ τ − λ₂ ρ₁)², with |a₁|² = ρ₁² + 2 λ₁ m₁.
                let square = a.weight
                    * (2.0 * b.weight * (b.weight * a.moment(center) + a.size * tau)
                        - a.weight * tau * tau);
                equation.roots_of(square, found);
            }
        }
        Motion::Slide { direction } => {
            // e × V changes by −λ₁ λ₂ e × d.
            let rate = a.weight * b.weight * e.cross(direction);
            if e.cross(direction).abs() < INDEPENDENT {
                return;
            }
            let (square, slope, level) = cycle::along(a, b, e);
            let left = slope * slope - 2.0 * square * level;
            let aside = e.cross(cycle::centres(a, b));
            // (K − e × V) (K + e × V) is what is left.
            let far = total.copysign(aside) + aside;
            found(far / rate);
            found(-left / (far * rate));
        }
        Motion::Still => {}
    }
}

fn root_of(square: f64) -> f64 {
    square.max(0.0).sqrt()
}

//! The orientations at which the crossings of two contact curves can come and go.

use cspace::fuzzing::{Carrier, Curve, events};
use cspace::{Point, Spiral, Vector};

use super::capped::is_capped;
use super::trig::{Exact, interval};
use crate::Finding;
use crate::draw::Bytes;
use crate::exact::Dyadic;

/// A condition that varies by less than this, times the lengths it is made of, counts as constant: |u + R w|² = d² varies
/// by 4 |u| |w|, and is known to some roundings of the squares of the lengths of the pair's frame, in which they are 4 at most.
const CONSTANT: f64 = 512.0 * f64::EPSILON;

/// A vector, exactly.
#[derive(Clone)]
struct Exactly {
    x: Dyadic,
    y: Dyadic,
}

impl Exactly {
    fn of(v: Vector) -> Self {
        Self {
            x: Dyadic::of(v.x),
            y: Dyadic::of(v.y),
        }
    }

    fn minus(&self, o: &Self) -> Self {
        Self {
            x: &self.x - &o.x,
            y: &self.y - &o.y,
        }
    }

    fn dot(&self, o: &Self) -> Dyadic {
        &(&self.x * &o.x) + &(&self.y * &o.y)
    }

    /// Turned by a right angle.
    fn left(&self) -> Self {
        Self {
            x: -&self.y,
            y: self.x.clone(),
        }
    }

    fn length(&self) -> f64 {
        self.x.near().hypot(self.y.near())
    }
}

/// u + R w − (u′ + R w′).
fn difference(a: &Spiral, b: &Spiral) -> [Exactly; 2] {
    let u = Exactly::of(a.u.to_vector()).minus(&Exactly::of(b.u.to_vector()));
    (u, Exactly::of(a.w).minus(&Exactly::of(b.w))).into()
}

/// |u + R w|² = d².
fn apart([u, w]: &[Exactly; 2], distance: &Dyadic) -> (Exact, f64) {
    let exact = Exact {
        alpha: u.dot(w).shifted(1),
        beta: u.dot(&w.left()).shifted(1),
        gamma: &(&u.dot(u) + &w.dot(w)) - &distance.square(),
    };
    (exact, u.length() + w.length() + distance.near().abs())
}

/// n·(u + R w) = d, or R n·(u + R w) = d.
fn height(normal: Vector, turns: bool, [u, w]: &[Exactly; 2], distance: &Dyadic) -> (Exact, f64) {
    let n = Exactly::of(normal);
    let (turning, still, across) = if turns {
        // (R n)·u = n·u cos θ + left(n)·u sin θ.
        (u, w, n.left().dot(u))
    } else {
        // n·(R w) = n·w cos θ + n·left(w) sin θ.
        (w, u, n.dot(&w.left()))
    };
    let exact = Exact {
        alpha: n.dot(turning),
        beta: across,
        gamma: &n.dot(still) - distance,
    };
    (exact, 1.0 + distance.near().abs())
}

/// Every condition of the two, as the module documentation of `contact/condition.rs` words it.
fn conditions(f: &Curve, g: &Curve) -> Vec<(Exact, f64)> {
    let mut all = Vec::new();
    for (ends, on) in [(f, g), (g, f)] {
        for end in [&ends.start, &ends.end] {
            all.push(match on.carrier {
                Carrier::Circle(center, radius) => {
                    apart(&difference(end, &center), &Dyadic::of(radius))
                }
                Carrier::Line(n) => height(n, false, &difference(end, &on.start), &Dyadic::zero()),
                Carrier::TurningLine(n) => {
                    height(n, true, &difference(end, &on.start), &Dyadic::zero())
                }
            });
        }
    }
    match (f.carrier, g.carrier) {
        (Carrier::Circle(c, r), Carrier::Circle(d, s)) => {
            let (r, s) = (Dyadic::of(r).abs(), Dyadic::of(s).abs());
            let between = difference(&c, &d);
            all.push(apart(&between, &(&r + &s)));
            all.push(apart(&between, &(&r - &s)));
        }
        (Carrier::Circle(c, r), _) => tangent(&c, r, g, &mut all),
        (_, Carrier::Circle(c, r)) => tangent(&c, r, f, &mut all),
        _ => {}
    }
    all
}

fn tangent(center: &Spiral, radius: f64, line: &Curve, all: &mut Vec<(Exact, f64)>) {
    let (normal, turns) = match line.carrier {
        Carrier::Line(n) => (n, false),
        Carrier::TurningLine(n) => (n, true),
        Carrier::Circle(..) => return,
    };
    let from_line = difference(center, &line.start);
    for distance in [Dyadic::of(radius), Dyadic::of(-radius)] {
        all.push(height(normal, turns, &from_line, &distance));
    }
}

/// Both parts are in the unit disc of the pair's frame.
fn vector(bytes: &mut Bytes<'_>) -> Vector {
    let v = Vector::new(bytes.unit(), bytes.unit());
    v * bytes.one_of(&[0.7, 0.5, 0.5, 1e-3, 1e-6])
}

/// A spiral, perhaps nearly one of those before.
fn spiral(bytes: &mut Bytes<'_>, before: &[Spiral]) -> Spiral {
    let fresh = Spiral::new(Point::ORIGIN + vector(bytes), vector(bytes));
    let Some(other) = before.get(bytes.below(2 * before.len() + 1)) else {
        return fresh;
    };
    let mut spiral = if bytes.below(2) == 0 {
        Spiral {
            u: other.u,
            ..fresh
        }
    } else {
        Spiral {
            w: other.w,
            ..fresh
        }
    };
    spiral.u.x = bytes.nudged(spiral.u.x);
    spiral.w.x = bytes.nudged(spiral.w.x);
    spiral
}

fn curve(bytes: &mut Bytes<'_>, before: &mut Vec<Spiral>) -> Curve {
    let [start, end, center] = [0; 3].map(|_| {
        let next = spiral(bytes, before);
        before.push(next);
        next
    });
    let carrier = match bytes.below(4) {
        0 => Carrier::Line(Vector::from_angle(bytes.orientation())),
        1 => Carrier::TurningLine(Vector::from_angle(bytes.orientation())),
        _ => {
            // A radius at which an end or another centre is on the circle at some orientation, or any.
            let radius = match bytes.below(3) {
                0 => bytes.unit(),
                1 => {
                    let other = before[bytes.below(before.len())];
                    let turn = cspace::Rotation::by(bytes.orientation());
                    let at = |s: &Spiral| s.u + turn * s.w;
                    at(&other).distance(at(&center))
                }
                _ => {
                    let other = before[bytes.below(before.len())];
                    let (u, w) = (other.u - center.u, other.w - center.w);
                    u.length() + w.length() * bytes.one_of(&[1.0, -1.0])
                }
            };
            Carrier::Circle(center, bytes.nudged(radius).clamp(-2.0, 2.0))
        }
    };
    Curve {
        carrier,
        start,
        end,
    }
}

pub(super) fn run(bytes: &mut Bytes<'_>) -> Result<u64, Finding> {
    let mut before = Vec::new();
    let (f, g) = (curve(bytes, &mut before), curve(bytes, &mut before));
    let (mid, half) = interval(bytes);
    let told = events(&f, &g, mid, half);
    let mut judged = 0;
    for (exact, lengths) in conditions(&f, &g) {
        if exact.square() <= Dyadic::of(CONSTANT * lengths).square() {
            continue;
        }
        let (amplitude, slope) = (
            exact.square().near().sqrt(),
            exact.discriminant().near().max(0.0).sqrt(),
        );
        if is_capped(amplitude, slope, lengths) {
            continue;
        }
        for root in exact.roots() {
            judged += 1;
            root.expect(&told, mid, half, || {
                format!(
                    "{:?} cos θ + {:?} sin θ + {:?} of {f:?} and {g:?}",
                    exact.alpha.near(),
                    exact.beta.near(),
                    exact.gamma.near()
                )
            })?;
        }
    }
    Ok(judged)
}

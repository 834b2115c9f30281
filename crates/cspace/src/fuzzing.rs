//! Access to the arithmetic for fuzz targets. Not part of the library's interface: it may change with every version.

use crate::contact::{self, Locus, SheetKind, Spiral, conditions};
use crate::geometry::Vector;
use crate::number::{Ball, Dual, Real, Trig, TrigPolynomial};

/// An orientation and its error, radians.
pub type Root = (f64, f64);

/// A midpoint and a radius.
pub type Enclosure = (f64, f64);

/// The roots of α cos θ + β sin θ + γ from `mid - half` to `mid + half`; `scale` bounds the coefficients.
pub fn trig_roots(coefficients: [f64; 3], scale: f64, mid: f64, half: f64) -> Vec<Root> {
    roots(&Trig::from_coefficients(coefficients, scale), mid, half)
}

fn roots(trig: &Trig, mid: f64, half: f64) -> Vec<Root> {
    let mut all = Vec::new();
    trig.roots(mid, mid.cos(), mid.sin(), half, |e| {
        all.push((e.theta, e.error));
    });
    all
}

/// Data that the events of two contact curves depend on, in the pair's frame, where both parts are in the unit disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Carrier {
    /// A circle of a given radius about a spiral.
    Circle(Spiral, f64),
    /// A line through the sheet's start with a constant normal.
    Line(Vector),
    /// A line through the sheet's start with a turning normal.
    TurningLine(Vector),
}

/// A contact curve by its carrier and its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// The line or circle.
    pub carrier: Carrier,
    /// Start of the curve.
    pub start: Spiral,
    /// End of the curve.
    pub end: Spiral,
}

/// All orientations at which crossings of two contact curves can appear or disappear.
pub fn events(f: &Curve, g: &Curve, mid: f64, half: f64) -> Vec<Root> {
    let mut all = Vec::new();
    let take = |_, condition: Trig| all.extend(roots(&condition, mid, half));
    conditions(&locus(f), &locus(g), [false; 2], |_| true, take);
    all
}

fn locus(curve: &Curve) -> Locus {
    let (kind, through, normal, radius) = match curve.carrier {
        Carrier::Circle(center, radius) => (SheetKind::RoundRound, center, Vector::ZERO, radius),
        Carrier::Line(normal) => (SheetKind::LineRound, curve.start, normal, 0.0),
        Carrier::TurningLine(normal) => (SheetKind::RoundLine, curve.start, normal, 0.0),
    };
    Locus {
        carrier: contact::Carrier {
            kind,
            through,
            normal,
            radius,
        },
        start: curve.start,
        end: curve.end,
    }
}

/// Intervals with the roots of a trigonometric polynomial of degree four at most, given as a function of cosine and sine that also returns
/// the size of its terms; then those in which its sign is unknown.
pub fn polynomial_roots(
    f: impl Fn(f64, f64) -> (f64, f64),
    lo: f64,
    hi: f64,
    narrowest: f64,
) -> [Vec<(f64, f64)>; 2] {
    let [mut found, mut vague] = [Vec::new(), Vec::new()];
    TrigPolynomial::sampled(|turn| f(turn.cos, turn.sin)).brackets(
        lo,
        hi,
        narrowest,
        &mut |lo, hi| found.push((lo, hi)),
        &mut |lo, hi| vague.push((lo, hi)),
    );
    [found, vague]
}

/// Operations on enclosures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a b
    Mul,
    /// a / b
    Over,
    /// √a of the part that is not negative
    Root,
}

fn apply<T: Real>(operation: Operation, a: T, b: T) -> T {
    match operation {
        Operation::Add => a + b,
        Operation::Sub => a - b,
        Operation::Mul => a * b,
        Operation::Over => a / b,
        Operation::Root => a.sqrt(),
    }
}

fn ball((mid, radius): Enclosure) -> Ball {
    Ball::new(mid, radius)
}

fn parts(ball: Ball) -> Enclosure {
    (ball.mid, ball.radius)
}

/// The operation on balls.
pub fn enclose(operation: Operation, a: Enclosure, b: Enclosure) -> Enclosure {
    parts(apply(operation, ball(a), ball(b)))
}

/// The operation on values with derivatives.
pub fn enclose_jet(operation: Operation, a: [Enclosure; 2], b: [Enclosure; 2]) -> [Enclosure; 2] {
    let dual = |[value, slope]: [Enclosure; 2]| Dual {
        value: ball(value),
        slope: [ball(slope)],
    };
    let result: Dual<1, Ball> = apply(operation, dual(a), dual(b));
    [parts(result.value), parts(result.slope[0])]
}

/// The ball of an interval.
pub fn enclose_interval(lo: f64, hi: f64) -> Enclosure {
    parts(Ball::between(lo, hi))
}

/// The sign of all members of a ball; 0 if they do not have one sign.
pub fn sign(a: Enclosure) -> i8 {
    ball(a).sign()
}

/// Cosine and sine of a ball of angles.
pub fn enclose_cos_sin(angle: Enclosure) -> [Enclosure; 2] {
    let (sin, cos) = ball(angle).sin_cos();
    [parts(cos), parts(sin)]
}

//! Prescribed motions: where a driven part is at a time, how fast, and how its rate changes.

use cspace::{Ball, Real};
use cspace_model::{Drive, DriveMotion};

/// A coordinate and its derivatives at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Driven {
    /// Value of the coordinate: radians or the model's unit of length.
    pub value: f64,
    /// Its rate, per second.
    pub rate: f64,
    /// The derivative of the rate.
    pub acceleration: f64,
}

/// A prescribed motion as a function of time.
///
/// A table is a cubic spline through all of its points, twice continuously differentiable, with no curvature at its two ends
/// (a *natural* spline): two points make a motion of constant rate. Before the first point and after the last the value holds,
/// so the rate jumps there unless the table makes it 0.
///
/// ```
/// use cspace_model::{Drive, DriveMotion};
/// use cspace_motion::DriveCurve;
/// let table = DriveMotion::Table(vec![(0.0, 0.0), (1.0, 2.0), (3.0, 2.0)]);
/// let curve = DriveCurve::new(&Drive { part: 0, motion: table }, 0.0);
/// assert_eq!(curve.at(1.0).value, 2.0);
/// assert_eq!(curve.at(7.0).value, 2.0);
/// // (u₂ − u₁)/h₂ − (u₁ − u₀)/h₁ = (h₁ + h₂) u″/3 at the point in the middle.
/// assert!((curve.at(1.0).acceleration + 2.0).abs() < 1e-14);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct DriveCurve {
    shape: Shape,
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Even { start: f64, rate: f64 },
    Spline(Vec<Knot>),
}

/// A point of a table, and the second derivative there.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Knot {
    time: f64,
    value: f64,
    bend: f64,
}

impl DriveCurve {
    /// Creates the motion of a drive whose part starts at `start`; a table ignores it.
    pub fn new(drive: &Drive, start: f64) -> Self {
        let shape = match &drive.motion {
            DriveMotion::Rate(rate) => Shape::Even { start, rate: *rate },
            DriveMotion::Table(points) => Shape::Spline(natural(points)),
        };
        Self { shape }
    }

    /// Motion from one value to another in the first second, at a constant rate; exact at its end.
    pub(crate) fn from_to(from: f64, to: f64) -> Self {
        let shape = Shape::Spline(natural(&[(0.0, from), (1.0, to)]));
        Self { shape }
    }

    /// A part that stands where this one is at a time.
    pub(crate) fn still(&self, time: f64) -> Self {
        let shape = Shape::Even {
            start: self.at(time).value,
            rate: 0.0,
        };
        Self { shape }
    }

    /// Value, rate and acceleration at a time.
    pub fn at(&self, time: f64) -> Driven {
        let still = |value| Driven {
            value,
            rate: 0.0,
            acceleration: 0.0,
        };
        match &self.shape {
            Shape::Even { start, rate } => Driven {
                value: start + rate * time,
                rate: *rate,
                acceleration: 0.0,
            },
            Shape::Spline(knots) => {
                let after = knots.partition_point(|k| k.time <= time);
                match (after.checked_sub(1).map(|i| knots[i]), knots.get(after)) {
                    (Some(a), Some(b)) => between(a, *b, time),
                    // The last point belongs to the table as the first does.
                    (Some(a), None) if time == a.time && knots.len() > 1 => {
                        between(knots[knots.len() - 2], a, time)
                    }
                    (Some(a), None) => still(a.value),
                    (None, first) => still(first.map_or(0.0, |k| k.value)),
                }
            }
        }
    }

    /// Enclosures of value, rate and acceleration over an interval of time with no corner within.
    pub(crate) fn over(&self, [lo, hi]: [f64; 2]) -> [Ball; 3] {
        let time = Ball::between(lo, hi);
        let still = |value| [value, 0.0, 0.0].map(Ball::constant);
        match &self.shape {
            Shape::Even { start, rate } => {
                let rate = Ball::constant(*rate);
                let value = Ball::constant(*start) + rate * time;
                [value, rate, Ball::constant(0.0)]
            }
            Shape::Spline(knots) => {
                let after = knots.partition_point(|k| k.time <= 0.5 * (lo + hi));
                let (Some(a), Some(b)) = (after.checked_sub(1).map(|i| knots[i]), knots.get(after))
                else {
                    return still(self.at(0.5 * (lo + hi)).value);
                };
                // The acceleration is linear, so that its ends bound it, and by it rate and value.
                let middle = between(a, *b, 0.5 * (lo + hi));
                let far = time - Ball::constant(0.5 * (lo + hi));
                let ends = [lo, hi].map(|t| between(a, *b, t).acceleration);
                let bend = Ball::between(ends[0].min(ends[1]), ends[0].max(ends[1]));
                let rate = Ball::constant(middle.rate) + bend * far;
                let value = Ball::constant(middle.value) + rate * far;
                // Terms of the cubic are as large as its points.
                let slack = 8.0 * f64::EPSILON * a.value.abs().max(b.value.abs());
                [value + Ball::new(0.0, slack), rate, bend]
            }
        }
    }

    /// Rate, if it is constant.
    pub fn even_rate(&self) -> Option<f64> {
        match self.shape {
            Shape::Even { rate, .. } => Some(rate),
            Shape::Spline(_) => None,
        }
    }

    /// The times at which it is not smooth: the points of a table.
    pub fn corners(&self) -> impl Iterator<Item = f64> + '_ {
        let knots: &[Knot] = match &self.shape {
            Shape::Even { .. } => &[],
            Shape::Spline(knots) => knots,
        };
        knots.iter().map(|k| k.time)
    }
}

/// The cubic between two points, by their second derivatives.
fn between(a: Knot, b: Knot, time: f64) -> Driven {
    let h = b.time - a.time;
    let (t, s) = ((time - a.time) / h, (b.time - time) / h);
    let sixth = h * h / 6.0;
    let cubic = |s: f64| s * (s * s - 1.0);
    Driven {
        value: s * a.value + t * b.value + sixth * (cubic(s) * a.bend + cubic(t) * b.bend),
        rate: (b.value - a.value) / h
            + h / 6.0 * ((3.0 * t * t - 1.0) * b.bend - (3.0 * s * s - 1.0) * a.bend),
        acceleration: s * a.bend + t * b.bend,
    }
}

/// The second derivatives of a spline without curvature at its ends: a tridiagonal system, solved from the first point to the
/// last and back.
fn natural(points: &[(f64, f64)]) -> Vec<Knot> {
    let n = points.len();
    let mut bend = vec![0.0; n];
    let mut shares = vec![0.0; n];
    for i in 1..n.saturating_sub(1) {
        let ((t0, u0), (t1, u1), (t2, u2)) = (points[i - 1], points[i], points[i + 1]);
        let (before, after) = (t1 - t0, t2 - t1);
        let pivot = 2.0 * (before + after) - before * shares[i - 1];
        shares[i] = after / pivot;
        let turn = 6.0 * ((u2 - u1) / after - (u1 - u0) / before);
        bend[i] = (turn - before * bend[i - 1]) / pivot;
    }
    for i in (1..n.saturating_sub(1)).rev() {
        bend[i] -= shares[i] * bend[i + 1];
    }
    (points.iter().zip(bend))
        .map(|(&(time, value), bend)| Knot { time, value, bend })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_smooth_and_go_through_their_points() {
        let points: Vec<(f64, f64)> = (0..7)
            .map(|i| {
                (
                    f64::from(i) * (1.0 + 0.1 * f64::from(i)),
                    (f64::from(i) * 1.7).sin(),
                )
            })
            .collect();
        let drive = Drive {
            part: 0,
            motion: DriveMotion::Table(points.clone()),
        };
        let curve = DriveCurve::new(&drive, 9.0);
        for &(t, u) in &points {
            assert!((curve.at(t).value - u).abs() < 1e-14);
        }
        let e = 1e-6;
        for &(t, _) in &points[1..6] {
            let (a, b) = (curve.at(t - 1e-12), curve.at(t + 1e-12));
            assert!(
                (a.rate - b.rate).abs() < 1e-9 && (a.acceleration - b.acceleration).abs() < 1e-9
            );
        }
        for k in 1..40 {
            let t = 0.2 * f64::from(k);
            let (a, b) = (curve.at(t - e), curve.at(t + e));
            let here = curve.at(t);
            assert!(((b.value - a.value) / (2.0 * e) - here.rate).abs() < 1e-8);
            assert!(((b.rate - a.rate) / (2.0 * e) - here.acceleration).abs() < 1e-5);
        }
        assert!(curve.at(0.0).acceleration.abs() < 1e-15);
        assert_eq!(
            curve.at(-1.0),
            Driven {
                value: 0.0,
                rate: 0.0,
                acceleration: 0.0
            }
        );
        assert_eq!(curve.corners().count(), 7);
    }
}

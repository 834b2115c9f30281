//! Conditions α cos θ + β sin θ + γ = 0 in double-double, and their roots; see `contact/condition.rs`.

use crate::geometry::Vector;
use crate::number::Dd;

use super::super::condition::{apart_coefficients, height_coefficients};
use super::super::spiral::Spiral;

/// What doubles tell of the roots of a condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rough {
    /// There is none.
    None,
    /// There are these, to within [`Rough::ERROR`].
    At([Option<f64>; 2]),
    /// Nothing is certain.
    Unknown,
}

impl Rough {
    /// Roots that are known worse are not certain (radians).
    pub(crate) const ERROR: f64 = 1e-11;
}

/// The condition p ↦ n·(p − through) − offset at a spiral.
pub(super) fn height(
    normal: Vector<Dd>,
    turns: bool,
    through: &Spiral<Dd>,
    p: &Spiral<Dd>,
    offset: Dd,
) -> Condition {
    let (u, w) = (p.u - through.u, p.w - through.w);
    let (stays, moves) = if turns { (w, u) } else { (u, w) };
    Condition {
        coefficients: height_coefficients(normal, stays, moves, offset, turns),
        scale: size_of(p) + size_of(through) + offset.to_f64().abs(),
        kind: Kind::Height { moves },
    }
}

/// The condition |p − q|² − distance².
pub(super) fn apart(p: &Spiral<Dd>, q: &Spiral<Dd>, distance: Dd) -> Condition {
    let (u, w) = (p.u - q.u, p.w - q.w);
    let distance_size = distance.to_f64().abs();
    let reach = size(u) + size(w) + distance_size;
    let parts = size_of(p) + size_of(q) + distance_size;
    Condition {
        coefficients: apart_coefficients(u, w, distance),
        scale: reach * parts,
        kind: Kind::Apart {
            u,
            w,
            distance: distance.abs(),
            parts,
        },
    }
}

/// The sum of a vector's coordinates, for the rounding of what is computed from it.
fn size(v: Vector<Dd>) -> f64 {
    v.x.to_f64().abs() + v.y.to_f64().abs()
}

fn size_of(p: &Spiral<Dd>) -> f64 {
    size(p.u.to_vector()) + size(p.w)
}

/// α cos θ + β sin θ + γ in double-double, with the size of what its coefficients were made from.
pub(super) struct Condition {
    pub(super) coefficients: [Dd; 3],
    scale: f64,
    kind: Kind,
}

/// What the extreme values of a condition are made of.
enum Kind {
    /// The height of what moves so over a line.
    Height { moves: Vector<Dd> },
    /// |u + R w|² less the square of a distance, made from parts of that size.
    Apart {
        u: Vector<Dd>,
        w: Vector<Dd>,
        distance: Dd,
        parts: f64,
    },
}

/// Error of a coefficient, in units of its scale.
const COEFFICIENT_ERROR: f64 = 64.0 * Dd::EPSILON;

impl Condition {
    /// Value, first and second derivative at an orientation in doubles.
    fn at(&self, theta: f64) -> [Dd; 3] {
        let [alpha, beta, gamma] = self.coefficients;
        let (sin, cos) = Dd::from(theta).sin_cos();
        let wave = alpha * cos + beta * sin;
        [wave + gamma, beta * cos - alpha * sin, -wave]
    }

    /// Whether it has just one root where doubles tell of one, and that is found by [`root_near`](Self::root_near).
    pub(super) fn is_simple(&self, theta: f64) -> bool {
        /// The cube of the distance of a root from where doubles tell it, in double-double, is nothing.
        const NEAR: f64 = 10.0 * Rough::ERROR;
        /// The angle from a double root, at least.
        const FAR: f64 = 1e-3;
        let [alpha, beta, gamma] = self.coefficients.map(Dd::to_f64);
        let (sin, cos) = theta.sin_cos();
        let slope = beta * cos - alpha * sin;
        let value = alpha * cos + beta * sin + gamma;
        slope.abs() > FAR * alpha.hypot(beta)
            && value.abs() <= NEAR * slope.abs()
            && slope.abs() > FAR * self.scale
    }

    /// The root near to where doubles tell it: by the parabola there.
    pub(super) fn root_near(&self, theta: f64) -> (Dd, f64) {
        let [value, slope, bend] = self.at(theta);
        let step = -(value / slope);
        let step = step - step * step * bend / slope * 0.5;
        let error = 2.0 * COEFFICIENT_ERROR * self.scale / slope.to_f64().abs() + COEFFICIENT_ERROR;
        (Dd::from(theta) + step, error)
    }

    /// √(α² + β²) + γ and √(α² + β²) − γ, with their errors: of distances as products of lengths, for of circles of nearly one radius
    /// about nearly one centre the differences of lengths are known, not those of their squares.
    fn extremes(&self) -> [(Dd, f64); 2] {
        match self.kind {
            Kind::Height { moves } => {
                let (amplitude, gamma) = (moves.length(), self.coefficients[2]);
                [amplitude + gamma, amplitude - gamma].map(|x| (x, COEFFICIENT_ERROR * self.scale))
            }
            Kind::Apart {
                u,
                w,
                distance: d,
                parts,
            } => {
                let (a, b) = (u.length(), w.length());
                [(a + b - d, a + b + d), (d - (a - b), d + (a - b))].map(|(x, y)| {
                    let error = COEFFICIENT_ERROR * parts;
                    let sizes = x.to_f64().abs() + y.to_f64().abs();
                    (x * y, error * (sizes + error))
                })
            }
        }
    }

    /// Its roots up to whole turns: as in `number/trig.rs`.
    pub(super) fn roots(&self, mut found: impl FnMut(Dd, f64)) {
        let [alpha, beta, _] = self.coefficients;
        let a = (alpha * alpha + beta * beta).sqrt().to_f64();
        let error = COEFFICIENT_ERROR * self.scale;
        if a <= 4.0 * error {
            return;
        }
        // Vertices are moved so far that a double root is one by the making of the parts: where two arcs face each other, the
        // contact of their ends touches the circle of their contacts. What only touches zero changes nothing.
        let [(most, most_error), (least, least_error)] = self.extremes();
        let (m, l) = (most.to_f64(), least.to_f64());
        if m <= most_error || l <= least_error {
            return;
        }
        let middle = Dd::atan2(beta, alpha);
        let aside = Dd::atan2(most.sqrt(), least.sqrt()).scaled(2.0);
        // By the derivatives of twice the angle whose tangent is √(most / least).
        let of_aside = (m * l).sqrt() / (m + l) * (most_error / m + least_error / l);
        let error = 2.0 * (of_aside + error / a) + COEFFICIENT_ERROR;
        found(middle + aside, error);
        if !aside.is_zero() {
            found(middle - aside, error);
        }
    }
}

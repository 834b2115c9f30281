//! Arcs of ellipses.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

use cspace::part::Bounds;
use cspace::{Point, Vector};

use crate::affine::Affine;

/// The points center + cos t · u + sin t · v for t from `from` to `to`, in radians. Any two conjugate half diameters u and
/// v will do; the arc runs clockwise where `to` is less than `from`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipseArc {
    /// The centre.
    pub center: Point,
    /// Vector from the centre to the point of t = 0.
    pub u: Vector,
    /// Vector from the centre to the point of t = π/2.
    pub v: Vector,
    /// Parameter at the start.
    pub from: f64,
    /// Parameter at the end.
    pub to: f64,
}

impl EllipseArc {
    /// The bulge, tan(sweep / 4), if the ellipse is a circle: u and v of equal length and at a right angle, to rounding.
    /// A full circle has none.
    pub fn bulge(&self) -> Option<f64> {
        /// Rounding of numbers in files, as a share of the radius.
        const ROUND: f64 = 1e-12;
        let (uu, vv) = (self.u.length_squared(), self.v.length_squared());
        let is_round =
            (uu - vv).abs() <= 2.0 * ROUND * uu && self.u.dot(self.v).abs() <= ROUND * uu;
        let sweep = (self.to - self.from) * self.u.cross(self.v).signum();
        (is_round && sweep.abs() < TAU * (1.0 - ROUND)).then(|| (sweep / 4.0).tan())
    }

    /// Spans of at most an eighth of a turn.
    pub(super) fn spans(&self) -> usize {
        let eighths = ((self.to - self.from).abs() / FRAC_PI_4).ceil();
        (eighths as usize).clamp(1, 8)
    }

    pub(super) fn at(&self, span: usize, s: f64) -> (Point, Vector) {
        let step = (self.to - self.from) / self.spans() as f64;
        let t = self.from + (span as f64 + s) * step;
        let (sin, cos) = t.sin_cos();
        (
            self.center + self.u * cos + self.v * sin,
            (self.v * cos - self.u * sin) * step,
        )
    }

    /// The box of the ends and of the points on the arc at which a coordinate is greatest or least.
    pub(super) fn bounds(&self) -> Bounds {
        let point = |t: f64| self.center + self.u * t.cos() + self.v * t.sin();
        let (first, last) = (self.from.min(self.to), self.from.max(self.to));
        let mut bounds = Bounds::of(point(first), point(last));
        for extreme in [self.v.x.atan2(self.u.x), self.v.y.atan2(self.u.y)] {
            let mut t = extreme + PI * ((first - extreme) / PI).ceil();
            for _ in 0..2 {
                if t <= last {
                    bounds = bounds.union(Bounds::of(point(t), point(t)));
                }
                t += PI;
            }
        }
        bounds
    }

    pub(super) fn mapped(&self, map: &Affine) -> Self {
        Self {
            center: map.point(self.center),
            u: map.vector(self.u),
            v: map.vector(self.v),
            ..*self
        }
    }

    pub(super) fn reversed(&self) -> Self {
        Self {
            from: self.to,
            to: self.from,
            ..*self
        }
    }
}

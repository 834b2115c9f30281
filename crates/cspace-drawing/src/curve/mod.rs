//! Smooth curves of drawings: arcs of ellipses and splines, which lines and arcs are fitted to.

mod ellipse;
mod interpolate;
mod sharp;
mod spline;

use cspace::part::Bounds;
use cspace::{Point, Vector};

pub use ellipse::EllipseArc;
pub use interpolate::interpolate;
pub use spline::{Spline, SplineError};

use crate::affine::Affine;

/// A curve that is no line and no arc.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// An arc of an ellipse.
    Ellipse(EllipseArc),
    /// A spline, rational or not; Béziers are splines of one span.
    Spline(Spline),
}

impl Curve {
    /// Start point.
    pub fn start(&self) -> Point {
        self.at(0, 0.0).0
    }

    /// End point.
    pub fn end(&self) -> Point {
        let last = self.spans().saturating_sub(1);
        self.at(last, 1.0).0
    }

    /// Number of spans. Within a span the curve is smooth; where two meet it may have a corner.
    pub fn spans(&self) -> usize {
        match self {
            Self::Ellipse(ellipse) => ellipse.spans(),
            Self::Spline(spline) => spline.spans(),
        }
    }

    /// The point at a fraction s of a span, and the derivative by s.
    pub fn at(&self, span: usize, s: f64) -> (Point, Vector) {
        match self {
            Self::Ellipse(ellipse) => ellipse.at(span, s),
            Self::Spline(spline) => spline.at(span, s),
        }
    }

    /// The box of the curve: exact for an ellipse, of the ends and middles of spans for a spline.
    pub(crate) fn bounds(&self) -> Bounds {
        match self {
            Self::Ellipse(ellipse) => ellipse.bounds(),
            Self::Spline(_) => (0..self.spans())
                .flat_map(|span| [0.0, 0.5, 1.0].map(|s| self.at(span, s).0))
                .fold(Bounds::EMPTY, |all, p| all.union(Bounds::of(p, p))),
        }
    }

    /// The image under an affine map.
    #[must_use]
    pub fn mapped(&self, map: &Affine) -> Self {
        match self {
            Self::Ellipse(ellipse) => Self::Ellipse(ellipse.mapped(map)),
            Self::Spline(spline) => Self::Spline(spline.mapped(map)),
        }
    }

    /// Numbers that no turn, shift or change of size alters, and points that go along: together they determine the curve.
    pub(crate) fn form(&self) -> (Vec<f64>, Vec<Point>) {
        match self {
            Self::Ellipse(e) => (
                vec![e.from, e.to],
                vec![e.center, e.center + e.u, e.center + e.v],
            ),
            Self::Spline(spline) => spline.form(),
        }
    }

    /// Copy of the curve from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Ellipse(ellipse) => Self::Ellipse(ellipse.reversed()),
            Self::Spline(spline) => Self::Spline(spline.reversed()),
        }
    }
}

//! The whole line or circle on which a contact curve lies, at every orientation, in numbers of any kind.

use crate::geometry::{Rotation, Vector};
use crate::number::Real;

use super::cycle::Cycle;
use super::spiral::Spiral;

/// Kinds of features that touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SheetKind {
    /// A line of the fixed part and an arc or vertex of the moving part: the normal is constant.
    LineRound,
    /// An arc or vertex of the fixed part and a line of the moving part: the normal turns with θ.
    RoundLine,
    /// Arcs or vertices of both.
    RoundRound,
    /// As `RoundRound`, where the fixed arc is so large that the curve is a flat arc; its normal is constant.
    FixedFlatArc,
    /// As `RoundRound`, where only the moving arc is so large; the normal turns with θ.
    MovingFlatArc,
}

/// A line or circle that moves with orientation: equations (1)–(3) of Sacks 1999.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Carrier<T = f64> {
    pub(crate) kind: SheetKind,
    /// The centre of a circle; for a line or a flat arc a position on it.
    pub(crate) through: Spiral<T>,
    /// Unit normal of the fixed line, or minus that of the moving line, in its frame. For a flat arc, the normal at `through`; for a
    /// circle 0.
    pub(crate) normal: Vector<T>,
    /// Sum of the signed radii; for a line not used.
    pub(crate) radius: T,
}

impl<T: Real> Carrier<T> {
    /// The line or circle at an orientation.
    #[inline(always)]
    pub(crate) fn cycle(&self, turn: Rotation<T>) -> Cycle<T> {
        let through = self.through.at(turn);
        match self.kind {
            SheetKind::RoundRound => Cycle::round(through, self.radius),
            SheetKind::LineRound | SheetKind::RoundLine => {
                Cycle::line(through, self.normal_at(turn))
            }
            SheetKind::FixedFlatArc | SheetKind::MovingFlatArc => {
                let curvature = T::constant(1.0) / self.radius;
                Cycle::flat(through, self.normal_at(turn), curvature)
            }
        }
    }

    /// Whether the normal turns with the moving part.
    #[inline]
    pub(crate) fn turns(&self) -> bool {
        matches!(self.kind, SheetKind::RoundLine | SheetKind::MovingFlatArc)
    }

    /// The normal at an orientation; not defined for a circle.
    #[inline]
    pub(crate) fn normal_at(&self, turn: Rotation<T>) -> Vector<T> {
        if self.turns() {
            turn * self.normal
        } else {
            self.normal
        }
    }

    /// The spiral of the centre; `None` for a line. For a flat arc it is far away.
    pub(crate) fn center(&self) -> Option<Spiral<T>> {
        let Spiral { u, w, swing } = self.through;
        let arm = self.normal * self.radius;
        match self.kind {
            SheetKind::LineRound | SheetKind::RoundLine => None,
            SheetKind::RoundRound => Some(self.through),
            SheetKind::FixedFlatArc => Some(Spiral {
                u: u + -arm,
                w,
                swing,
            }),
            SheetKind::MovingFlatArc => Some(Spiral {
                u,
                w: w - arm,
                swing,
            }),
        }
    }

    /// A spiral relative to the point of a line, in the frame of its normal: the constant part, and the turning part.
    ///
    /// R n · (u + R w) = n·w + (R n)·u.
    pub(crate) fn seen(&self, spiral: &Spiral<T>) -> (Vector<T>, Vector<T>) {
        let (u, w) = (spiral.u - self.through.u, spiral.w - self.through.w);
        if self.turns() { (w, u) } else { (u, w) }
    }
}

impl Carrier {
    /// The carrier with constants of another kind of numbers.
    #[inline(always)]
    pub(crate) fn lift<T: Real>(&self) -> Carrier<T> {
        Carrier {
            kind: self.kind,
            through: self.through.lift(),
            normal: self.normal.map(T::constant),
            radius: T::constant(self.radius),
        }
    }

    /// The carrier in a frame that does not turn and whose origin is a moving point.
    pub(crate) fn about(&self, origin: &Spiral) -> Self {
        Self {
            through: self.through.about(origin),
            ..*self
        }
    }
}

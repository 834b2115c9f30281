//! The line or circle of a sheet's curve at every orientation, and the curve's ends, in numbers of any kind.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;

use super::carrier::{Carrier, SheetKind};
use super::function::ContactFunction;
use super::spiral::Spiral;

/// A line or circle that moves with orientation, and the two ends of the curve on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Locus<T = f64> {
    pub(crate) kind: SheetKind,
    /// The centre of a circle; for a line the start of its curve, for a flat arc a position on it near the parts.
    pub(crate) through: Spiral<T>,
    /// Unit normal of the fixed line, or minus that of the moving line, in its frame. For a flat arc, the normal at `through`.
    pub(crate) normal: Vector<T>,
    /// Sum of the signed radii.
    pub(crate) radius: T,
    pub(crate) start: Spiral<T>,
    pub(crate) end: Spiral<T>,
}

impl<T: Real> Locus<T> {
    /// The line or circle on which the curve lies.
    #[inline(always)]
    pub(crate) fn carrier(&self) -> Carrier<T> {
        Carrier {
            kind: self.kind,
            through: self.through,
            normal: self.normal,
            radius: self.radius,
        }
    }

    /// Start and end of the curve at an orientation.
    #[inline(always)]
    pub(crate) fn ends(&self, turn: Rotation<T>) -> [Point<T>; 2] {
        [self.start, self.end].map(|p| p.at(turn))
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
        if self.carrier().turns() {
            (w, u)
        } else {
            (u, w)
        }
    }
}

impl Locus {
    /// The locus in a frame that does not turn and whose origin is a moving point.
    pub(crate) fn about(&self, origin: &Spiral) -> Self {
        Self {
            through: self.through.about(origin),
            start: self.start.about(origin),
            end: self.end.about(origin),
            ..*self
        }
    }

    /// The contact function.
    pub(crate) fn function(&self) -> ContactFunction {
        let Self {
            through,
            normal,
            radius,
            ..
        } = *self;
        match self.kind {
            SheetKind::LineRound => ContactFunction::FixedLine { normal, through },
            SheetKind::RoundLine => ContactFunction::MovingLine { normal, through },
            SheetKind::RoundRound => ContactFunction::Circle {
                center: through,
                radius,
            },
            SheetKind::FixedFlatArc | SheetKind::MovingFlatArc => ContactFunction::FlatCircle {
                through,
                normal,
                turns: self.carrier().turns(),
                radius,
            },
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
pub(super) mod tests;

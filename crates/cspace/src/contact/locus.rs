//! The line or circle of a sheet's curve at every orientation, and the curve's ends, in numbers of any kind.

use crate::feature::Outline;
use crate::geometry::{Point, Rotation, Vector};
use crate::number::{Dd, Real};

use super::cycle::Cycle;
use super::function::ContactFunction;
use super::sheet::{EndAt, Sheet, SheetKind};
use super::spiral::Spiral;

/// A line or circle that moves with orientation, and the two ends of the curve on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Locus<T = f64> {
    pub(crate) kind: SheetKind,
    /// The centre of a circle; of a line the start of its curve, of a flat arc a position near the parts on it.
    pub(crate) through: Spiral<T>,
    /// Unit normal of the fixed line, or minus that of the moving line, in its frame. Of a flat arc, where it goes through its point.
    pub(crate) normal: Vector<T>,
    /// Sum of the signed radii.
    pub(crate) radius: T,
    pub(crate) start: Spiral<T>,
    pub(crate) end: Spiral<T>,
}

impl<T: Real> Locus<T> {
    /// All of the line or circle at an orientation.
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

    /// Where the curve starts and ends at an orientation.
    #[inline(always)]
    pub(crate) fn ends(&self, turn: Rotation<T>) -> [Point<T>; 2] {
        [self.start, self.end].map(|p| p.at(turn))
    }

    /// Whether the normal turns with the moving part.
    #[inline]
    pub(crate) fn turns(&self) -> bool {
        matches!(self.kind, SheetKind::RoundLine | SheetKind::MovingFlatArc)
    }

    /// The normal at an orientation. Not of a circle.
    #[inline]
    pub(crate) fn normal_at(&self, turn: Rotation<T>) -> Vector<T> {
        if self.turns() {
            turn * self.normal
        } else {
            self.normal
        }
    }

    /// The spiral of the centre, unless it is a line. Of a flat arc it is far away.
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

    /// A spiral from the point of a line, in the frame of its normal: the part that stays, and the part that turns.
    ///
    /// R n · (u + R w) = n·w + (R n)·u.
    pub(crate) fn seen(&self, spiral: &Spiral<T>) -> (Vector<T>, Vector<T>) {
        let (u, w) = (spiral.u - self.through.u, spiral.w - self.through.w);
        if self.turns() { (w, u) } else { (u, w) }
    }
}

impl Locus {
    /// In a frame that does not turn and has a moving point for its origin.
    pub(crate) fn about(&self, origin: &Spiral) -> Self {
        Self {
            through: self.through.about(origin),
            start: self.start.about(origin),
            end: self.end.about(origin),
            ..*self
        }
    }

    /// Its contact function.
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
                turns: self.turns(),
                radius,
            },
        }
    }
}

impl Locus<Dd> {
    /// The locus of a sheet by the outlines in double-double.
    ///
    /// A flat arc goes through the point at which it has the normal that it is written by in doubles.
    pub(super) fn exact(fixed: &Outline, moving: &Outline, sheet: &Sheet) -> Self {
        let (a, b) = (
            &fixed.exact_features[sheet.fixed as usize],
            &moving.exact_features[sheet.moving as usize],
        );
        let end = |at| match at {
            EndAt::Fixed(j) => {
                let j = &fixed.exact_joints[j as usize];
                Spiral::new(j.point + j.normal * b.radius, -b.center.to_vector())
            }
            EndAt::Moving(j) => {
                let j = &moving.exact_joints[j as usize];
                Spiral::new(a.center, -(j.point + j.normal * a.radius).to_vector())
            }
        };
        let (start, end) = (end(sheet.start_at), end(sheet.end_at));
        let line = |outline: &Outline, feature: u32| {
            let joint = outline.features[feature as usize].start;
            outline.exact_joints[joint as usize].normal
        };
        let kind = sheet.locus.kind;
        let radius = a.radius + b.radius;
        let center = Spiral::new(a.center, -b.center.to_vector());
        let rough = sheet.locus.normal.map(Dd::from);
        let (through, normal) = match kind {
            SheetKind::LineRound => (start, line(fixed, sheet.fixed)),
            SheetKind::RoundLine => (start, -line(moving, sheet.moving)),
            SheetKind::RoundRound => (center, rough),
            SheetKind::FixedFlatArc => {
                let normal = rough.unit();
                (Spiral::new(center.u + normal * radius, center.w), normal)
            }
            SheetKind::MovingFlatArc => {
                let normal = rough.unit();
                (Spiral::new(center.u, center.w + normal * radius), normal)
            }
        };
        Self {
            kind,
            through,
            normal,
            radius,
            start,
            end,
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
pub(super) mod tests;

//! The curve of a sheet at one orientation in double-double: places on it, and crossings.

use crate::number::Dd;
use crate::number::plane::{Xy, cross, dot, left, length, minus, plus, times, turned};

use super::super::carrier::{Carrier, place_on};
use super::carrier::ExactCarrier;

/// The curve of a sheet at one orientation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCurve {
    pub(super) carrier: ExactCarrier,
    pub(super) start: Xy<Dd>,
    pub(super) end: Xy<Dd>,
    /// From the centre of a circle to about the middle of the curve, of length about one.
    pub(super) middle: Xy<Dd>,
    /// How places on a large circle are told.
    pub(super) chart: Option<Chart>,
}

/// Places on a large circle as doubles have them: by the tangent of half the angle about its centre from a point near the parts
/// (see `flat_arc.rs`), which differs from the length of travel in the third order; counted from the middle of the curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chart {
    pub(super) through: Xy<Dd>,
    pub(super) normal: Xy<Dd>,
    pub(super) curvature: Dd,
    pub(super) middle: Dd,
}

impl Chart {
    /// The place of a point, from where the circle is told.
    pub(super) fn of(&self, p: Xy<Dd>) -> Dd {
        let d = minus(p, self.through);
        let fall = self.curvature * dot(self.normal, d);
        dot(left(self.normal), d) / (fall.scaled(0.5) + 1.0)
    }

    /// The point at a place, to the rounding of the point near the parts.
    fn point(&self, place: Dd) -> Xy<Dd> {
        let u = place + self.middle;
        let half = u * self.curvature.scaled(0.5);
        let t = u / (half * half + 1.0);
        let way = plus(times(left(self.normal), t), times(self.normal, -(t * half)));
        plus(self.through, way)
    }
}

/// A crossing of two curves.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCrossing {
    /// Where it is on the first curve, as `place_on` gives it.
    pub(crate) on: Xy<Dd>,
    pub(crate) point: Xy<Dd>,
    pub(crate) enters: bool,
}

impl ExactCurve {
    /// Length of travel from about the middle of the curve to a point of it, given as `place_on` gives it; where carriers do not cross,
    /// the nearest place to that.
    pub(crate) fn length_of(&self, v: Xy<Dd>) -> Dd {
        if let Some(chart) = &self.chart {
            return chart.of(self.carrier.point(v)) - chart.middle;
        }
        match self.carrier.carrier {
            Carrier::Line { normal, .. } => {
                let all = dot(left(normal), minus(self.end, self.start));
                v.0 - all.scaled(0.5)
            }
            Carrier::Circle { radius, .. } => {
                Dd::atan2(cross(self.middle, v), dot(self.middle, v)) * radius
            }
            Carrier::FlatArc(_) => Dd::ZERO,
        }
    }

    /// What grows with the length of travel to a point, given as `place_on` gives it: on a circle y / (|x| + |y|) along and across
    /// the direction to its middle, continued beyond the quarter turns.
    pub(crate) fn rank(&self, v: Xy<Dd>) -> Dd {
        let Carrier::Circle { radius, .. } = self.carrier.carrier else {
            return v.0;
        };
        let (x, y) = (dot(self.middle, v), cross(self.middle, v));
        let y = if radius.is_negative() { -y } else { y };
        let quarter = y / (x.abs() + y.abs());
        if !x.is_negative() {
            quarter
        } else if y.is_negative() {
            -quarter - 2.0
        } else {
            -quarter + 2.0
        }
    }

    /// Where a point of the plane is on the curve, as `place_on` gives it.
    pub(super) fn on(&self, p: Xy<Dd>) -> Xy<Dd> {
        match self.carrier.carrier {
            Carrier::Line { normal, through } => (dot(left(normal), minus(p, through)), Dd::ZERO),
            Carrier::Circle { center, .. } => minus(p, center),
            Carrier::FlatArc(_) => (Dd::ZERO, Dd::ZERO),
        }
    }

    /// The places of its ends.
    pub(crate) fn ends(&self) -> (Dd, Dd) {
        self.ends_by(|v| self.length_of(v))
    }

    /// The same by what grows with the length of travel, and is its negative as far before the middle.
    fn ends_by(&self, place: impl Fn(Xy<Dd>) -> Dd) -> (Dd, Dd) {
        let (start, end) = (place(self.on(self.start)), place(self.on(self.end)));
        match self.carrier.carrier {
            // All of a circle ends where it starts, half a turn from the middle.
            Carrier::Circle { .. } if start > end && self.chart.is_none() => {
                if start.abs() > end.abs() {
                    (-start.abs(), end)
                } else {
                    (start, end.abs())
                }
            }
            _ => (start, end),
        }
    }

    /// Whether a place of its carrier, as `place_on` gives it, is between its ends.
    pub(super) fn holds(&self, v: Xy<Dd>) -> bool {
        let between = |place: Dd, (lo, hi): (Dd, Dd)| lo < place && place < hi;
        if self.chart.is_some() {
            between(self.length_of(v), self.ends())
        } else {
            between(self.rank(v), self.ends_by(|v| self.rank(v)))
        }
    }

    /// The point at a place, given as a length of travel from about the middle.
    pub(crate) fn point(&self, place: Dd) -> Xy<Dd> {
        match self.carrier.carrier {
            Carrier::Line { normal, .. } => {
                let middle = times(plus(self.start, self.end), Dd::from(0.5));
                plus(middle, times(left(normal), place))
            }
            Carrier::Circle { center, radius } => {
                let way = if let Some(chart) = &self.chart {
                    minus(chart.point(place), center)
                } else {
                    let (sin, cos) = (place / radius).sin_cos();
                    turned(self.middle, cos, sin)
                };
                let far = times(way, radius.abs() / length(way));
                plus(center, far)
            }
            Carrier::FlatArc(_) => self.start,
        }
    }

    /// Where it starts and ends.
    pub(crate) fn end_points(&self) -> [Xy<Dd>; 2] {
        [self.start, self.end]
    }

    /// Its carrier.
    pub(crate) fn carrier(&self) -> &ExactCarrier {
        &self.carrier
    }

    /// On which side of it a point beside it is: whether on that of its line's normal, or outside of its circle.
    pub(crate) fn side_of(&self, p: Xy<Dd>) -> Option<bool> {
        let off = match self.carrier.carrier {
            Carrier::Line { normal, through } => dot(normal, minus(p, through)),
            Carrier::Circle { center, radius } => length(minus(p, center)) - radius.abs(),
            Carrier::FlatArc(_) => return None,
        };
        self.holds(self.on(p)).then_some(!off.is_negative())
    }

    /// The crossing with the given name, wherever it lies on the carriers.
    pub(crate) fn crossing(&self, other: &Self, root: u8) -> Option<ExactCrossing> {
        let lines = matches!(
            (&self.carrier.carrier, &other.carrier.carrier),
            (Carrier::Line { .. }, Carrier::Line { .. })
        );
        if !self.carrier.meets(&other.carrier) || (lines && root > 0) {
            return None;
        }
        let root = self.carrier.own_root(&other.carrier, root);
        let v = place_on(&self.carrier.carrier, &other.carrier.carrier, root, false);
        let point = self.carrier.point(v);
        Some(ExactCrossing {
            on: v,
            point,
            enters: self.carrier.enters(&other.carrier, root),
        })
    }

    /// How far outward along a direction from a point its carrier lies, near that point.
    pub(crate) fn height(&self, p: Xy<Dd>, outward: Xy<Dd>) -> Dd {
        match self.carrier.carrier {
            Carrier::Line { normal, through } => {
                dot(normal, minus(through, p)) / dot(normal, outward)
            }
            Carrier::Circle { center, radius } => {
                let v = minus(p, center);
                let off = length(v) - radius.abs();
                if dot(v, outward).is_negative() {
                    off
                } else {
                    -off
                }
            }
            Carrier::FlatArc(_) => Dd::ZERO,
        }
    }
}

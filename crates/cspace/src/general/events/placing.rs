//! Where branches lie along the contact curve of a sheet at one orientation.

use crate::contact::{
    Carrier, ExactCarrier, ExactCurve, ExactSheet, ExactTurn, Geometry, place_error, place_on,
};
use crate::geometry::{Point, Rotation, Vector, wrap};
use crate::number::Dd;
use crate::number::Real;
use crate::number::plane::{Xy, cross, dot};

use crate::general::events::branch::Branch;

/// A sheet at one orientation, able to place branches along its curve.
pub(crate) struct Placing<'a> {
    geometry: &'a Geometry,
    index: u32,
    carrier: Carrier<f64>,
    turn: Rotation,
    half: f64,
    mid_angle: f64,
    /// The place of the middle, on a line from its start, on a flat arc from its point.
    middle: f64,
}

/// Where a branch comes among those on a curve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rank {
    pub(crate) rank: f64,
    v: (f64, f64),
    error: f64,
}

/// A sheet at one orientation in double-double, able to place branches along its curve.
pub(crate) struct ExactPlacing<'a> {
    geometry: &'a Geometry,
    index: u32,
    turn: ExactTurn,
    curve: ExactCurve,
}

impl<'a> ExactPlacing<'a> {
    pub(crate) fn new(geometry: &'a Geometry, index: u32, turn: ExactTurn) -> Self {
        Self {
            geometry,
            index,
            turn,
            curve: exact_sheet(geometry, index).curve(&turn),
        }
    }

    /// The place of a branch: length of travel from about the middle of the curve.
    pub(crate) fn place(&self, b: &Branch) -> Dd {
        self.curve.length_of(self.crossed_by(b).1)
    }

    /// The same, and how far rounding may have moved it (length): circles are told by their centres, and the larger they are and the
    /// blunter they cross, the worse a place is known.
    pub(crate) fn place_and_rounding(&self, b: &Branch) -> (Dd, f64) {
        let (other, v) = self.crossed_by(b);
        let sheets = &self.geometry.contacts.sheets;
        let radius = |s: u32| sheets[s as usize].radius.abs();
        let size = radius(self.index).max(radius(b.other(self.index))).max(1.0);
        let sharpness = self.sharpness_at(&other, v).max(f64::MIN_POSITIVE);
        (self.curve.length_of(v), Dd::EPSILON * size / sharpness)
    }

    /// What a branch crosses the curve with, and where, as [`place_on`] gives it.
    fn crossed_by(&self, b: &Branch) -> (ExactCarrier, Xy<Dd>) {
        let other = exact_sheet(self.geometry, b.other(self.index)).carrier(&self.turn);
        let v = (self.curve.carrier()).crossed_by(&other, b.root, b.second == self.index);
        (other, v)
    }

    /// What orders branches by their places, as the places themselves would, at less cost: see [`Placing::ranking`].
    pub(crate) fn rank(&self, b: &Branch) -> Dd {
        self.curve.rank(self.crossed_by(b).1)
    }

    /// The sine of the angle at which a branch crosses the curve, about.
    pub(crate) fn sharpness(&self, b: &Branch) -> f64 {
        let (other, v) = self.crossed_by(b);
        self.sharpness_at(&other, v)
    }

    /// The same where another carrier crosses it.
    fn sharpness_at(&self, other: &ExactCarrier, v: Xy<Dd>) -> f64 {
        let point = self.curve.carrier().point(v);
        let normals = [self.curve.carrier(), other].map(|c| c.normal(point));
        cross(normals[0], normals[1]).to_f64().abs()
    }

    /// The point at a place, rounded.
    pub(crate) fn point(&self, place: Dd) -> Point {
        let p = self.curve.point(place);
        Point::new(p.0.to_f64(), p.1.to_f64())
    }

    /// Whether the carrier of another sheet lies further out than the place, in a direction.
    pub(crate) fn is_covered_by(&self, place: Dd, other: u32, outward: Vector) -> bool {
        let other = exact_sheet(self.geometry, other).curve(&self.turn);
        let outward = (Dd::from(outward.x), Dd::from(outward.y));
        !other.height(self.curve.point(place), outward).is_negative()
    }

    /// The places of the ends.
    pub(crate) fn ends(&self) -> (Dd, Dd) {
        self.curve.ends()
    }
}

/// How far one place on a carrier is before another: on a line a difference of lengths; on a circle the sine of the angle between
/// them, times the radius, and beyond quarter turns what goes on from that.
pub(crate) fn between<T: Real>(carrier: &Carrier<T>, p: Xy<T>, q: Xy<T>) -> T {
    let Carrier::Circle { radius, .. } = *carrier else {
        return p.0 - q.0;
    };
    let sine = cross(p, q) / radius;
    if dot(p, q).value() >= 0.0 {
        return sine;
    }
    let twice = T::constant(2.0) * radius;
    if (sine.value() < 0.0) == (radius.value() < 0.0) {
        twice - sine
    } else {
        -twice - sine
    }
}

/// A sheet in double-double.
pub(crate) fn exact_sheet(geometry: &Geometry, index: u32) -> ExactSheet<'_> {
    let sheet = &geometry.contacts.sheets[index as usize];
    ExactSheet::new(&geometry.fixed, &geometry.moving, sheet)
}

impl<'a> Placing<'a> {
    pub(crate) fn new(geometry: &'a Geometry, index: u32, theta: f64) -> Self {
        Self::turned_by(geometry, index, theta, Rotation::by(theta))
    }

    /// The same given the rotation by the orientation.
    pub(crate) fn turned_by(
        geometry: &'a Geometry,
        index: u32,
        theta: f64,
        turn: Rotation,
    ) -> Self {
        let sheet = &geometry.contacts.sheets[index as usize];
        let (half, mid_angle) = if sheet.is_circle() {
            let (from, to) = (sheet.start_angle.at(theta), sheet.end_angle.at(theta));
            (
                0.5 * (to - from).abs() * sheet.radius.abs(),
                0.5 * (from + to),
            )
        } else {
            let length = sheet
                .normal_at(turn)
                .left()
                .dot(sheet.end.at(turn) - sheet.start.at(turn));
            (0.5 * length, 0.0)
        };
        let carrier = sheet.carrier(turn.cos, turn.sin);
        let (mut half, mut middle) = (half, half);
        if let Carrier::FlatArc(arc) = &carrier {
            let ends = [sheet.start, sheet.end].map(|s| arc.place(s.at(turn)));
            // Beside the orientations at which it exists, a curve has its ends in the wrong order; they move fast.
            half = (0.5 * (ends[1] - ends[0])).max(0.0);
            middle = 0.5 * (ends[0] + ends[1]);
        }
        Self {
            geometry,
            index,
            carrier,
            turn,
            half,
            mid_angle,
            middle,
        }
    }

    /// Half the length of the contact curve.
    pub(crate) fn half(&self) -> f64 {
        self.half
    }

    /// How fast the ends move, and what they cross there (length per radian).
    pub(crate) fn speed(&self) -> f64 {
        /// The largest speed of what is told about a centre near the parts.
        const SPEED: f64 = 4.0;
        let sheet = &self.geometry.contacts.sheets[self.index as usize];
        if !sheet.is_flat() {
            return SPEED;
        }
        let ends = [sheet.start, sheet.end].map(|s| s.turning().length());
        SPEED + ends[0].max(ends[1])
    }

    /// The place of a branch: length of travel from the middle of the curve. Where the crossing is just lost, the
    /// nearest place to one.
    pub(crate) fn place(&self, b: &Branch) -> f64 {
        let (f, g) = self.carriers(b);
        self.length_of(place_on(&f, &g, b.root, b.second == self.index))
    }

    /// The carrier of the sheet.
    pub(crate) fn carrier(&self) -> &Carrier<f64> {
        &self.carrier
    }

    /// Where a branch crosses the carrier, as [`place_on`] gives it, and its rounding error; infinite where it is not known, and
    /// of large arcs.
    pub(crate) fn crossed_by(&self, b: &Branch) -> ((f64, f64), f64) {
        let (f, g) = self.carriers(b);
        let v = place_on(&f, &g, b.root, b.second == self.index);
        let flat = [&f, &g].iter().any(|c| matches!(c, Carrier::FlatArc(_)));
        if flat || v.0.is_nan() || v.1.is_nan() {
            return (v, f64::INFINITY);
        }
        (v, place_error(&f, &g, v))
    }

    /// The place, not beyond the ends of the curve, and its rounding error.
    pub(crate) fn within(&self, b: &Branch) -> (f64, f64) {
        let (v, error) = self.crossed_by(b);
        if !error.is_finite() {
            return (0.0, f64::INFINITY);
        }
        let place = self.length_of(v);
        let half = self.half.max(0.0);
        (place.clamp(-half, half), error)
    }

    /// What orders branches by their places, as the places themselves would, at less cost; with the place as [`place_on`] gives
    /// it, and its error.
    ///
    /// On a circle it grows with the angle from the middle of the curve: y / (|x| + |y|) along and across that
    /// direction, continued beyond the quarter turns.
    pub(crate) fn ranking(&self) -> impl Fn(&Branch) -> Rank {
        let middle = match self.carrier {
            Carrier::Line { .. } | Carrier::FlatArc(_) => Vector::ZERO,
            Carrier::Circle { radius, .. } => Vector::from_angle(self.mid_angle) * radius.signum(),
        };
        move |b| {
            let (v, error) = self.crossed_by(b);
            let rank = match self.carrier {
                Carrier::Line { .. } | Carrier::FlatArc(_) => v.0,
                Carrier::Circle { radius, .. } => {
                    let v = Vector::new(v.0, v.1);
                    let (x, y) = (middle.dot(v), middle.cross(v) * radius.signum());
                    let quarter = y / (x.abs() + y.abs());
                    if x >= 0.0 {
                        quarter
                    } else {
                        2.0_f64.copysign(y) - quarter
                    }
                }
            };
            Rank { rank, v, error }
        }
    }

    /// Whether two places that follow each other are apart by more than their errors.
    pub(crate) fn are_apart(&self, p: &Rank, q: &Rank) -> bool {
        /// Errors are estimates; this much worse they may be.
        const MARGIN: f64 = 8.0;
        between(&self.carrier, p.v, q.v).abs() > MARGIN * (p.error + q.error)
    }

    /// The carriers of the sheet and of what a branch crosses.
    fn carriers(&self, b: &Branch) -> (Carrier<f64>, Carrier<f64>) {
        let other = &self.geometry.contacts.sheets[b.other(self.index) as usize];
        (self.carrier, other.carrier(self.turn.cos, self.turn.sin))
    }

    /// Length of travel from the middle to a place as [`place_on`] gives it.
    fn length_of(&self, v: (f64, f64)) -> f64 {
        match self.carrier {
            Carrier::Line { .. } | Carrier::FlatArc(_) => v.0 - self.middle,
            Carrier::Circle { radius, .. } => {
                let v = Vector::new(v.0, v.1) * radius.signum();
                wrap(v.angle() - self.mid_angle) * radius
            }
        }
    }
}

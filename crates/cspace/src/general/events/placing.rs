//! Where branches lie along the contact curve of a sheet at one orientation.

use crate::contact::{Cycle, ExactCurve, ExactSheet, ExactTurn, Geometry};
use crate::geometry::{Point, Rotation, Vector, wrap};
use crate::number::Dd;
use crate::number::Real;

use crate::general::events::branch::Branch;

/// A sheet at one orientation, able to place branches along its curve.
pub(crate) struct Placing<'a> {
    geometry: &'a Geometry,
    index: u32,
    cycle: Cycle,
    turn: Rotation,
    half: f64,
    mid_angle: f64,
    /// The place of the middle; not of a circle by its centre.
    middle: f64,
}

/// Where a branch comes among those on a curve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rank {
    pub(crate) rank: f64,
    place: Vector,
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

    /// What a branch crosses the curve with, and at which place.
    fn crossed_by(&self, b: &Branch) -> (Cycle<Dd>, Vector<Dd>) {
        let other = exact_sheet(self.geometry, b.other(self.index)).cycle(&self.turn);
        let place = (self.curve.cycle()).root(&other, b.root, b.second == self.index);
        (other, place)
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

    /// The sine of the angle at which another cycle crosses it at a place.
    fn sharpness_at(&self, other: &Cycle<Dd>, place: Vector<Dd>) -> f64 {
        let point = self.curve.cycle().at(place);
        let [m, n] = [self.curve.cycle(), other].map(|c| c.normal_at(point));
        m.cross(n).to_f64().abs()
    }

    /// The point at a place, rounded.
    pub(crate) fn point(&self, place: Dd) -> Point {
        self.curve.point(place).map(Dd::to_f64)
    }

    /// Whether the line or circle of another sheet lies further out than the place, in a direction.
    pub(crate) fn is_covered_by(&self, place: Dd, other: u32, outward: Vector) -> bool {
        let other = exact_sheet(self.geometry, other).curve(&self.turn);
        let outward = outward.map(Dd::from);
        !other.height(self.curve.point(place), outward).is_negative()
    }

    /// The places of the ends.
    pub(crate) fn ends(&self) -> (Dd, Dd) {
        self.curve.ends()
    }
}

/// How far one place on a cycle is before another: on a line a difference of lengths; on a circle by its centre the sine of the
/// angle between them, times the radius, and beyond quarter turns what goes on from that.
pub(crate) fn between<T: Real>(cycle: &Cycle<T>, p: Vector<T>, q: Vector<T>) -> T {
    if !cycle.is_centred() {
        return p.x - q.x;
    }
    let radius = cycle.radius();
    let sine = p.cross(q) / radius;
    if p.dot(q).value() >= 0.0 {
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
        let cycle: Cycle = sheet.cycle(turn);
        let (mut half, mut middle) = (half, half);
        if sheet.is_flat_arc() {
            let ends = [sheet.start, sheet.end].map(|s| cycle.place(s.at(turn)).x);
            // Beside the orientations at which it exists, a curve has its ends in the wrong order; they move fast.
            half = (0.5 * (ends[1] - ends[0])).max(0.0);
            middle = 0.5 * (ends[0] + ends[1]);
        }
        Self {
            geometry,
            index,
            cycle,
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
        self.length_of(
            self.cycle
                .root(&self.other(b), b.root, b.second == self.index),
        )
    }

    /// All of the sheet's line or circle.
    pub(crate) fn cycle(&self) -> &Cycle {
        &self.cycle
    }

    /// Where a branch crosses the cycle, and the rounding error of the place; infinite where it is not known, and of large circles.
    pub(crate) fn crossed_by(&self, b: &Branch) -> (Vector, f64) {
        let other = self.other(b);
        let place = self.cycle.root(&other, b.root, b.second == self.index);
        if self.cycle.is_large() || other.is_large() || place.x.is_nan() || place.y.is_nan() {
            return (place, f64::INFINITY);
        }
        (place, self.cycle.place_error(&other, place))
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

    /// What orders branches by their places, as the places themselves would, at less cost; with the place on the
    /// cycle, and its error: see [`Cycle::rank`].
    pub(crate) fn ranking(&self) -> impl Fn(&Branch) -> Rank {
        let middle = Vector::from_angle(self.mid_angle) * self.cycle.weight;
        move |b| {
            let (place, error) = self.crossed_by(b);
            let rank = self.cycle.rank(place, middle);
            Rank { rank, place, error }
        }
    }

    /// Whether two places that follow each other are apart by more than their errors.
    pub(crate) fn are_apart(&self, p: &Rank, q: &Rank) -> bool {
        /// Errors are estimates; this much worse they may be.
        const MARGIN: f64 = 8.0;
        between(&self.cycle, p.place, q.place).abs() > MARGIN * (p.error + q.error)
    }

    /// All of the line or circle that a branch crosses.
    fn other(&self, b: &Branch) -> Cycle {
        self.geometry.contacts.sheets[b.other(self.index) as usize].cycle(self.turn)
    }

    /// Length of travel from the middle to a place on the cycle.
    fn length_of(&self, place: Vector) -> f64 {
        if self.cycle.is_centred() {
            let v = place * self.cycle.weight;
            return wrap(v.angle() - self.mid_angle) * self.cycle.radius();
        }
        place.x - self.middle
    }
}

//! Places of branches along the contact curve of a sheet at one orientation.

use crate::contact::{Curve, Cycle, Exact, Geometry, Orientation, Precision};
use crate::geometry::{Point, Vector};
use crate::number::Real;

use crate::general::events::branch::Branch;

/// A sheet at one orientation, prepared for placing branches along its curve.
pub(crate) struct Placing<'a, T = f64> {
    geometry: &'a Geometry,
    index: u32,
    at: Orientation<T>,
    curve: Curve<T>,
}

/// Rank of a branch among those on a curve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rank {
    pub(crate) rank: f64,
    place: Vector,
    error: f64,
}

impl Rank {
    /// The place on the cycle, and its error.
    pub(crate) fn known(&self) -> (Vector, f64) {
        (self.place, self.error)
    }
}

impl<'a, T: Precision> Placing<'a, T> {
    pub(crate) fn new(geometry: &'a Geometry, index: u32, at: Orientation<T>) -> Self {
        Self {
            geometry,
            index,
            at,
            curve: geometry.curve(index, &at),
        }
    }

    /// The place of a branch: length of travel from about the middle of the curve. Where the crossing has just disappeared, the nearest
    /// place to one.
    pub(crate) fn place(&self, b: &Branch) -> T {
        self.curve.length_to(self.crossed_by(b).1)
    }

    /// Value that orders branches as their places do, at less cost: see [`Cycle::rank`].
    pub(crate) fn rank(&self, b: &Branch) -> T {
        self.curve.rank(self.crossed_by(b).1)
    }

    /// The curve that a branch crosses this one with, and the place of the crossing on its cycle.
    fn crossed_by(&self, b: &Branch) -> (Cycle<T>, Vector<T>) {
        let other = self.geometry.cycle(b.other(self.index), self.at.turn);
        let place = (self.curve.cycle).root(&other, b.root, b.second == self.index);
        (other, place)
    }

    /// Approximate sine of the angle at which a branch crosses the curve.
    pub(crate) fn sharpness(&self, b: &Branch) -> f64 {
        let (other, v) = self.crossed_by(b);
        sharpness(&self.curve.cycle, &other, v)
    }

    /// Lengths of travel to the ends.
    pub(crate) fn ends(&self) -> (T, T) {
        self.curve.ends()
    }

    /// The curve.
    pub(crate) fn curve(&self) -> &Curve<T> {
        &self.curve
    }
}

/// The sine of the angle at which a cycle is crossed by another at a place on it.
fn sharpness<T: Real>(cycle: &Cycle<T>, other: &Cycle<T>, place: Vector<T>) -> f64 {
    let point = cycle.at(place);
    let [m, n] = [cycle, other].map(|c| c.normal_at(point));
    m.cross(n).value().abs()
}

/// Bound, in double-double, of the rounding of the place where two sheets cross, on the cycle of the first (length): circles are given by
/// their centres, and the larger they are and the smaller the angle, the larger the error of a place.
pub(super) fn rounding(
    geometry: &Geometry,
    sheets: [u32; 2],
    [cycle, other]: [&Cycle<Exact>; 2],
    place: Vector<Exact>,
) -> f64 {
    let radii = sheets.map(|s| Exact::locus(geometry, s).carrier.radius.to_f64().abs());
    let size = radii[0].max(radii[1]).max(1.0);
    Exact::EPSILON * size / sharpness(cycle, other, place).max(f64::MIN_POSITIVE)
}

impl Placing<'_, Exact> {
    /// The place of a branch, and its [rounding] (length).
    pub(crate) fn place_and_rounding(&self, b: &Branch) -> (Exact, f64) {
        let (other, v) = self.crossed_by(b);
        let sheets = [self.index, b.other(self.index)];
        let rounding = rounding(self.geometry, sheets, [&self.curve.cycle, &other], v);
        (self.curve.length_to(v), rounding)
    }

    /// The point at a place, rounded.
    pub(crate) fn point(&self, place: Exact) -> Point {
        self.curve.point(place).map(Exact::to_f64)
    }

    /// Whether the line or circle of another sheet lies further out than the place, in a direction.
    pub(crate) fn is_covered_by(&self, place: Exact, other: u32, outward: Vector) -> bool {
        let other = self.geometry.curve(other, &self.at);
        let outward = outward.map(Exact::from);
        !other.height(self.curve.point(place), outward).is_negative()
    }
}

impl Placing<'_> {
    /// Half the length of the contact curve.
    pub(crate) fn half(&self) -> f64 {
        self.curve.half
    }

    /// Largest speed of the ends, and of the crossings there (length per radian).
    pub(crate) fn speed(&self) -> f64 {
        /// Largest speed of points given relative to a centre near the parts.
        const SPEED: f64 = 4.0;
        let sheet = &self.geometry.contacts.sheets[self.index as usize];
        if !sheet.is_flat() {
            return SPEED;
        }
        let ends = [sheet.locus.start, sheet.locus.end].map(|s| s.turning().length());
        SPEED + ends[0].max(ends[1])
    }

    /// Place where a branch crosses the cycle, and its rounding error; infinite where the place is not known, and for large circles.
    pub(crate) fn place_and_error(&self, b: &Branch) -> (Vector, f64) {
        let (other, place) = self.crossed_by(b);
        let cycle = &self.curve.cycle;
        if cycle.is_large() || other.is_large() || place.x.is_nan() || place.y.is_nan() {
            return (place, f64::INFINITY);
        }
        (place, cycle.place_error(&other, place))
    }

    /// The place, limited to the ends of the curve, and its rounding error.
    pub(crate) fn within(&self, b: &Branch) -> (f64, f64) {
        let (v, error) = self.place_and_error(b);
        if !error.is_finite() {
            return (0.0, f64::INFINITY);
        }
        let half = self.curve.half;
        (self.curve.length_to(v).clamp(-half, half), error)
    }

    /// Value that orders branches as their places do, with the place on the cycle and its error.
    pub(crate) fn ranking(&self, b: &Branch) -> Rank {
        let (place, error) = self.place_and_error(b);
        let rank = self.curve.rank(place);
        Rank { rank, place, error }
    }
}

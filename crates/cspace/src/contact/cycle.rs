//! Oriented circles: the one form of lines, arcs and contact curves, in any arithmetic.
//!
//! A cycle (Lie's name) has a point P, the unit normal n there towards its free side, a weight λ and a size ρ. Its level at a place p, with
//! d = p − P, is
//!
//! ```text
//! F(p) = n·d + λ (d² − c) / 2,   ∇F = n + λ d,   |∇F|² = ρ² + 2 λ F,
//! ```
//!
//! positive on the free side; the distance of p along the normal is 2 F / (ρ + √(ρ² + 2 λ F)).
//!
//! | | P | n | λ | ρ | c | F |
//! |---|---|---|---|---|---|---|
//! | line (equation 1 of Sacks 1999) | on it | normal | 0 | 1 | 0 | n·d |
//! | large circle of signed radius r | on it, near the parts | normal there | 1/r | 1 | 0 | n·d + d²/2r |
//! | circle of signed radius r (equations 2 and 3) | centre | 0 | sign r | \|r\| | r² | ±(d² − r²)/2 |
//!
//! A large circle is written by a point near the parts, so that no number in it is large and a place on it is as accurate as that point,
//! however far away the centre is. A circle whose centre is among the parts is written by its centre, because it may be as small as a
//! point.
//!
//! Travel is to the left of the normal, with blocked space on the left.

use crate::feature::{Feature, Outline};
use crate::geometry::{Point, Rotation, Vector};
use crate::number::{Dd, Real};
use crate::part::Edge;

/// An oriented circle or line.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Cycle<T = f64> {
    pub(crate) through: Point<T>,
    /// Unit normal at the point; zero for a cycle written by its centre.
    pub(crate) normal: Vector<T>,
    pub(crate) weight: T,
    pub(crate) size: T,
}

impl<T: Real> Cycle<T> {
    /// A line, given by a point and the normal.
    pub(crate) fn line(through: Point<T>, normal: Vector<T>) -> Self {
        Self::flat(through, normal, T::constant(0.0))
    }

    /// The line or circle of an edge, with its free side on the right of travel. A line may have a curvature of which only the derivatives
    /// are not 0.
    pub(crate) fn of_edge(edge: &Edge<T>) -> Self {
        /// Bulge above which arcs are written by their centre, which is then near them.
        const NEAR_CENTER: f64 = 0.125;
        let (chord, half, one) = (edge.end - edge.start, T::constant(0.5), T::constant(1.0));
        let middle = edge.start + chord * half + chord.right() * (half * edge.bulge);
        let normal = chord.right() * (one / chord.length());
        let curvature = edge.curvature();
        if edge.bulge.value().abs() > NEAR_CENTER {
            let radius = one / curvature;
            return Self::round(middle + normal * -radius, radius);
        }
        Self::flat(middle, normal, curvature)
    }

    /// A circle, given by its centre and signed radius.
    pub(crate) fn round(center: Point<T>, radius: T) -> Self {
        let zero = T::constant(0.0);
        Self {
            through: center,
            normal: Vector::new(zero, zero),
            weight: T::constant(radius.value().signum()),
            size: radius.abs(),
        }
    }

    /// A circle or line, given by a point, the normal there and the curvature 1/r.
    pub(crate) fn flat(through: Point<T>, normal: Vector<T>, curvature: T) -> Self {
        Self {
            through,
            normal,
            weight: curvature,
            size: T::constant(1.0),
        }
    }

    #[inline]
    pub(crate) fn is_line(&self) -> bool {
        self.weight.value() == 0.0
    }

    /// Whether the cycle is written by its centre.
    #[inline]
    pub(crate) fn is_centred(&self) -> bool {
        self.normal.x.value() == 0.0 && self.normal.y.value() == 0.0
    }

    /// Whether the cycle is a circle written by a point on it.
    #[inline]
    pub(crate) fn is_large(&self) -> bool {
        !(self.is_line() || self.is_centred())
    }

    /// The signed radius of a circle written by its centre.
    #[inline]
    pub(crate) fn radius(&self) -> T {
        self.size * self.weight
    }

    /// Curvature 1/r; 0 for a line.
    pub(crate) fn curvature(&self) -> T {
        self.weight / self.size
    }

    /// The level at a place, positive on the free side.
    #[inline]
    pub(crate) fn level(&self, p: Point<T>) -> T {
        let d = p - self.through;
        if self.is_line() {
            return self.normal.dot(d);
        }
        let bend = T::constant(0.5) * self.weight;
        if self.is_centred() {
            return bend * (d.length_squared() - self.size * self.size);
        }
        self.normal.dot(d) + bend * d.length_squared()
    }

    /// The gradient of the level: at a place on the cycle, the normal times the size.
    #[inline]
    pub(crate) fn slope(&self, p: Point<T>) -> Vector<T> {
        if self.is_line() {
            return self.normal;
        }
        self.normal + (p - self.through) * self.weight
    }

    /// The signed distance of a place along the normal, positive on the free side.
    #[inline]
    pub(crate) fn distance(&self, p: Point<T>) -> T {
        if self.is_centred() {
            return (self.through.distance(p) - self.size) * self.weight;
        }
        let level = self.level(p);
        if self.is_line() {
            return level;
        }
        let steepness = self.size * self.size + T::constant(2.0) * self.weight * level;
        self.off(steepness.sqrt(), level)
    }

    /// The signed distance of a place at which the length of the gradient and the level are known.
    #[inline]
    pub(crate) fn off(&self, gradient: T, level: T) -> T {
        if self.is_centred() {
            return (gradient - self.size) * self.weight;
        }
        T::constant(2.0) * level / (self.size + gradient)
    }

    /// The unit normal towards the free side at a place on it.
    #[inline]
    pub(crate) fn normal_at(&self, p: Point<T>) -> Vector<T> {
        let slope = self.slope(p);
        if self.is_centred() {
            return slope * (T::constant(1.0) / self.size);
        }
        slope
    }

    /// The point of a circle with a given unit normal.
    pub(crate) fn place_of_normal(&self, normal: Vector<T>) -> Point<T> {
        if self.is_centred() {
            return self.through + normal * self.radius();
        }
        self.through + (normal - self.normal) * (T::constant(1.0) / self.weight)
    }

    /// The cycle with its free side and its blocked side exchanged.
    pub(crate) fn reversed(&self) -> Self {
        Self {
            normal: -self.normal,
            weight: -self.weight,
            ..*self
        }
    }

    /// The cycle turned, and then moved.
    pub(crate) fn moved(&self, turn: Rotation<T>, by: Vector<T>) -> Self {
        Self {
            through: turn * self.through + by,
            normal: turn * self.normal,
            ..*self
        }
    }
}

impl Cycle<Dd> {
    /// The cycle rounded to f64.
    pub(crate) fn rounded(&self) -> Cycle {
        Cycle {
            through: self.through.map(Dd::to_f64),
            normal: self.normal.map(Dd::to_f64),
            weight: self.weight.to_f64(),
            size: self.size.to_f64(),
        }
    }
}

/// Places on a cycle. For a cycle written by its centre they are vectors (x, y) from there; for any other (u, 0) with u = 2/κ tan(φ/2),
/// where φ is the angle about the centre from P: u increases with travel, and on a line it is the length itself.
impl<T: Real> Cycle<T> {
    /// The point at a place.
    #[inline]
    pub(crate) fn at(&self, place: Vector<T>) -> Point<T> {
        if self.is_centred() {
            return self.through + place;
        }
        if self.is_line() {
            return self.through + self.normal.left() * place.x;
        }
        let half = T::constant(0.5) * self.weight * place.x;
        let along = place.x / (T::constant(1.0) + half * half);
        self.through + self.normal.left() * along - self.normal * (along * half)
    }

    /// The place of a point of the cycle.
    #[inline]
    pub(crate) fn place(&self, p: Point<T>) -> Vector<T> {
        let d = p - self.through;
        if self.is_centred() {
            return d;
        }
        let mut u = self.normal.left().dot(d);
        if !self.is_line() {
            let fall = T::constant(0.5) * self.weight * self.normal.dot(d);
            u = u / (T::constant(1.0) + fall);
        }
        Vector::new(u, T::constant(0.0))
    }

    /// A number that increases with the place: for a circle given by its centre y / (|x| + |y|), with x along and y across the direction to
    /// the middle of a curve on it, continued beyond quarter turns.
    #[inline]
    pub(crate) fn rank(&self, place: Vector<T>, middle: Vector<T>) -> T {
        if !self.is_centred() {
            return place.x;
        }
        let (x, y) = (middle.dot(place), middle.cross(place) * self.weight);
        let (quarter, two) = (y / (x.abs() + y.abs()), T::constant(2.0));
        if x.value() >= 0.0 {
            quarter
        } else if y.value() < 0.0 {
            -two - quarter
        } else {
            two - quarter
        }
    }

    /// The crossing with the given name: its place, and whether travel enters the blocked side of the other cycle there. `None` if they do
    /// not cross; two lines cross if the sine of their angle is above `parallel`.
    pub(crate) fn crossing(
        &self,
        other: &Self,
        root: u8,
        parallel: f64,
    ) -> Option<(Vector<T>, bool)> {
        let named = root == 0 || !(self.is_line() && other.is_line());
        (named && self.meets(other, parallel)).then(|| {
            let enters = self.enters(other, root);
            (self.crossed_by(other, enters), enters)
        })
    }

    /// The place where travel crosses another cycle, entering its blocked side or leaving it. Where the crossing has just disappeared, the
    /// nearest place to one. Two parallel lines do not cross: the place is infinite or NaN.
    ///
    /// The other's level on this cycle, from P on, is ((k − κ a·n)/2 + c κ²/4) u² + a·t u + c over 1 + κ²u²/4, with its gradient a, weight
    /// k and level c at P; its derivative by u is negative where its blocked side is entered.
    #[inline]
    pub(crate) fn crossed_by(&self, other: &Self, enters: bool) -> Vector<T> {
        if self.is_centred() {
            return self.way_vector_of_crossing(other, enters);
        }
        if other.is_centred() {
            // Where this cycle enters the blocked side of the other, the other leaves that of this one.
            return self.place(other.through + other.way_vector_of_crossing(self, !enters));
        }
        let real = T::constant;
        let (a, c) = (other.slope(self.through), other.level(self.through));
        let (square, slope) = self.parabola(other, a, c);
        if self.is_line() && other.is_line() {
            return Vector::new(-c / slope, real(0.0));
        }
        let root = (slope * slope - real(4.0) * square * c).sqrt();
        let steep = if enters { -root } else { root };
        // Of two equivalent forms, the one without cancellation.
        let u = if enters == (slope.value() < 0.0) {
            real(-2.0) * c / (slope + steep)
        } else {
            (steep - slope) / (real(2.0) * square)
        };
        Vector::new(u, real(0.0))
    }

    /// The coefficients of u² and u.
    fn parabola(&self, other: &Self, a: Vector<T>, c: T) -> (T, T) {
        let (n, k, half) = (self.normal, self.weight, T::constant(0.5));
        let mut square = half * other.weight;
        if !self.is_line() {
            square = square + half * k * (half * c * k - a.dot(n));
        }
        (square, a.dot(n.left()))
    }

    /// The vector from the centre of this cycle to its crossing with another.
    ///
    /// The vector v has the length ρ, and a·v = h = −(c + k ρ²/2) with the other's gradient a and level c at the centre. With δ,
    /// the distance of the centre from the other, and its size K, ρ² a² − h² = (ρ − δ)(ρ + δ)(K + |a| − k ρ)(K + |a| + k ρ)/4:
    /// Heron's formula, in which no two squares cancel.
    fn way_vector_of_crossing(&self, other: &Self, enters: bool) -> Vector<T> {
        let (a, c, product) = self.heron(other);
        let half = T::constant(0.5);
        let mut along = -c;
        if !other.is_line() {
            along = along - half * other.weight * self.size * self.size;
        }
        let root = half * product.sqrt();
        let across = if enters == (self.weight.value() > 0.0) {
            root
        } else {
            -root
        };
        let arm = a * along + a.left() * across;
        if other.is_line() {
            return arm;
        }
        arm * (T::constant(1.0) / a.length_squared())
    }

    /// The other's gradient and level at the centre of this one, and 4 (ρ² a² − h²).
    fn heron(&self, other: &Self) -> (Vector<T>, T, T) {
        let (a, c, r) = (
            other.slope(self.through),
            other.level(self.through),
            self.size,
        );
        if other.is_line() {
            return (a, c, T::constant(4.0) * (r - c) * (r + c));
        }
        let length = a.length();
        let (steep, bend) = (other.size + length, other.weight * r);
        let off = other.off(length, c);
        let product = (r - off) * (r + off) * (steep - bend) * (steep + bend);
        (a, c, product)
    }

    /// Whether two cycles cross: at a positive angle; for two lines, with a sine of the angle above `parallel`.
    pub(crate) fn meets(&self, other: &Self, parallel: f64) -> bool {
        if self.is_centred() {
            return self.heron(other).2.value() > 0.0;
        }
        if other.is_centred() {
            return other.heron(self).2.value() > 0.0;
        }
        let (a, c) = (other.slope(self.through), other.level(self.through));
        let (square, slope) = self.parabola(other, a, c);
        if self.is_line() && other.is_line() {
            return slope.value().abs() > parallel;
        }
        (slope * slope - T::constant(4.0) * square * c).value() > 0.0
    }

    /// The centre of a circle; not finite for a line.
    fn center(&self) -> Point<T> {
        if self.is_centred() {
            return self.through;
        }
        self.through - self.normal * (T::constant(1.0) / self.weight)
    }

    /// Whether both are one line or circle, traversed in either direction, within `same` (length, and sine of an angle).
    pub(crate) fn is_one_with(&self, other: &Self, same: f64) -> bool {
        let is_none = |x: T| x.value().abs() < same;
        match (self.is_line(), other.is_line()) {
            (true, true) => {
                is_none(self.normal.cross(other.normal)) && is_none(other.level(self.through))
            }
            (false, false) => {
                let [r, s] = [self, other].map(|c| c.size / c.weight.abs());
                is_none(r - s) && is_none(self.center().distance(other.center()))
            }
            _ => false,
        }
    }

    /// Whether travel along it enters the blocked side of another cycle at the crossing with the given name.
    ///
    /// Two lines have one crossing. On a line and a circle by its centre, root 0 comes first along the line. On two circles by
    /// their centres, root 0 lies right of the line from the centre of this one to that of the other. With a large circle, this one
    /// enters at root 1.
    pub(crate) fn enters(&self, other: &Self, root: u8) -> bool {
        let second = root == 1;
        let outer = |c: &Self| c.weight.value() > 0.0;
        match (self.is_line(), other.is_line()) {
            (true, true) => other.normal.dot(self.normal.left()).value() < 0.0,
            (true, false) if other.is_centred() => second != outer(other),
            (false, true) if self.is_centred() => second == outer(self),
            (false, false) if self.is_centred() && other.is_centred() => {
                (second != outer(self)) == outer(other)
            }
            _ => second,
        }
    }

    /// The place on this cycle of the crossing with the given name; `swapped` if this cycle is the second of the two in that name.
    #[inline]
    pub(crate) fn root(&self, other: &Self, root: u8, swapped: bool) -> Vector<T> {
        let enters = if swapped {
            !other.enters(self, root)
        } else {
            self.enters(other, root)
        };
        self.crossed_by(other, enters)
    }
}

/// Two cycles that touch from outside, with opposite normals: carriers of features of two parts.
///
/// With the levels m₁ and m₂ of a place and the gradients there, of which the opposites a₁ and a₂ are the *arms* of the place,
///
/// ```text
/// G = λ₁ m₂ + λ₂ m₁ − a₁·a₂ − ρ₁ ρ₂
/// ```
///
/// does not depend on the place. It vanishes where the cycles touch and is positive where they are apart: it is λ₁ λ₂ / 2 times the excess
/// of the square of the distance of the centres over that of the sum of the radii. With K = λ₁ ρ₂ + λ₂ ρ₁, the sum of the radii times λ₁
/// λ₂, and V = λ₁ a₂ − λ₂ a₁, the vector from centre to centre times λ₁ λ₂, V² = K² + 2 λ₁ λ₂ G, and the distance along the common normal
/// is 2 G / (K + |V|). Cycles that can touch from outside have K > 0; where they do, V is K times the normal of the first. Others, as an
/// arc in a smaller fillet, have K < 0: they are tangent where |V| = −K.
impl<T: Real> Cycle<T> {
    /// a: minus the gradient at a place, λ times the vector to the centre if there is one.
    #[inline]
    pub(crate) fn arm(&self, from: Point<T>) -> Vector<T> {
        (self.through - from) * self.weight - self.normal
    }

    /// K.
    #[inline]
    pub(crate) fn total(&self, other: &Self) -> T {
        self.weight * other.size + other.weight * self.size
    }

    /// V.
    #[inline]
    pub(crate) fn between(&self, other: &Self) -> Vector<T> {
        let way = (other.through - self.through) * (self.weight * other.weight);
        way + self.normal * other.weight - other.normal * self.weight
    }

    /// G. With the vector d from `through` to `through` it is λ₁ λ₂ d²/2 + (λ₂ n₁ − λ₁ n₂)·d − n₁·n₂ and constants.
    pub(crate) fn apart(&self, other: &Self) -> T {
        let (d, half) = (other.through - self.through, T::constant(0.5));
        let still = if self.is_centred() || other.is_centred() {
            self.still(other)
        } else {
            // 1 + n₁·n₂, without the cancelling.
            -half * (self.normal + other.normal).length_squared()
        };
        half * self.weight * other.weight * d.length_squared()
            + (self.normal * other.weight - other.normal * self.weight).dot(d)
            + still
    }

    /// G without a₁·a₂, as seen from a place: the part that stays constant when one of both turns about it.
    pub(crate) fn still_about(&self, other: &Self, place: Point<T>) -> T {
        let raised = |c: &Self| c.level(place) - c.own_level();
        other.weight * raised(self) + self.weight * raised(other) + self.still(other)
    }

    /// The terms of G that depend neither on d nor on the normals.
    fn still(&self, other: &Self) -> T {
        if self.is_centred() && other.is_centred() {
            // Radii that almost cancel leave no rounding.
            let total = self.total(other);
            return T::constant(-0.5) * self.weight * other.weight * total * total;
        }
        let levels = other.weight * self.own_level() + self.weight * other.own_level();
        levels - self.size * other.size
    }

    /// The level at `through`.
    fn own_level(&self) -> T {
        if self.is_centred() {
            T::constant(-0.5) * self.weight * self.size * self.size
        } else {
            T::constant(0.0)
        }
    }

    /// Distance of the cycles along their common normal: 2 G / (K ± |V|), with the sign of K.
    pub(crate) fn gap(&self, other: &Self) -> T {
        let (total, weights) = (self.total(other), self.weight * other.weight);
        let signed = |length: T| if total.value() < 0.0 { -length } else { length };
        if self.is_centred() && other.is_centred() {
            return (signed(self.between(other).length()) - total) * weights;
        }
        let (apart, two) = (self.apart(other), T::constant(2.0));
        let length = (total * total + two * weights * apart).sqrt();
        two * apart / (total + signed(length))
    }

    /// The normal of this cycle along which the distance is measured: V / |V|, with the sign of K.
    pub(crate) fn common_normal(&self, other: &Self) -> Vector<T> {
        let between = self.between(other);
        let sign = if self.total(other).value() < 0.0 {
            -1.0
        } else {
            1.0
        };
        between * (T::constant(sign) / between.length())
    }

    /// K − u·V for a unit vector u; its product with K + u·V is K² − (u·V)².
    pub(crate) fn beside(&self, other: &Self, u: Vector<T>) -> T {
        self.weight * other.support(self.through, -u) + other.weight * self.support(self.through, u)
    }

    /// ρ + u·a for a unit vector u: λ times the distance of the tangent with the normal −u from a place. There is no cancellation if u is
    /// almost the normal of a large circle.
    pub(crate) fn support(&self, from: Point<T>, u: Vector<T>) -> T {
        let own = if self.is_centred() {
            self.size
        } else {
            T::constant(0.5) * (u - self.normal).length_squared()
        };
        own + self.weight * u.dot(self.through - from)
    }
}

/// Rounding error of a place, in the pair's frame; to be divided by the sine of the angle of crossing.
pub(crate) const PLACE_ERROR: f64 = 1e-14;

/// Rounding error of a place on a circle given by its centre, in units of the radius: coordinates of the centre, sums of them and the
/// distance from there are rounded.
const CENTER_ERROR: f64 = 8.0 * f64::EPSILON;

impl Cycle {
    /// The line or circle that a feature is a piece of.
    pub(crate) fn of(outline: &Outline, feature: &Feature) -> Self {
        match feature.near {
            _ if feature.is_line() => {
                let start = outline.start(feature);
                Self::line(start.point, start.normal)
            }
            Some(near) => Self::flat(near.point, near.normal, 1.0 / feature.radius),
            None => Self::round(feature.center, feature.radius),
        }
    }

    /// The cycle in numbers of another kind.
    pub(crate) fn lift<T: Real>(&self) -> Cycle<T> {
        Cycle {
            through: self.through.map(T::constant),
            normal: self.normal.map(T::constant),
            weight: T::constant(self.weight),
            size: T::constant(self.size),
        }
    }

    /// Bound of the rounding error of the place at which another cycle crosses this one.
    ///
    /// The larger the angle of crossing, the smaller the error. Towards a tangency of curves that bend apart, the error grows at most like
    /// the square root of the rounding; where two cycles become one, it has no bound.
    pub(crate) fn place_error(&self, other: &Self, place: Vector) -> f64 {
        let p = self.at(place);
        // The place may be off the circle if there is no crossing, or none is left by rounding.
        let off = if self.is_centred() {
            (place.length() - self.size).abs()
        } else {
            0.0
        };
        let slope = self.slope(p);
        let normal = slope * (1.0 / slope.length());
        let beside = other.normal_at(p);
        // Curvature relative to the other cycle, on its side of the common tangent.
        let bend = self.curvature() - other.curvature() * normal.dot(beside).signum();
        let sine = normal.cross(beside).abs();
        let rounding = PLACE_ERROR.max(CENTER_ERROR * self.size.max(other.size));
        let error = off + rounding / sine.max((0.5 * rounding * bend.abs()).sqrt());
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// tan(φ/4) of the angle φ about the centre from one place to another of a cycle that is not written by its centre, positive
    /// counter-clockwise; 0 if the places have passed each other.
    pub(crate) fn bulge(&self, from: Vector, to: Vector) -> f64 {
        let (half, from, to) = (0.5 * self.weight, from.x, to.x.max(from.x));
        let angle = 2.0 * ((half * (to - from)) / (1.0 + half * half * from * to)).atan();
        (0.25 * angle).tan()
    }

    /// The distances at which the ray p + t d meets the cycle, in any order, d being a unit vector: |∇F|² = ρ² + 2 λ F, so that the square
    /// under the root is (∇F·d)² − 2 λ F = ρ² − (∇F × d)².
    pub(crate) fn met(&self, p: Point, d: Vector) -> [f64; 2] {
        let (a, level) = (self.slope(p), self.level(p));
        let slope = a.dot(d);
        let square = if self.is_centred() {
            (self.size - a.cross(d)) * (self.size + a.cross(d))
        } else {
            slope * slope - 2.0 * self.weight * level
        };
        let sum = -(slope + square.sqrt().copysign(slope));
        [2.0 * level / sum, sum / self.weight]
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;

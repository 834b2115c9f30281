//! Edge of a boundary.

use super::plane::{Frame, Place};
use super::real::Real;

/// A line segment or circular arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct Curve<S> {
    pub(super) start: Place<S>,
    pub(super) end: Place<S>,
    /// Sign of the bulge: the arc turns left (1) or right (−1), or is a line (0).
    pub(super) turn: i8,
    /// Centre and radius of an arc; the start and zero for a line.
    pub(super) center: Place<S>,
    pub(super) radius: S,
}

/// Arcs of a larger radius are flat, in chords.
const FLAT: f64 = 100.0;

/// A point of a curve with a number that grows along the curve.
pub(super) type Mark<S> = (S, Place<S>);

impl<S: Real> Curve<S> {
    pub(super) fn new(start: Place<S>, end: Place<S>, bulge: f64) -> Self {
        if bulge == 0.0 {
            return Self {
                start,
                end,
                turn: 0,
                center: start,
                radius: S::zero(),
            };
        }
        let b = S::of(bulge);
        let chord = end - start;
        let one = S::of(1.0);
        let quarter = one / (S::of(4.0) * b);
        let middle = (start + end).times(S::of(0.5));
        Self {
            start,
            end,
            turn: if bulge > 0.0 { 1 } else { -1 },
            center: middle + chord.left().times((one - b) * (one + b) * quarter),
            radius: chord.length() * (one + b * b) * quarter.magnitude(),
        }
    }

    pub(super) fn is_line(&self) -> bool {
        self.turn == 0
    }

    #[inline]
    pub(super) fn moved(&self, turn: (S, S), shift: Place<S>) -> Self {
        Self {
            start: self.start.moved(turn, shift),
            end: self.end.moved(turn, shift),
            center: self.center.moved(turn, shift),
            ..*self
        }
    }

    /// The box about the curve, to the precision of doubles.
    #[inline]
    pub(super) fn frame(&self) -> Frame {
        let rough = self.rough();
        let mut frame = Frame::around(rough.start, rough.end);
        let chord = (rough.end - rough.start).length();
        if rough.turn != 0 && rough.radius > FLAT * chord {
            // An arc is c² / 8 r high over its chord, and more by less than a share of c² / r²; about the centre, rounding
            // would be more than that.
            let height = chord * (0.25 * chord / rough.radius);
            for i in 0..2 {
                frame.low[i] -= height;
                frame.high[i] += height;
            }
        } else if rough.turn != 0 {
            let (c, r) = (rough.center, rough.radius);
            if rough.spans(Place::new(c.x - r, c.y)) {
                frame.low[0] = c.x - r;
            }
            if rough.spans(Place::new(c.x + r, c.y)) {
                frame.high[0] = c.x + r;
            }
            if rough.spans(Place::new(c.x, c.y - r)) {
                frame.low[1] = c.y - r;
            }
            if rough.spans(Place::new(c.x, c.y + r)) {
                frame.high[1] = c.y + r;
            }
        }
        frame
    }

    #[inline]
    pub(super) fn rough(&self) -> Curve<f64> {
        Curve {
            start: self.start.rough(),
            end: self.end.rough(),
            turn: self.turn,
            center: self.center.rough(),
            radius: self.radius.to_f64(),
        }
    }

    /// Positive when the point is left of the chord.
    #[inline]
    pub(super) fn side(&self, p: Place<S>) -> S {
        (self.end - self.start).cross(p - self.start)
    }

    /// Whether the arc contains a point of its circle: the points on the arc's side of the chord.
    #[inline]
    pub(super) fn spans(&self, p: Place<S>) -> bool {
        let side = self.side(p);
        if self.turn > 0 {
            side <= S::zero()
        } else {
            side >= S::zero()
        }
    }

    /// Whether exactly one of two conditions holds: a ray from the point to the right crosses the chord, and the point
    /// is between chord and arc. Over a closed loop this is true an odd number of times for the points inside it.
    ///
    /// The two conditions change together as the point crosses the chord, in whichever direction the rounding falls. A
    /// point level with an end counts as a little higher, also on the chord's line.
    #[inline]
    pub(super) fn flips(&self, p: Place<S>) -> bool {
        let side = self.side(p);
        let left = side > S::zero() || (side == S::zero() && self.end.x > self.start.x);
        let (start_above, end_above) = (self.start.y > p.y, self.end.y > p.y);
        let crossed = start_above != end_above && left == end_above;
        if self.turn == 0 {
            return crossed;
        }
        let w = p - self.center;
        let between = left != (self.turn > 0) && w.dot(w) < self.radius * self.radius;
        crossed != between
    }

    /// The point of the circle in the direction of `p`, and its distance to `p`.
    #[inline]
    pub(super) fn project(&self, p: Place<S>) -> (Place<S>, S) {
        let w = p - self.center;
        let length = w.length();
        if length > S::zero() {
            let foot = self.center + w.times(self.radius / length);
            (foot, (length - self.radius).magnitude())
        } else {
            (self.start, self.radius)
        }
    }

    /// The nearest point of the curve, and its distance.
    #[inline]
    pub(super) fn nearest(&self, p: Place<S>) -> (Place<S>, S) {
        if self.is_line() {
            let d = self.end - self.start;
            let w = p - self.start;
            let (along, whole) = (w.dot(d), d.dot(d));
            if along > S::zero() && along < whole {
                let foot = self.start + d.times(along / whole);
                return (foot, (d.cross(w) / whole.root()).magnitude());
            }
        } else {
            let (foot, distance) = self.project(p);
            if self.spans(foot) {
                return (foot, distance);
            }
        }
        let (a, b) = ((p - self.start).length(), (p - self.end).length());
        if a < b {
            (self.start, a)
        } else {
            (self.end, b)
        }
    }

    /// The least distance between two curves that do not cross.
    pub(super) fn distance(&self, other: &Self) -> S {
        let mut best = self.nearest(other.start).1;
        let mut consider = |d: S| {
            if d < best {
                best = d;
            }
        };
        consider(self.nearest(other.end).1);
        consider(other.nearest(self.start).1);
        consider(other.nearest(self.end).1);
        match (self.is_line(), other.is_line()) {
            (true, true) => {}
            (true, false) => {
                if let Some(d) = self.line_to_arc(other) {
                    consider(d);
                }
            }
            (false, true) => {
                if let Some(d) = other.line_to_arc(self) {
                    consider(d);
                }
            }
            (false, false) => {
                let w = other.center - self.center;
                let length = w.length();
                if length > S::zero() {
                    let u = w.times(S::of(1.0) / length);
                    for s in [1.0, -1.0] {
                        let p = self.center + u.times(self.radius * S::of(s));
                        if !self.spans(p) {
                            continue;
                        }
                        for t in [1.0, -1.0] {
                            let q = other.center + u.times(other.radius * S::of(t));
                            if other.spans(q) {
                                consider((q - p).length());
                            }
                        }
                    }
                }
            }
        }
        best
    }

    /// The distance between this line and the arc where both have the same normal, if they do.
    fn line_to_arc(&self, arc: &Self) -> Option<S> {
        let d = self.end - self.start;
        let along = (arc.center - self.start).dot(d);
        let whole = d.dot(d);
        if along < S::zero() || along > whole {
            return None;
        }
        let (p, distance) = arc.project(self.start + d.times(along / whole));
        arc.spans(p).then_some(distance)
    }

    /// The place of a point of the curve as a mark.
    pub(super) fn mark(&self, p: Place<S>) -> Mark<S> {
        let zero = S::zero();
        if self.is_line() {
            return ((p - self.start).dot(self.end - self.start), p);
        }
        let whole = self.around(self.end);
        let mut at = self.around(p);
        if at > whole {
            // Rounded over an end.
            at = if at - whole > S::of(4.0) - at {
                zero
            } else {
                whole
            };
        }
        (at, p)
    }

    /// A number in [0, 4) that grows with the angle travelled about the centre from the start to `p`.
    fn around(&self, p: Place<S>) -> S {
        let (u, w) = (self.start - self.center, p - self.center);
        let cos = u.dot(w);
        let sin = if self.turn > 0 {
            u.cross(w)
        } else {
            w.cross(u)
        };
        let x = cos / (cos.magnitude() + sin.magnitude());
        if sin >= S::zero() {
            S::of(1.0) - x
        } else {
            S::of(3.0) + x
        }
    }

    /// The curve's ends as marks.
    pub(super) fn ends(&self) -> [Mark<S>; 2] {
        [(S::zero(), self.start), self.mark(self.end)]
    }

    /// Mark halfway between two, the first before the second.
    pub(super) fn between(&self, p: Mark<S>, q: Mark<S>) -> Mark<S> {
        if self.is_line() {
            return ((p.0 + q.0) * S::of(0.5), (p.1 + q.1).times(S::of(0.5)));
        }
        let (u, v) = (p.1 - self.center, q.1 - self.center);
        // Two units of the mark are half a turn, exactly.
        let w = if u.dot(v) >= S::zero() {
            let sum = u + v;
            if q.0 - p.0 > S::of(2.0) {
                sum.times(S::of(-1.0))
            } else {
                sum
            }
        } else if self.turn > 0 {
            // To the right of the way from u to v.
            (u - v).left()
        } else {
            (v - u).left()
        };
        let length = w.length();
        if length > S::zero() {
            self.mark(self.center + w.times(self.radius / length))
        } else {
            p
        }
    }

    /// A unit vector across the curve at one of its points.
    pub(super) fn normal(&self, p: Place<S>) -> Place<S> {
        let n = if self.is_line() {
            (self.end - self.start).left()
        } else {
            p - self.center
        };
        n.times(S::of(1.0) / n.length())
    }

    /// Meetings of the curve with another: at most two points, without shared stretches.
    pub(super) fn meet(&self, other: &Self, mut report: impl FnMut(Place<S>)) {
        match (self.is_line(), other.is_line()) {
            (true, true) => {
                let (d, e) = (self.end - self.start, other.end - other.start);
                let k = d.cross(e);
                let w = other.start - self.start;
                let (mut t, mut u, mut whole) = (w.cross(e), w.cross(d), k);
                if k < S::zero() {
                    (t, u, whole) = (-t, -u, -k);
                }
                let zero = S::zero();
                if whole > zero && t >= zero && t <= whole && u >= zero && u <= whole {
                    report(self.start + d.times(t / whole));
                }
            }
            (true, false) => self.line_meets_arc(other, report),
            (false, true) => other.line_meets_arc(self, report),
            (false, false) => {
                let w = other.center - self.center;
                let length = w.length();
                if length <= S::zero() {
                    return;
                }
                let (r, s) = (self.radius, other.radius);
                let along = (length + (r - s) * (r + s) / length) * S::of(0.5);
                let square = (r - along) * (r + along);
                if square < S::zero() {
                    return;
                }
                let u = w.times(S::of(1.0) / length);
                let foot = self.center + u.times(along);
                let across = u.left().times(square.root());
                for p in [foot + across, foot - across] {
                    if self.spans(p) && other.spans(p) {
                        report(p);
                    }
                }
            }
        }
    }

    fn line_meets_arc(&self, arc: &Self, mut report: impl FnMut(Place<S>)) {
        let d = self.end - self.start;
        let length = d.length();
        let u = d.times(S::of(1.0) / length);
        let w = arc.center - self.start;
        let distance = u.cross(w).magnitude();
        let square = (arc.radius - distance) * (arc.radius + distance);
        if square < S::zero() {
            return;
        }
        let (middle, half) = (u.dot(w), square.root());
        for t in [middle - half, middle + half] {
            if t >= S::zero() && t <= length {
                let p = self.start + u.times(t);
                if arc.spans(p) {
                    report(p);
                }
            }
        }
    }
}

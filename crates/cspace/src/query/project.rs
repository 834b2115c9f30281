//! The configuration of a patch that is nearest to a given one, in a metric in which turning by a radian counts as a length ρ.
//!
//! At an orientation θ the point of a contact curve nearest to a position is the foot of the perpendicular on its carrier, or one of its
//! ends. So the minimum of |q − p|² + ρ² (θ − θ₀)² over a patch is the smallest of the minima of three functions of θ. Over an interval
//! each function is enclosed with two derivatives: if the first derivative has no zero, only the ends of the interval count; if the foot is
//! beyond an end of the curve, the foot does not count. Remaining intervals are halved (`number/least.rs`), and at last Newton's method
//! finds the zero of the derivative.

use core::f64::consts::PI;

use crate::contact::{Carrier, Spiral};
use crate::geometry::{Configuration, Point, Rotation, Vector, images};
use crate::ids::PatchId;
use crate::number::{Ball, Bounded, Expansion, Real, SecondOrder, least};
use crate::space::{Boundary, ContactSpace, Patch};

/// Length (radians) up to which an interval is not halved on account of an end that is hidden by rounding: where two circles almost
/// coincide.
const HIDDEN: f64 = 1.0 / (1u32 << 20) as f64;
/// An end is hidden if the error over a whole interval is at most this many times the error in its middle.
const NO_BETTER: f64 = 4.0;
/// Steps of Newton's method: each doubles the number of correct digits, which is about five at first.
const STEPS: usize = 6;

impl ContactSpace {
    /// The patches in about the order of their distances from a configuration, as [`project`](Self::project) computes them.
    pub(crate) fn patches_by_distance(
        &self,
        from: Configuration,
        length_per_radian: f64,
    ) -> Vec<PatchId> {
        let mut order: Vec<(f64, PatchId)> = ((0..).map(PatchId).zip(self.patches()))
            .map(|(i, patch)| {
                let near = images(from.theta, (patch.lo, patch.hi))
                    .map(|theta| {
                        let t = theta.clamp(patch.lo, patch.hi);
                        let q = self.surface().curve(patch, t).nearest(from.position());
                        q.distance(from.position())
                            .hypot(length_per_radian * (t - theta))
                    })
                    .fold(f64::INFINITY, f64::min);
                (near, i)
            })
            .collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        order.into_iter().map(|(_, patch)| patch).collect()
    }

    /// The configuration of a patch that is nearest to a given one, and its distance in the model's unit of length, where turning by a
    /// radian counts as `length_per_radian`; `None` if there is no such patch, or it is not nearer than `known`.
    ///
    /// Orientations are taken modulo a turn. The result has the image of the orientation that is nearest to the given one; for a space with
    /// a window, the image in the window.
    pub(crate) fn project(
        &self,
        from: Configuration,
        patch: PatchId,
        length_per_radian: f64,
        known: f64,
    ) -> Option<(Configuration, f64)> {
        let (frame, patch) = (&self.data.frame, self.patches().get(patch.index())?);
        let at = Point::ORIGIN + (from.position() - frame.fixed_center) * frame.scale;
        let seat = Spiral::new(at, frame.moving_center.to_vector() * frame.scale);
        let known = known * frame.scale;
        let mut best = (from, known);
        for theta in images(from.theta, (patch.lo, patch.hi)) {
            let search = Search {
                space: self,
                patch,
                from,
                theta,
                weight: length_per_radian * frame.scale,
                seat,
                own: patch.function.carrier().about(&seat),
            };
            let (lo, hi) = (patch.lo.max(theta - PI), patch.hi.min(theta + PI));
            if let Some(found) = least(&search, (lo, hi), best.1) {
                let (t, distance) = search.polished(found, lo, hi);
                let q = search.nearest(t);
                let full_turn = self.data.window.full_turn;
                let shown = if full_turn {
                    t + (from.theta - theta)
                } else {
                    t
                };
                best = (Configuration::new(q.x, q.y, shown), distance);
            }
        }
        (best.1 < known).then(|| (best.0, frame.outer_length(best.1)))
    }
}

/// A patch, as seen from one image of a configuration.
struct Search<'a> {
    space: &'a ContactSpace,
    patch: &'a Patch,
    from: Configuration,
    /// Image of the configuration's orientation, radians.
    theta: f64,
    /// Length that one radian counts in the metric (length of the pair's frame).
    weight: f64,
    /// The configuration's position in the pair's frame, which moves with the orientation.
    seat: Spiral,
    /// The patch's line or circle relative to that position.
    own: Carrier,
}

impl Search<'_> {
    /// The nearest point of the curve at an orientation of the patch, as a position.
    fn nearest(&self, t: f64) -> Point {
        let curve = self.space.surface().curve(self.patch, t);
        curve.nearest(self.from.position())
    }

    /// The vector from the position to an end of the curve.
    fn way<T: Real>(&self, end: &Boundary, turn: Rotation<T>) -> Vector<T> {
        match end {
            Boundary::End { spiral } => spiral.about(&self.seat).lift().at(turn).to_vector(),
            Boundary::Crossing { with, root } => {
                let f = self.patch.function.cycle(turn);
                let place = f.root(&with.cycle(turn), *root, false);
                self.own.lift().cycle(turn).at(place).to_vector()
            }
        }
    }

    fn ways<T: Real>(&self, turn: Rotation<T>) -> [Vector<T>; 2] {
        [&self.patch.left, &self.patch.right].map(|end| self.way(end, turn))
    }

    /// The signed distance of the position from the line or circle.
    fn off<T: Real>(&self, turn: Rotation<T>) -> T {
        self.own
            .lift()
            .cycle(turn)
            .distance(Point::ORIGIN.map(T::constant))
    }

    /// Whether the foot is certainly beyond an end of the curve, given the vectors to its ends.
    fn is_beside(&self, turn: Rotation<Ball>, [start, end]: [Vector<Ball>; 2]) -> bool {
        let cycle = self.own.lift().cycle(turn);
        if cycle.is_centred() {
            let center = cycle.through.to_vector();
            let (a, b) = (start - center, end - center);
            let (a, b) = if cycle.weight.mid > 0.0 {
                (a, b)
            } else {
                (b, a)
            };
            let at = -center;
            let (before, after) = (a.cross(at).sign() < 0, at.cross(b).sign() < 0);
            // For more than half a circle, a foot is outside only if it is beyond both ends.
            return if a.cross(b).sign() > 0 {
                before || after
            } else {
                before && after
            };
        }
        let origin = Point::ORIGIN.map(Ball::constant);
        let along = |way: Vector<Ball>| way.dot(cycle.slope(origin + way).left()).sign();
        along(start) > 0 || along(end) < 0
    }

    /// The squared distances to the foot and to both ends, given the distance of the position from the carrier, the vectors to the ends,
    /// and the orientation minus that of the configuration.
    fn squares<T: Real>(&self, off: T, [start, end]: [Vector<T>; 2], turned: T) -> [T; 3] {
        let turned = turned * T::constant(self.weight);
        [off * off, start.length_squared(), end.length_squared()].map(|d| d + turned * turned)
    }

    /// The smallest minimum nearby where the derivative is zero, to rounding.
    fn polished(&self, found: (f64, f64), lo: f64, hi: f64) -> (f64, f64) {
        /// Relative difference below which distances count as equal, which they may be over many orientations.
        const SAME: f64 = 4.0 * f64::EPSILON;
        let mut best = found;
        for branch in 0..3 {
            let mut t = found.0;
            for _ in 0..STEPS {
                let theta = SecondOrder::<1>::variable(t, 0);
                let turn = Rotation::by(theta);
                let turned = theta - Real::constant(self.theta);
                let g = self.squares(self.off(turn), self.ways(turn), turned)[branch];
                let (slope, bend) = (g.gradient[0], g.hessian[0][0]);
                if !(bend > 0.0 && slope.is_finite()) {
                    break;
                }
                t = (t - slope / bend).clamp(lo, hi);
            }
            let value = self.at(t);
            if value <= best.1 * (1.0 + SAME) {
                best = (t, value);
            }
        }
        best
    }
}

impl Bounded for Search<'_> {
    fn at(&self, t: f64) -> f64 {
        let away = self.nearest(t).distance(self.from.position()) * self.space.data.frame.scale;
        away.hypot(self.weight * (t - self.theta))
    }

    fn below(&self, lo: f64, hi: f64) -> f64 {
        let theta = Expansion::variable(lo, hi);
        let (turned, turn) = (theta - Real::constant(self.theta), Rotation::by(theta));
        let over = |e: Expansion| e.over.value;
        let low = |b: Ball| b.mid - b.radius;
        let ways = self.ways(turn);
        let squares = self.squares(self.off(turn), ways, turned);
        // An end lies on the carrier, so it is not nearer than the foot.
        let foot = low(squares[0].over.value);
        // The error over the interval is not much larger than in the middle.
        let hidden = |Vector { x, y }: Vector<Expansion>| {
            let better = |e: Expansion| e.over.value.radius > NO_BETTER * e.at.value.radius;
            hi - lo <= HIDDEN && !(better(x) || better(y))
        };
        let [start, end] = ways;
        let skipped = [
            self.is_beside(
                Rotation {
                    cos: over(turn.cos),
                    sin: over(turn.sin),
                },
                ways.map(|way| way.map(over)),
            ),
            hidden(start),
            hidden(end),
        ];
        (squares.into_iter().zip(skipped))
            .filter(|(_, skipped)| !skipped)
            .map(|(square, _)| square.least().max(foot).max(0.0).sqrt())
            .fold(f64::INFINITY, f64::min)
    }
}

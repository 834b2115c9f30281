//! Enclosure of the curves of a patch over an interval of orientations.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::contact::{ContactFunction, Cycle, Spiral};
use crate::feature::tolerance::WIDEST_SAGITTA;
use crate::geometry::{Point, Rotation, Vector};
use crate::number::{Ball, Dual, Real};
use crate::slice::CurveGeometry;
use crate::space::{Boundary, Patch, sweep};

/// A length above all in the pair's frame, where all contact is within 2 of the origin.
const FAR: f64 = 8.0;
/// Factor by which a strip must be narrower to be used: it is longer at its ends.
const NARROWER: f64 = 0.5;
/// Bound of the rounding errors of a position in the pair's frame (length).
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// An interval of orientation, with data needed to enclose crossings.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Orientations {
    /// Its middle, radians.
    pub(super) mid: f64,
    /// Half its length.
    pub(super) half: f64,
    turn: Rotation,
    /// The middle, enclosed.
    at: Rotation<Ball>,
}

impl Orientations {
    /// The orientations from `lo` to `hi`.
    #[inline]
    pub(crate) fn between(lo: f64, hi: f64) -> Self {
        Self::about(0.5 * (lo + hi), 0.5 * (hi - lo))
    }

    /// The orientations within `half` of `mid`.
    #[inline]
    pub(super) fn about(mid: f64, half: f64) -> Self {
        let at = Rotation::by(Ball::constant(mid));
        let turn = Rotation {
            cos: at.cos.mid,
            sin: at.sin.mid,
        };
        Self {
            mid,
            half,
            turn,
            at,
        }
    }

    /// One of `pieces` equal pieces.
    #[inline]
    pub(crate) fn piece(&self, index: u32, pieces: u32) -> Self {
        let length = 2.0 * self.half / f64::from(pieces);
        let lo = self.mid - self.half + length * f64::from(index);
        Self::between(lo, lo + length)
    }
}

/// A curve and a distance: the curves of a patch at all orientations of an interval are within `spread` of `shape`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Swept {
    /// The curve.
    pub(crate) shape: CurveGeometry,
    /// The distance.
    pub(crate) spread: f64,
    /// Length by which the shape was extended at its ends.
    pub(crate) slack: f64,
    /// Largest speed of the curve, for an arc without its ends, and of its two ends (length per radian).
    speed: f64,
    ends: [f64; 2],
}

/// The end of a curve in the middle of an interval; for a circle relative to the centre.
#[derive(Debug, Clone, Copy)]
struct End {
    at: Vector,
    /// Largest distance of the end from there at other orientations of the interval.
    error: f64,
    /// Largest speed of the end (length per radian).
    speed: f64,
}

impl Swept {
    /// Encloses the curves of a patch at all orientations of an interval, which must be the patch's.
    ///
    /// The ends are enclosed by interval arithmetic. A segment moves no more than its ends do, and sideways no more than its line; an arc
    /// moves with its centre by |w| · half. Both exceed the curve in the middle by no more than the displacement of their ends.
    #[inline]
    pub(crate) fn new(patch: &Patch, over: &Orientations) -> Self {
        Self::of_ends(patch, over, [None; 2])
    }

    /// Encloses the curves over an interval within one that is enclosed already: the known speeds of the ends are used again.
    #[inline]
    pub(crate) fn within(&self, patch: &Patch, over: &Orientations) -> Self {
        Self::of_ends(patch, over, self.ends.map(Some))
    }

    /// Number of equal pieces into which the interval must be divided so that in each the curve moves from its middle by no more than
    /// `distance`, and is longer by no more than `longer`. Infinite if the speeds are unknown.
    #[inline]
    pub(crate) fn pieces(&self, over: &Orientations, distance: f64, longer: f64) -> f64 {
        let ends = self.ends[0].max(self.ends[1]);
        over.half * (self.speed / distance).max(ends / longer)
    }

    fn of_ends(patch: &Patch, over: &Orientations, speeds: [Option<f64>; 2]) -> Self {
        let &Orientations { half, turn, .. } = over;
        let left = end(&patch.left, &patch.function, over, speeds[0]);
        let right = end(&patch.right, &patch.function, over, speeds[1]);
        match patch.function {
            ContactFunction::Circle { center, radius } => {
                let r = radius.abs();
                let speed = center.w.length();
                let sweep = sweep(left.at, right.at, radius);
                // A chord of length e spans an arc of π/2 e at most.
                let angle = |e: f64| FRAC_PI_2 * e / r;
                let (before, after) = (angle(left.error), angle(right.error));
                let length = sweep.abs() + before + after;
                let whole = length.is_nan() || length >= TAU;
                let direction = radius.signum();
                // An unknown end has no angle either.
                let (start_angle, sweep) = if whole {
                    (0.0, TAU)
                } else {
                    (left.at.angle() - direction * before, length)
                };
                let shape = CurveGeometry::Arc {
                    center: center.at(turn),
                    radius: r,
                    start_angle,
                    sweep: direction * sweep,
                };
                Self {
                    shape,
                    spread: speed * half + ROUNDING,
                    slack: if whole {
                        TAU * r
                    } else {
                        left.error.max(right.error)
                    },
                    speed,
                    ends: [left.speed, right.speed],
                }
            }
            ContactFunction::FixedLine { .. }
            | ContactFunction::MovingLine { .. }
            | ContactFunction::FlatCircle { .. } => {
                let carrier = patch.function.carrier();
                let (through, turns) = (carrier.through, carrier.turns());
                let cycle = patch.function.cycle(turn);
                // Anything within FAR is no farther than twice that from the point it turns about.
                let turning = if turns { 2.0 * FAR } else { 0.0 };
                let moves = (speed(&through) + turning) * half;
                if cycle.is_line() {
                    let velocity = (turn * through.turning()).left();
                    let swept = segment(left, right, &cycle, moves);
                    return strip(&cycle, velocity, &swept, (left, right), half, turns);
                }
                // The chord; the carrier is as far from its tangent within FAR.
                let mut swept = segment(left, right, &cycle, moves + FAR);
                swept.spread += WIDEST_SAGITTA;
                swept
            }
        }
    }

    /// Whether a position is farther than `distance` from the curves at all orientations of the interval.
    pub(super) fn is_away(&self, p: Point, distance: f64) -> bool {
        self.shape.nearest(p).distance(p) > self.spread + distance
    }
}

/// The segments whose ends are known to the given errors; if an end is not known at all, those of the whole carrier.
fn segment(left: End, right: End, carrier: &Cycle, moves: f64) -> Swept {
    let spread = left.error.max(right.error) + ROUNDING;
    let speed = left.speed.max(right.speed);
    let ends = [left.speed, right.speed];
    if spread < FAR {
        return Swept {
            shape: CurveGeometry::Segment {
                start: Point::ORIGIN + left.at,
                end: Point::ORIGIN + right.at,
            },
            spread,
            slack: 0.0,
            speed,
            ends,
        };
    }
    let normal = carrier.normal;
    let foot = Point::ORIGIN + normal * normal.dot(carrier.through.to_vector());
    Swept {
        shape: CurveGeometry::Segment {
            start: foot + normal.left() * FAR,
            end: foot + normal.right() * FAR,
        },
        spread: moves + ROUNDING,
        slack: FAR,
        speed,
        ends,
    }
}

/// Encloses the same segments by a strip, where that is much narrower: the line in the middle, from the first place along it that an end
/// may reach to the last, and the distance by which the line moves sideways there.
///
/// A position x is off the line by f = n·(x − t). With t the point it is through, and v its velocity, f changes by left(n)·(x − t) − n·v
/// per radian if the line turns, otherwise by −n·v; the change of this is bounded by |x − t| + 3 |v|, or |v|. No x is farther from t than
/// ends may be along the line, and then half as much again, and t moves by |v| at most.
fn strip(
    line: &Cycle,
    velocity: Vector,
    swept: &Swept,
    (left, right): (End, End),
    half: f64,
    turns: bool,
) -> Swept {
    let along = line.normal.left();
    let place = |end: End| along.dot((Point::ORIGIN + end.at) - line.through);
    let (a, b) = (place(left), place(right));
    let first = (a - left.error).min(b - right.error);
    let last = (a + left.error).max(b + right.error);
    let sideways = line.normal.dot(velocity);
    let speed = velocity.length();
    let (rate, bend) = if turns {
        let rate = (first - sideways).abs().max((last - sideways).abs());
        (rate, 2.0 * first.abs().max(last.abs()) + 4.0 * speed)
    } else {
        (sideways.abs(), speed)
    };
    let rate = rate + bend * half;
    let spread = rate * half + ROUNDING;
    // Not used for ends that are not known.
    if !(half <= 1.0 && spread <= NARROWER * swept.spread && last - first <= FAR) {
        return *swept;
    }
    let (start, end) = if a <= b { (first, last) } else { (last, first) };
    let at = |place: f64| line.through + along * place;
    Swept {
        shape: CurveGeometry::Segment {
            start: at(start),
            end: at(end),
        },
        spread,
        slack: left.error.max(right.error),
        speed: rate,
        ..*swept
    }
}

/// The end of a curve over an interval; `known` is a bound of its speed there, if available.
fn end(boundary: &Boundary, own: &ContactFunction, over: &Orientations, known: Option<f64>) -> End {
    let half = over.half;
    match *boundary {
        Boundary::End { spiral } => {
            let (at, speed) = if spiral.swing.is_none() {
                let (u, w) = match *own {
                    ContactFunction::Circle { center, .. } => (center.u.to_vector(), center.w),
                    _ => (Vector::ZERO, Vector::ZERO),
                };
                let w = spiral.w - w;
                ((spiral.u.to_vector() - u) + over.turn * w, w.length())
            } else {
                (spiral.at(over.turn).to_vector(), speed(&spiral))
            };
            End {
                at,
                error: speed * half + ROUNDING,
                speed,
            }
        }
        Boundary::Crossing { ref with, root } => {
            let at = place(own, boundary, with, root, over.at);
            let rounding = at.map(|b| b.radius).length();
            let (error, speed) = known.map_or_else(
                || {
                    let theta = Dual::<1, _>::variable(Ball::new(over.mid, half), 0);
                    let all = place(own, boundary, with, root, Rotation::by(theta));
                    let most = |b: Ball| b.mid.abs() + b.radius;
                    let speed = all.map(|x| most(x.slope[0])).length();
                    // The direct enclosure, or that of the mean value theorem, whichever is narrower.
                    let direct = |at: Ball, over: Ball| (over.mid - at.mid).abs() + over.radius;
                    let direct = Vector::new(direct(at.x, all.x.value), direct(at.y, all.y.value));
                    let direct = direct.length();
                    (direct.min(rounding + speed * half), speed)
                },
                |speed| (rounding + speed * half, speed),
            );
            let known = |x: f64| if x.is_nan() { f64::INFINITY } else { x };
            End {
                at: at.map(|b| b.mid),
                error: known(error),
                speed: known(speed),
            }
        }
    }
}

/// Speed of a spiral (length per radian).
fn speed(spiral: &Spiral) -> f64 {
    spiral.turning().length()
}

/// A crossing, relative to the centre of a circle or to the origin.
#[inline]
fn place<T: Real>(
    own: &ContactFunction,
    boundary: &Boundary,
    with: &ContactFunction,
    root: u8,
    turn: Rotation<T>,
) -> Vector<T> {
    if matches!(own, ContactFunction::Circle { .. }) {
        own.cycle(turn).root(&with.cycle(turn), root, false)
    } else {
        boundary.inner(own, turn).to_vector()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::part::{Part, Vertex};
    use crate::space::{ContactSpace, Options};

    /// A part with corners, also concave ones, and arcs that bulge either way.
    fn part(name: &str, size: f64) -> Part {
        let at = |x: f64, y: f64, bulge: f64| Vertex {
            bulge,
            ..Vertex::line(x * size, y * size)
        };
        let outline = vec![
            at(-1.0, -1.0, 0.0),
            at(1.0, -0.9, 0.4),
            at(1.1, 1.0, 0.0),
            at(0.2, 0.1, -0.3),
            at(-0.4, 1.2, 0.2),
        ];
        Part::new(name, vec![outline]).unwrap()
    }

    #[test]
    fn encloses_the_curves_of_all_patches() {
        let (fixed, moving) = (part("fixed", 1.0), part("moving", 0.6));
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let (mut asked, mut narrow) = (0, 0);
        for patch in &space.data.patches {
            for half in [0.2, 0.02, 1e-3, 1e-6] {
                for i in 0..9 {
                    let mid = patch.lo + (patch.hi - patch.lo) * f64::from(i) / 8.0;
                    let (lo, hi) = ((mid - half).max(patch.lo), (mid + half).min(patch.hi));
                    let whole = Orientations::between(lo, hi);
                    let swept = Swept::new(patch, &whole);
                    narrow += usize::from(swept.spread + swept.slack < 8.0 * half + 1e-9);
                    for j in 1..8 {
                        let theta = lo + (hi - lo) * f64::from(j) / 8.0;
                        let curve = space.surface().curve(patch, theta);
                        for s in [0.0, 0.3, 0.5, 0.9, 1.0] {
                            let q = curve.point(s);
                            let c = crate::Configuration::new(q.x, q.y, theta);
                            let p = space.data.frame.inner_from_outer(c);
                            assert!(!swept.is_away(p, 1e-13), "{patch:?} at {theta}");
                            // First, second or third part of the interval.
                            let third = ((3 * j) / 8) as u32;
                            let piece = whole.piece(third, 3);
                            let piece = swept.within(patch, &piece);
                            assert!(!piece.is_away(p, 1e-13), "{patch:?} at {theta}");
                            asked += 1;
                        }
                    }
                }
            }
        }
        assert!(asked > 10_000);
        // The enclosure is not much wider than necessary, except next to tangencies.
        assert!(narrow * 10 > asked / 35 * 8, "{narrow} of {}", asked / 35);
    }
}

//! Where the curves of a patch are over an interval of orientations.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::contact::{ContactFunction, Spiral, place_on};
use crate::feature::tolerance::WIDEST_SAGITTA;
use crate::geometry::{Point, Rotation, Vector};
use crate::number::{Ball, Jet, Real};
use crate::slice::CurveGeometry;
use crate::space::{Boundary, Patch, sweep};

/// Longer than anything in the pair's frame, where all contact is within 2 of the origin (length).
const FAR: f64 = 8.0;
/// More than the rounding errors of a position in the pair's frame (length).
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A curve and a distance: the curves of a patch at all orientations of an interval are within `spread` of `shape`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swept {
    pub(super) shape: CurveGeometry,
    pub(super) spread: f64,
    /// By how much the shape was made longer at its ends.
    pub(super) slack: f64,
}

impl Swept {
    /// Encloses the curves of a patch at the orientations from `mid − half` to `mid + half`, which must be the patch's.
    ///
    /// The ends are enclosed by interval arithmetic. A segment moves no more than its ends do. An arc moves with its
    /// centre by |w| · half, and is longer than in the middle by no more than its ends go astray on the circle.
    pub(super) fn new(patch: &Patch, mid: f64, half: f64) -> Self {
        let turn = Rotation::by(mid);
        let left = end(&patch.left, &patch.function, mid, half);
        let right = end(&patch.right, &patch.function, mid, half);
        match patch.function {
            ContactFunction::Circle { center, radius } => {
                let r = radius.abs();
                let spread = center.w.length() * half + ROUNDING;
                let sweep = sweep(left.0, right.0, radius);
                // A chord of length e spans an arc of π/2 e at most.
                let angle = |e: f64| FRAC_PI_2 * e / r;
                let (before, after) = (angle(left.1), angle(right.1));
                let length = sweep.abs() + before + after;
                let whole = length.is_nan() || length >= TAU;
                let direction = radius.signum();
                // Of an end that is not known at all there is no angle either.
                let (start_angle, sweep) = if whole {
                    (0.0, TAU)
                } else {
                    (left.0.angle() - direction * before, length)
                };
                let shape = CurveGeometry::Arc {
                    center: center.at(turn),
                    radius: r,
                    start_angle,
                    sweep: direction * sweep,
                };
                let slack = if whole { TAU * r } else { left.1.max(right.1) };
                Self {
                    shape,
                    spread,
                    slack,
                }
            }
            ContactFunction::FixedLine { normal, through } => {
                let moves = speed(&through) * half;
                segment(left, right, normal, through.at(turn), moves)
            }
            ContactFunction::MovingLine { normal, through } => {
                // Anything within FAR is no farther than twice that from the point it turns about.
                let moves = (speed(&through) + 2.0 * FAR) * half;
                segment(left, right, turn * normal, through.at(turn), moves)
            }
            ContactFunction::FlatCircle {
                through,
                normal,
                turns,
                ..
            } => {
                // The chord; the carrier is as far from its tangent within FAR.
                let normal = if turns { turn * normal } else { normal };
                let moves = (speed(&through) + 2.0 * FAR) * half + FAR;
                let mut swept = segment(left, right, normal, through.at(turn), moves);
                swept.spread += WIDEST_SAGITTA;
                swept
            }
        }
    }

    /// Whether a position is farther than a distance from the curves at all orientations of the interval.
    pub(super) fn is_away(&self, p: Point, distance: f64) -> bool {
        self.shape.nearest(p).distance(p) > self.spread + distance
    }
}

/// The segments whose ends are known to the given errors; of the whole carrier, if an end is not known at all.
fn segment(
    left: (Vector, f64),
    right: (Vector, f64),
    normal: Vector,
    through: Point,
    moves: f64,
) -> Swept {
    let spread = left.1.max(right.1) + ROUNDING;
    if spread < FAR {
        return Swept {
            shape: CurveGeometry::Segment {
                start: Point::ORIGIN + left.0,
                end: Point::ORIGIN + right.0,
            },
            spread,
            slack: 0.0,
        };
    }
    let foot = Point::ORIGIN + normal * normal.dot(through.to_vector());
    Swept {
        shape: CurveGeometry::Segment {
            start: foot + normal.left() * FAR,
            end: foot + normal.right() * FAR,
        },
        spread: moves + ROUNDING,
        slack: FAR,
    }
}

/// The end of a curve in the middle of the interval, and how far it is from there at other orientations of it, at most.
/// Of a circle it is relative to the centre.
fn end(boundary: &Boundary, own: &ContactFunction, mid: f64, half: f64) -> (Vector, f64) {
    match *boundary {
        Boundary::End { spiral } => {
            if !spiral.swing.is_none() {
                let at = spiral.at(Rotation::by(mid)).to_vector();
                return (at, speed(&spiral) * half + ROUNDING);
            }
            let base = match *own {
                ContactFunction::Circle { center, .. } => (center.u.to_vector(), center.w),
                _ => (Vector::ZERO, Vector::ZERO),
            };
            let w = spiral.w - base.1;
            let at = (spiral.u.to_vector() - base.0) + Rotation::by(mid) * w;
            (at, w.length() * half + ROUNDING)
        }
        Boundary::Crossing { ref with, root } => {
            let at = place(own, boundary, with, root, Ball::constant(mid).cos_sin());
            let over = place(
                own,
                boundary,
                with,
                root,
                Jet::cos_sin(Ball::new(mid, half)),
            );
            // The enclosure itself, or what the mean value theorem says, whichever is narrower.
            let error = |at: Ball, over: Jet| {
                let direct = (over.value.mid - at.mid).abs() + over.value.radius;
                let mean = at.radius + (over.slope.mid.abs() + over.slope.radius) * half;
                let least = direct.min(mean);
                if least.is_nan() { f64::INFINITY } else { least }
            };
            let mid = Vector::new(at.0.mid, at.1.mid);
            (mid, error(at.0, over.0).hypot(error(at.1, over.1)))
        }
    }
}

/// How fast a spiral moves (length per radian).
fn speed(spiral: &Spiral) -> f64 {
    spiral.turning().length()
}

/// A crossing, relative to the centre of a circle.
#[inline]
fn place<T: Real>(
    own: &ContactFunction,
    boundary: &Boundary,
    with: &ContactFunction,
    root: u8,
    (cos, sin): (T, T),
) -> (T, T) {
    if matches!(own, ContactFunction::Circle { .. }) {
        let (f, g) = (own.carrier(cos, sin), with.carrier(cos, sin));
        place_on(&f, &g, root, false)
    } else {
        boundary.inner(own, cos, sin)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::part::{Part, Vertex};
    use crate::space::{ContactSpace, Options};

    /// A part with corners, concave ones too, and arcs that bulge either way.
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
                    let swept = Swept::new(patch, 0.5 * (lo + hi), 0.5 * (hi - lo));
                    narrow += usize::from(swept.spread + swept.slack < 8.0 * half + 1e-9);
                    for j in 1..8 {
                        let theta = lo + (hi - lo) * f64::from(j) / 8.0;
                        let curve = space.curve(patch, theta);
                        for s in [0.0, 0.3, 0.5, 0.9, 1.0] {
                            let q = curve.point(s);
                            let c = crate::Configuration::new(q.x, q.y, theta);
                            let p = space.data.frame.inner_from_outer(c);
                            assert!(!swept.is_away(p, 1e-13), "{patch:?} at {theta}");
                            asked += 1;
                        }
                    }
                }
            }
        }
        assert!(asked > 10_000);
        // Nor is it wider than it need be, but next to tangencies.
        assert!(narrow * 10 > asked / 35 * 8, "{narrow} of {}", asked / 35);
    }
}

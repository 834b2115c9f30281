//! Intersection of a ray parallel to an axis with a patch's curve at one orientation.

use crate::contact::ContactFunction;
use crate::geometry::{Point, Rotation, Vector};
use crate::query::classify::END_ERROR;
use crate::space::{PASSED_ENDS, Patch};

/// Result of following a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Meeting {
    /// The ray meets nothing.
    Nothing,
    /// A curve at a distance; `from_free` if the ray starts on its free side.
    Curve { distance: f64, from_free: bool },
    /// The ray passes too close to an end to decide.
    Unclear,
}

/// The four directions of the axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum AxisDirection {
    Right,
    Up,
    Left,
    Down,
}

impl AxisDirection {
    pub(super) const ALL: [Self; 4] = [Self::Right, Self::Up, Self::Left, Self::Down];

    /// Turns the plane so that the direction becomes the direction of the first axis.
    #[inline]
    pub(super) fn ahead(self, v: Vector) -> Vector {
        match self {
            Self::Right => v,
            Self::Up => v.right(),
            Self::Left => -v,
            Self::Down => v.left(),
        }
    }
}

/// The curve of a patch at one orientation, relative to a point, with the data that rays need.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    start: Vector,
    end: Vector,
    /// Centre and signed radius.
    circle: Option<(Vector, f64)>,
    /// Largest distance of a large arc from its chord.
    height: Option<f64>,
    /// Whether its ends are known accurately enough.
    known: bool,
}

impl Local {
    /// The curve of a patch relative to a position of the pair's frame; the patch must exist at the orientation.
    #[inline]
    pub(super) fn new(patch: &Patch, turn: Rotation, p: Point) -> Self {
        let [(start, off), (end, end_off)] = [&patch.left, &patch.right]
            .map(|b| b.inner_and_error(&patch.function, turn))
            .map(|(at, error)| (at - p, error));
        let circle = match patch.function {
            ContactFunction::Circle { center, radius } => Some((center.at(turn) - p, radius)),
            _ => None,
        };
        let height = match patch.function {
            ContactFunction::FlatCircle { radius, .. } => {
                Some(0.25 * (end - start).length_squared() / radius.abs())
            }
            _ => None,
        };
        Self {
            start,
            end,
            circle,
            height,
            known: off.max(end_off) < END_ERROR,
        }
    }

    /// First intersection of the ray from the point with the curve.
    #[inline]
    pub(super) fn meet(&self, direction: AxisDirection) -> Meeting {
        if !self.known {
            return Meeting::Unclear;
        }
        let (a, b) = (direction.ahead(self.start), direction.ahead(self.end));
        let at_end = a.y.abs() < END_ERROR || b.y.abs() < END_ERROR;
        if let Some(height) = self.height {
            // A ray beside the box of a large arc does not meet it; any other ray is left to the slice.
            let room = END_ERROR + height;
            let beside = a.y.min(b.y) > room || a.y.max(b.y) < -room || a.x.max(b.x) < -room;
            return if beside {
                Meeting::Nothing
            } else {
                Meeting::Unclear
            };
        }
        match self.circle {
            None => {
                if a.x.max(b.x) < -END_ERROR || (a.y > END_ERROR) == (b.y > END_ERROR) && !at_end {
                    return Meeting::Nothing;
                }
                if at_end {
                    return Meeting::Unclear;
                }
                let distance = a.x - (b.x - a.x) * a.y / (b.y - a.y);
                if distance > 0.0 {
                    // Free space is on the right of the curve from start to end.
                    let from_free = b.y < a.y;
                    Meeting::Curve {
                        distance,
                        from_free,
                    }
                } else {
                    Meeting::Nothing
                }
            }
            Some((center, radius)) => {
                let c = direction.ahead(center);
                let r = radius.abs();
                if c.x + r < -END_ERROR || c.y.abs() > r + END_ERROR {
                    return Meeting::Nothing;
                }
                if at_end {
                    return Meeting::Unclear;
                }
                let square = (r - c.y) * (r + c.y);
                if square < 0.0 {
                    return Meeting::Nothing;
                }
                let half = square.sqrt();
                let arc = Span::new(a - c, b - c, radius);
                for side in [-half, half] {
                    let (q, distance) = (Vector::new(side, -c.y), c.x + side);
                    if distance > 0.0 && arc.contains(q) {
                        let from_free = (side < 0.0) == (radius > 0.0);
                        return Meeting::Curve {
                            distance,
                            from_free,
                        };
                    }
                }
                Meeting::Nothing
            }
        }
    }
}

/// The directions of an arc's points from its centre.
struct Span {
    from: Vector,
    to: Vector,
    beyond_half: bool,
    empty: bool,
}

impl Span {
    /// Directions from one to another, counter-clockwise if the radius is positive. As in slices, ends that have just passed each other are
    /// one point and not a full turn.
    #[inline]
    fn new(start: Vector, end: Vector, radius: f64) -> Self {
        let (from, to) = if radius > 0.0 {
            (start, end)
        } else {
            (end, start)
        };
        let (cross, dot) = (from.cross(to), from.dot(to));
        Self {
            from,
            to,
            beyond_half: cross < 0.0,
            empty: dot > 0.0 && cross <= 0.0 && cross >= -PASSED_ENDS * dot,
        }
    }

    #[inline]
    fn contains(&self, q: Vector) -> bool {
        if self.empty {
            return false;
        }
        let (after, before) = (self.from.cross(q) >= 0.0, q.cross(self.to) >= 0.0);
        if self.beyond_half {
            after || before
        } else {
            after && before
        }
    }
}

/// Whether the carrier of a patch meets the first part of the ray from a position, extended by [`END_ERROR`] at both ends, or comes nearer
/// to it than that. The patch's curve is on its carrier, wherever it ends.
#[inline]
pub(super) fn may_meet(
    patch: &Patch,
    turn: Rotation,
    p: Point,
    direction: AxisDirection,
    stretch: f64,
) -> bool {
    let (from, to) = (-END_ERROR, stretch + END_ERROR);
    let (normal, through) = match patch.function {
        ContactFunction::Circle { center, radius } => {
            let c = direction.ahead(center.at(turn) - p);
            // Whether a point of the ray is outside a circle about the centre.
            let outside = |x: f64, r: f64| (x - c.x) * (x - c.x) > (r - c.y) * (r + c.y);
            let [inner, outer] = [-END_ERROR, END_ERROR].map(|by| radius.abs() + by);
            let apart = c.y.abs() > outer
                || to < c.x && outside(to, outer)
                || from > c.x && outside(from, outer);
            let within = inner > 0.0 && !outside(from, inner) && !outside(to, inner);
            return !(apart || within);
        }
        ContactFunction::FixedLine { normal, through } => (normal, through),
        ContactFunction::MovingLine { normal, through } => (turn * normal, through),
        ContactFunction::FlatCircle { .. } => return true,
    };
    let off = normal.dot(p - through.at(turn));
    let slope = direction.ahead(normal).x;
    let (a, b) = (off + slope * from, off + slope * to);
    !(a.min(b) > END_ERROR || a.max(b) < -END_ERROR)
}

/// Distance of a position from the line or circle of a patch, up to rounding.
#[inline]
pub(super) fn off_cycle(patch: &Patch, turn: Rotation, p: Point) -> f64 {
    patch.function.cycle(turn).distance(p).abs()
}

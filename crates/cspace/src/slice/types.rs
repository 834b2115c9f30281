//! A slice as the user sees it: the boundary of free space at one orientation.

use core::f64::consts::TAU;

use crate::contact::{Curve, CurveShape, Geometry};
use crate::feature::tolerance::TORN;
use crate::feature::{FeatureName, PairFrame};
use crate::geometry::{Point, Vector};
use crate::part::{Edge, Part};

use super::arrange::Arrangement;
use super::coincident::Coincidences;

/// A directed segment or circular arc.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum CurveGeometry {
    /// From start to end.
    Segment {
        /// Where it starts.
        start: Point,
        /// Where it ends.
        end: Point,
    },
    /// From `start_angle` by `sweep` radians about the centre, counter-clockwise if positive.
    Arc {
        /// Centre of the circle.
        center: Point,
        /// Radius of the circle, positive.
        radius: f64,
        /// Direction from the centre to the start, radians.
        start_angle: f64,
        /// Angle travelled, radians.
        sweep: f64,
    },
    /// An arc of a circle so large that places on it would be lost about its centre.
    FlatArc {
        /// Where it starts.
        start: Point,
        /// Where it ends.
        end: Point,
        /// tan(sweep / 4), positive counter-clockwise.
        bulge: f64,
    },
}

/// A piece of the boundary of free space in a slice: blocked space is on its left, free space on its right.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SliceCurve {
    /// The feature of the fixed part that touches.
    pub fixed: FeatureName,
    /// The feature of the moving part that touches.
    pub moving: FeatureName,
    /// Positions (x, y) of the moving part.
    pub geometry: CurveGeometry,
    /// The patch of the contact space this is a slice of; `None` if the slice was computed on its own.
    pub patch: Option<u32>,
    /// The curve of the slice that follows around the boundary.
    pub next: u32,
}

/// All positions at one orientation, split into free and blocked by closed loops of contact curves.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Slice {
    /// The orientation in radians.
    pub theta: f64,
    /// The pieces of the boundary of free space.
    pub curves: Vec<SliceCurve>,
    /// Closed loops, each as indices of its curves in order of travel, beginning with the smallest.
    pub loops: Vec<Vec<u32>>,
    /// Whether the curves are not to be relied upon.
    ///
    /// Of a contact space: at its [doubtful orientations](crate::ContactSpace::doubtful_orientations). Of a slice from
    /// scratch: what bounds curves and tests of overlap contradict each other here and up to 1.2·10⁻¹⁰ rad above, or contacts of
    /// arcs of one loop with arcs of another lie on one circle. Of either: a curve does not begin where the one before it ends.
    #[cfg_attr(feature = "serde", serde(default))]
    pub doubtful: bool,
}

/// Whether an arc that turns from `start_angle` by `sweep` comes past a direction; all radians.
pub(crate) fn is_on_arc(start_angle: f64, sweep: f64, angle: f64) -> bool {
    let turned = (angle - start_angle) * sweep.signum();
    turned - TAU * (turned / TAU).floor() <= sweep.abs()
}

impl CurveGeometry {
    /// The point at fraction `s` of the way, 0 the start and 1 the end.
    pub fn point(&self, s: f64) -> Point {
        match *self {
            Self::Segment { start, end } => start.lerp(end, s),
            Self::Arc {
                center,
                radius,
                start_angle,
                sweep,
            } => center + Vector::from_angle(start_angle + s * sweep) * radius,
            Self::FlatArc { start, end, .. } if start == end => start,
            Self::FlatArc { start, end, bulge } => flat(start, end, bulge).at(s),
        }
    }

    /// A flat arc as an edge.
    pub(crate) fn edge(&self) -> Option<Edge> {
        match *self {
            Self::FlatArc { start, end, bulge } => Some(flat(start, end, bulge)),
            _ => None,
        }
    }

    /// The point of the curve that is nearest to `p`.
    pub fn nearest(&self, p: Point) -> Point {
        match *self {
            Self::Segment { start, end } => {
                let v = end - start;
                let s = (p - start).dot(v) / v.length_squared();
                // NaN for a segment of no length.
                if s > 0.0 {
                    start.lerp(end, s.min(1.0))
                } else {
                    start
                }
            }
            Self::Arc {
                center,
                radius,
                start_angle,
                sweep,
            } => {
                let v = p - center;
                if is_on_arc(start_angle, sweep, v.angle()) {
                    return center + Vector::from_angle(v.angle()) * radius;
                }
                let (start, end) = (self.point(0.0), self.point(1.0));
                nearer(p, start, end)
            }
            Self::FlatArc { start, end, bulge } => {
                let foot = flat(start, end, bulge).foot(p);
                foot.unwrap_or_else(|| nearer(p, start, end))
            }
        }
    }

    /// Length of the curve.
    pub fn length(&self) -> f64 {
        match *self {
            Self::Segment { start, end } => start.distance(end),
            Self::Arc { radius, sweep, .. } => radius * sweep.abs(),
            Self::FlatArc { start, end, bulge } => flat(start, end, bulge).length(),
        }
    }

    /// The unit normal towards free space (right of travel) at fraction `s`; zero of what is but a point, as a segment is at
    /// the critical orientation at which it begins.
    pub fn free_normal(&self, s: f64) -> Vector {
        match *self {
            Self::Segment { start, end } | Self::FlatArc { start, end, .. } if start == end => {
                Vector::ZERO
            }
            Self::Segment { start, end } => (end - start).unit().right(),
            Self::Arc {
                start_angle, sweep, ..
            } => Vector::from_angle(start_angle + s * sweep) * sweep.signum(),
            Self::FlatArc { start, end, bulge } => flat(start, end, bulge).direction_at(s).right(),
        }
    }

    /// From a curve of the pair's frame.
    pub(crate) fn from_inner(
        curve: &Curve,
        from: f64,
        to: f64,
        frame: &PairFrame,
        theta: f64,
    ) -> Self {
        let outer = |p: Point| frame.outer_from_inner(p, theta).position();
        match curve.shape {
            CurveShape::Line { .. } => Self::Segment {
                start: outer(curve.point(from)),
                end: outer(curve.point(to)),
            },
            CurveShape::Circle {
                center,
                radius,
                mid_angle,
                ..
            } => {
                let half_turn = if radius > 0.0 {
                    0.0
                } else {
                    core::f64::consts::PI
                };
                let start = mid_angle + half_turn + from / radius;
                Self::Arc {
                    center: outer(center),
                    radius: frame.outer_length(radius.abs()),
                    start_angle: start - TAU * (start / TAU).round(),
                    sweep: (to - from) / radius,
                }
            }
            CurveShape::FlatArc(arc) => {
                let (p, q) = (curve.point(from), curve.point(to));
                Self::FlatArc {
                    start: outer(p),
                    end: outer(q),
                    bulge: arc.bulge(arc.place(p), arc.place(q)),
                }
            }
        }
    }

    /// The first distance along the ray at which the curve is met, or where it begins nearer to the ray than `joint`: a ray
    /// does not slip through where one curve ends and the next begins.
    pub(crate) fn met(&self, p: Point, d: Vector, joint: f64) -> Option<f64> {
        let v = self.point(0.0) - p;
        let along = v.dot(d);
        let begins = (along > 0.0 && v.cross(d).abs() < joint).then_some(along);
        let hit = self.hit(p, d).map(|h| h.0);
        hit.into_iter().chain(begins).reduce(f64::min)
    }

    /// The first distance along the ray from `p` in the unit direction `d` at which the curve is met, and the
    /// product of the direction with the normal towards free space there.
    pub(crate) fn hit(&self, p: Point, d: Vector) -> Option<(f64, f64)> {
        match *self {
            Self::Segment { start, end } => {
                let v = end - start;
                let slope = d.cross(v);
                let t = (start - p).cross(v) / slope;
                let s = (start - p).cross(d) / slope;
                (t > 0.0 && (0.0..=1.0).contains(&s)).then(|| (t, d.dot(v.right())))
            }
            Self::Arc {
                center,
                radius,
                start_angle,
                sweep,
            } => {
                let v = center - p;
                let (along, across) = (v.dot(d), v.cross(d));
                let square = (radius - across) * (radius + across);
                if square < 0.0 {
                    return None;
                }
                let half = square.sqrt();
                [along - half, along + half].into_iter().find_map(|t| {
                    let q = (p + d * t) - center;
                    (t > 0.0 && is_on_arc(start_angle, sweep, q.angle()))
                        .then(|| (t, d.dot(q) * sweep.signum()))
                })
            }
            Self::FlatArc { start, end, bulge } => flat_hit(&flat(start, end, bulge), p, d),
        }
    }
}

/// Lets every curve without a successor be followed by the nearest that begins within a distance and follows none.
///
/// Where more than two curves meet in a point but for rounding, or two contacts are one curve, the order in which they are
/// met there may leave an end open. Which curves there are does not change.
fn close(curves: &mut [SliceCurve], within: f64) {
    let n = curves.len();
    let is_open = |c: &SliceCurve| c.next as usize >= n;
    if !curves.iter().any(is_open) {
        return;
    }
    let mut follows = vec![false; n];
    for c in curves.iter().filter(|c| !is_open(c)) {
        follows[c.next as usize] = true;
    }
    let mut near: Vec<(f64, usize, usize)> = Vec::new();
    for (i, c) in curves.iter().enumerate().filter(|(_, c)| is_open(c)) {
        let end = c.geometry.point(1.0);
        for (j, d) in curves.iter().enumerate().filter(|&(j, _)| !follows[j]) {
            let distance = end.distance(d.geometry.point(0.0));
            if distance <= within {
                near.push((distance, i, j));
            }
        }
    }
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    for (_, i, j) in near {
        if is_open(&curves[i]) && !follows[j] {
            curves[i].next = j as u32;
            follows[j] = true;
        }
    }
}

fn flat(start: Point, end: Point, bulge: f64) -> Edge {
    Edge {
        start,
        end,
        bulge,
        index: 0,
    }
}

fn nearer(p: Point, start: Point, end: Point) -> Point {
    if p.distance(start) <= p.distance(end) {
        start
    } else {
        end
    }
}

/// The same of an arc by its ends and bulge b: with its chord c and q from its start, points of its circle have
/// (1 − b²) c × q + 2 b q·(c − q) = 0.
fn flat_hit(e: &Edge, p: Point, d: Vector) -> Option<(f64, f64)> {
    let (b, c, q) = (e.bulge, e.end - e.start, p - e.start);
    let flat = (1.0 - b) * (1.0 + b);
    let square = -2.0 * b;
    let slope = flat * c.cross(d) + 2.0 * b * (d.dot(c) - 2.0 * q.dot(d));
    let root = slope * slope - 4.0 * square * e.level(p);
    if root < 0.0 {
        return None;
    }
    let sum = -(slope + root.sqrt().copysign(slope));
    let mut both = [2.0 * e.level(p) / sum, sum / (2.0 * square)];
    both.sort_by(f64::total_cmp);
    both.into_iter().find_map(|t| {
        // The level is positive on the left, and grows by this along the ray.
        let rise = slope + 2.0 * square * t;
        (t > 0.0 && t.is_finite() && e.covers_way(q + d * t)).then_some((t, -rise))
    })
}

impl Slice {
    /// Computes the slice of a pair at one orientation from scratch.
    ///
    /// If `theta` is a critical orientation, the slice just above it is meant: within 1e-9 rad, or 1e-7 rad beside a tangency. For many slices
    /// of one pair a [`Slicer`](crate::Slicer) is faster.
    ///
    /// ```
    /// use cspace::{Part, Slice, Vertex};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slice = Slice::compute(&square("fixed", 2.0)?, &square("moving", 1.0)?, 0.1);
    /// assert_eq!(slice.loops.len(), 1);
    /// assert_eq!(slice.curves.len(), 8);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn compute(fixed: &Part, moving: &Part, theta: f64) -> Self {
        let geometry = Geometry::new(
            fixed,
            moving,
            Some((theta - 0.25, theta + 0.25)),
            usize::MAX,
        );
        let sheets = geometry.contacts.sheets.len() as u32;
        let arrangement = Arrangement::new(&geometry, &Coincidences::new(&geometry), theta, |t| {
            (t, 0..sheets)
        });
        Self::from_arrangement(&arrangement, &geometry, theta)
    }

    /// The arrangement as positions at the orientation that was asked for, of which it may be a little aside.
    pub(crate) fn from_arrangement(
        arrangement: &Arrangement,
        geometry: &Geometry,
        theta: f64,
    ) -> Self {
        let curves = arrangement
            .gaps
            .iter()
            .map(|gap| {
                let sheet = &geometry.contacts.sheets[gap.sheet as usize];
                SliceCurve {
                    fixed: geometry.fixed.features[sheet.fixed as usize].name,
                    moving: geometry.moving.features[sheet.moving as usize].name,
                    geometry: CurveGeometry::from_inner(
                        &gap.curve,
                        gap.from_position,
                        gap.to_position,
                        &geometry.frame,
                        theta,
                    ),
                    patch: None,
                    next: gap.next,
                }
            })
            .collect();
        Self::from_curves(theta, curves, arrangement.doubtful, &geometry.frame)
    }

    /// Finds the loops of curves that know their successors; those that do not are followed by what begins where they end.
    pub(crate) fn from_curves(
        theta: f64,
        mut curves: Vec<SliceCurve>,
        doubtful: bool,
        frame: &PairFrame,
    ) -> Self {
        let torn = frame.outer_length(TORN);
        close(&mut curves, torn);
        let mut seen = vec![false; curves.len()];
        let mut loops = Vec::new();
        for first in 0..curves.len() {
            let mut walk = Vec::new();
            let mut at = first;
            while at < curves.len() && !seen[at] {
                seen[at] = true;
                walk.push(at as u32);
                at = curves[at].next as usize;
            }
            if !walk.is_empty() {
                loops.push(walk);
            }
        }
        let is_open = |c: &SliceCurve| {
            let next = curves.get(c.next as usize);
            next.is_none_or(|n| c.geometry.point(1.0).distance(n.geometry.point(0.0)) > torn)
        };
        Self {
            theta,
            doubtful: doubtful || curves.iter().any(is_open),
            curves,
            loops,
        }
    }

    /// Whether a position of the moving part is free at this orientation: the first contact curve a ray meets is met
    /// from its free side, or none is.
    ///
    /// At a critical orientation two curves that face each other may lie on one carrier, as far as it is known, in either
    /// order; and where one curve ends and the next begins a ray may slip through: one that meets such two, or passes such
    /// a place, is not asked, as long as there is another.
    pub fn is_free(&self, position: Point) -> bool {
        self.first_met(position).is_none_or(|met| met.from_free)
    }

    /// The curve that bounds the space a position is in, as far as a ray tells; `None` if there is nothing that way.
    pub(crate) fn first_met(&self, position: Point) -> Option<Met> {
        /// The first of the directions; this one is no engineer's.
        const FIRST: f64 = 1.234_567_89;
        /// From each to the next, radians: the golden section of a turn.
        const STEP: f64 = 2.399_963_229_728_653;
        const DIRECTIONS: u32 = 7;
        /// Curves that face each other further apart than this, as a share of the way to the first, are in the order met.
        const APART: f64 = 1e-7;
        /// And further than this as a share of the way to the last: what is between may have closed just there.
        const SLIVER: f64 = 1e-9;
        /// A ray that passes a joint of two curves at more than this, as a share of the way to the farthest, does not slip
        /// through: such ends are within [`TORN`] of each other.
        const BESIDE: f64 = 2.0 * TORN;
        let joints: Vec<Vector> = (self.curves.iter())
            .map(|c| c.geometry.point(0.0) - position)
            .collect();
        let farthest = joints
            .iter()
            .map(|v| v.length_squared())
            .fold(0.0, f64::max);
        let beside = BESIDE * farthest.sqrt();
        let mut widest = (f64::NEG_INFINITY, None);
        for k in 0..DIRECTIONS {
            let d = Vector::from_angle(FIRST + STEP * f64::from(k));
            // The nearest curve met from its free side, and from its blocked side.
            let [mut free, mut blocked] = [(f64::INFINITY, 0); 2];
            let mut last: f64 = 0.0;
            for (i, c) in self.curves.iter().enumerate() {
                if let Some((t, towards_free)) = c.geometry.hit(position, d) {
                    last = last.max(t);
                    let side = if towards_free < 0.0 {
                        &mut free
                    } else {
                        &mut blocked
                    };
                    if t < side.0 {
                        *side = (t, i);
                    }
                }
            }
            let from_free = free.0 < blocked.0;
            let (first, curve) = if from_free { free } else { blocked };
            let met = first.is_finite().then_some(Met { curve, from_free });
            let apart = if met.is_some() {
                (free.0 - blocked.0).abs()
            } else {
                f64::INFINITY
            };
            // How near the way to what is met passes a joint.
            let clear = (joints.iter())
                .filter(|&&v| (-beside..=first + beside).contains(&d.dot(v)))
                .map(|&v| d.cross(v).abs())
                .fold(f64::INFINITY, f64::min);
            let room = apart.min(clear);
            if room > widest.0 {
                widest = (room, met);
            }
            let in_order = met.is_none() || apart > (APART * first).max(SLIVER * last);
            if in_order && clear > beside {
                break;
            }
        }
        widest.1
    }
}

/// A curve of a slice, met by a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Met {
    pub(crate) curve: usize,
    /// Whether the ray comes from the curve's free side.
    pub(crate) from_free: bool,
}

#[cfg(test)]
mod tests;

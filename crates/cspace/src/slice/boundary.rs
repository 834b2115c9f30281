//! A slice for users: the boundary of free space at one orientation.

use crate::feature::tolerance::{FACING, FACING_FAR, TORN};
use crate::feature::{FeatureName, PairFrame};
use crate::geometry::{Point, Vector};
use crate::ids::PatchId;

use super::curve_geometry::CurveGeometry;

/// A piece of the boundary of free space in a slice: blocked space is on its left, free space on its right.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SliceCurve {
    /// The feature of the fixed part that touches.
    pub fixed: FeatureName,
    /// The feature of the moving part that touches.
    pub moving: FeatureName,
    /// Positions (x, y) of the moving part.
    pub geometry: CurveGeometry,
    /// The patch of the contact space from which the curve comes; `None` if the slice was computed on its own.
    #[cfg_attr(feature = "schema", schemars(with = "Option<u32>"))]
    pub patch: Option<PatchId>,
    /// The curve of the slice that follows around the boundary.
    pub next: u32,
}

/// All positions at one orientation, split into free and blocked by closed loops of contact curves.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Slice {
    /// The orientation in radians.
    pub theta: f64,
    /// The pieces of the boundary of free space.
    pub curves: Vec<SliceCurve>,
    /// Closed loops, each as indices of its curves in order of travel, beginning with the smallest.
    pub loops: Vec<Vec<u32>>,
    /// Whether the curves are unreliable.
    ///
    /// A slice of a contact space is doubtful at the space's [doubtful orientations](crate::ContactSpace::doubtful_orientations). A slice
    /// computed from scratch is doubtful at the doubtful orientations of the space of orientations around it; where an arc lies on another
    /// contact, circle on circle; and if there are too many contacts to compute it. Either is doubtful if a curve does not begin where the
    /// one before it ends.
    #[cfg_attr(feature = "serde", serde(default))]
    pub doubtful: bool,
}

/// Joins every curve without a successor to the nearest one that begins within a distance and follows no other.
///
/// Where more than two curves meet in a point up to rounding, or two contacts are one curve, the order in which they are met there may
/// leave an end open. The set of curves does not change.
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

impl Slice {
    /// The curve nearest to a position of the moving part, and its nearest point; `None` if there is no curve.
    ///
    /// From a blocked position, the nearest point is the end of the shortest translation without overlap.
    pub fn nearest(&self, position: Point) -> Option<(&SliceCurve, Point)> {
        (self.curves.iter())
            .map(|curve| (curve, curve.geometry.nearest(position)))
            .min_by(|a, b| (a.1.distance(position)).total_cmp(&b.1.distance(position)))
    }

    /// Slice of the given loops, each with its curves in order of travel; successors are set here.
    pub(crate) fn of_loops(theta: f64, loops: Vec<Vec<SliceCurve>>, doubtful: bool) -> Self {
        let mut slice = Self {
            theta,
            curves: Vec::new(),
            loops: Vec::new(),
            doubtful,
        };
        for drawn in loops {
            let first = slice.curves.len() as u32;
            let end = first + drawn.len() as u32;
            for (next, curve) in (first + 1..end).chain([first]).zip(drawn) {
                slice.curves.push(SliceCurve { next, ..curve });
            }
            slice.loops.push((first..end).collect());
        }
        slice
    }

    /// The curves of a loop, in order of travel.
    pub(crate) fn along<'a>(&'a self, indices: &'a [u32]) -> impl Iterator<Item = SliceCurve> + 'a {
        indices.iter().map(|&i| self.curves[i as usize])
    }

    /// Finds the loops of curves that know their successors; a curve without a successor is followed by one that begins where it ends.
    pub(crate) fn from_curves(
        theta: f64,
        curves: Vec<SliceCurve>,
        doubtful: bool,
        frame: &PairFrame,
    ) -> Self {
        let ends = |c: &SliceCurve| (c.geometry.point(0.0), c.geometry.point(1.0));
        let ends: Vec<(Point, Point)> = curves.iter().map(ends).collect();
        Self::from_curves_and_ends(theta, curves, &ends, doubtful, frame)
    }

    /// Finds the loops of curves, as [`from_curves`](Self::from_curves), given the points where every curve begins and ends.
    pub(crate) fn from_curves_and_ends(
        theta: f64,
        mut curves: Vec<SliceCurve>,
        ends: &[(Point, Point)],
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
        let is_open = |(c, end): (&SliceCurve, &(Point, Point))| {
            let next = ends.get(c.next as usize);
            next.is_none_or(|n| end.1.distance(n.0) > torn)
        };
        Self {
            theta,
            doubtful: doubtful || curves.iter().zip(ends).any(is_open),
            curves,
            loops,
        }
    }

    /// Whether a position of the moving part is free at this orientation: the first contact curve that a ray meets is met from its free
    /// side, or there is no such curve.
    ///
    /// At a critical orientation two curves that face each other may lie on one carrier, within its accuracy, in either order; and where
    /// one curve ends and the next begins there may be a gap, of 1e-8 beside a tangency. A ray that meets two such curves, or passes such a
    /// place, is not used as long as there is another; if it must be used, gaps are closed by segments.
    pub fn is_free(&self, position: Point) -> bool {
        self.first_met(position).is_none_or(|met| met.from_free)
    }

    /// The curve that bounds the space in which a position is, according to a ray; `None` if the ray meets nothing.
    pub(crate) fn first_met(&self, position: Point) -> Option<Met> {
        /// Direction of the first ray, in radians. Arbitrary, so that it is unlikely to be parallel to an edge.
        const FIRST: f64 = 1.234_567_89;
        /// Angle from each ray to the next, radians: the golden section of a turn.
        const STEP: f64 = 2.399_963_229_728_653;
        const DIRECTIONS: u32 = 7;
        /// Distance from a joint of two curves, as a share of the distance to the farthest end, above which a ray does not pass through the
        /// joint: such ends are within [`TORN`] of each other.
        const BESIDE: f64 = 2.0 * TORN;
        let joints: Vec<Vector> = (self.curves.iter())
            .map(|c| c.geometry.point(0.0) - position)
            .collect();
        let farthest = joints
            .iter()
            .map(|v| v.length_squared())
            .fold(0.0, f64::max);
        let [beside, closed] = [BESIDE, FACING_FAR].map(|share| share * farthest.sqrt());
        let mut widest = (f64::NEG_INFINITY, None);
        for k in 0..DIRECTIONS {
            let d = Vector::from_angle(FIRST + STEP * f64::from(k));
            let mut hits = Hits::default();
            for (i, c) in self.curves.iter().enumerate() {
                hits.add(i, c.geometry.hit(position, d));
            }
            // Distance at which the ray passes joints before the first curve that it meets.
            let clear = |hits: &Hits| {
                let ahead = -beside..=hits.first() + beside;
                (joints.iter())
                    .filter(|&&v| ahead.contains(&d.dot(v)))
                    .map(|&v| d.cross(v).abs())
                    .fold(f64::INFINITY, f64::min)
            };
            let mut room = clear(&hits);
            let is_clear = room > beside;
            if !is_clear {
                for (i, c) in self.curves.iter().enumerate() {
                    let Some(&start) = joints.get(c.next as usize) else {
                        continue;
                    };
                    let gap = CurveGeometry::Segment {
                        start: c.geometry.point(1.0),
                        end: position + start,
                    };
                    hits.add(i, gap.hit(position, d));
                }
                room = clear(&hits);
            }
            let (met, apart) = (hits.met(), hits.apart());
            room = room.min(apart);
            if room > widest.0 {
                widest = (room, met);
            }
            let in_order = met.is_none() || apart > (FACING * hits.first()).max(closed);
            if is_clear && in_order {
                break;
            }
        }
        widest.1
    }
}

/// The first curves that a ray meets.
struct Hits {
    /// Distance and number of the first curve met from its free side.
    free: (f64, usize),
    /// Distance and number of the first curve met from its blocked side.
    blocked: (f64, usize),
}

impl Default for Hits {
    fn default() -> Self {
        Self {
            free: (f64::INFINITY, 0),
            blocked: (f64::INFINITY, 0),
        }
    }
}

impl Hits {
    /// Adds a curve's [`hit`](CurveGeometry::hit).
    fn add(&mut self, curve: usize, hit: Option<(f64, f64)>) {
        let Some((t, towards_free)) = hit else {
            return;
        };
        let side = if towards_free < 0.0 {
            &mut self.free
        } else {
            &mut self.blocked
        };
        if t < side.0 {
            *side = (t, curve);
        }
    }

    /// The distance of the first curve; infinite if there is none.
    fn first(&self) -> f64 {
        self.free.0.min(self.blocked.0)
    }

    fn met(&self) -> Option<Met> {
        let from_free = self.free.0 < self.blocked.0;
        let (first, curve) = if from_free { self.free } else { self.blocked };
        first.is_finite().then_some(Met { curve, from_free })
    }

    /// The distance between the first curves of both sides along the ray; infinite if nothing is met.
    fn apart(&self) -> f64 {
        if self.first().is_finite() {
            (self.free.0 - self.blocked.0).abs()
        } else {
            f64::INFINITY
        }
    }
}

/// A curve of a slice, met by a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Met {
    pub(crate) curve: usize,
    /// Whether the ray comes from the curve's free side.
    pub(crate) from_free: bool,
}

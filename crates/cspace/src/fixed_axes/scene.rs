//! Both parts on their axes, and tests of whether their normals oppose each other.

use super::motion::{Extent, Motions, Placement};
use super::repeats::Repeats;
use crate::feature::{Feature, FeatureKind, Outline};
use crate::geometry::{Point, Vector, wrap};
use core::f64::consts::PI;

/// Angle below which normals oppose each other exactly (radians): the rounding of the configurations at which this is tested, with a
/// margin. Growth separates normals by some 1e-13, which is resolved and consistent with other results for the place.
const TIE: f64 = 2e-14;

/// Both parts, and their motions.
#[derive(Debug)]
pub(super) struct Scene {
    pub(super) first: Side,
    pub(super) second: Side,
    pub(super) motions: Motions,
    pub(super) x: Extent,
    pub(super) y: Extent,
    /// Symmetry of the first part.
    pub(super) repeats: Repeats,
}

impl Scene {
    /// Angle, counter-clockwise, of a normal of the second part from the opposite of a normal of the first.
    ///
    /// Where both oppose each other, permanently or just there, the second counts as turned by a little more. Every pair tests this for the
    /// same two joints, so the results are consistent.
    fn beyond(&self, first_angle: f64, second_angle: f64, theta: f64) -> f64 {
        let angle = wrap(second_angle + theta + PI - first_angle);
        if angle.abs() < TIE { 0.0 } else { angle }
    }

    /// Whether two smooth joints between arcs oppose each other in passing. The order in which the contact passes them is then not known;
    /// so all four pairs of arcs are cut there, and each is classified as contact or not away from that place.
    pub(super) fn tied(&self, first_joint: u32, second_joint: u32, theta: f64) -> bool {
        let turning = self.motions.first.turns() || self.motions.second.turns();
        let smooth = |side: &Side, joint: u32| {
            side.line[joint as usize].is_none() && side.vertex[joint as usize].is_none()
        };
        let (a, b) = (
            self.first.angle(first_joint),
            self.second.angle(second_joint),
        );
        turning
            && self.beyond(a, b, theta) == 0.0
            && smooth(&self.first, first_joint)
            && smooth(&self.second, second_joint)
    }

    /// Whether a round feature, of the second part or of the first, has the normal opposite to that of a joint of the other part.
    pub(super) fn has(&self, of_second: bool, f: &Feature, joint: u32, theta: f64) -> bool {
        let [lo, hi] = f.joints_by_angle();
        let [lo, hi] = [lo, hi].map(|end| {
            let (j, k) = if of_second {
                (joint, end)
            } else {
                (end, joint)
            };
            self.beyond(self.first.angle(j), self.second.angle(k), theta)
        });
        if of_second {
            within(f, lo < 0.0, lo, hi >= 0.0, hi, -1.0)
        } else {
            within(f, lo >= 0.0, lo, hi < 0.0, hi, 1.0)
        }
    }

    /// Whether the normals of the pair can oppose each other when neither part turns.
    pub(super) fn normals_meet(&self, ia: u32, ib: u32) -> bool {
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        match (a.is_line(), b.is_line()) {
            (true, _) => self.has(true, b, a.start, 0.0),
            (_, true) => self.has(false, a, b.start, 0.0),
            _ => true,
        }
    }

    pub(super) fn first_feature(&self, i: u32) -> &Feature {
        &self.first.outline.features[i as usize]
    }

    pub(super) fn second_feature(&self, i: u32) -> &Feature {
        &self.second.outline.features[i as usize]
    }
}

/// Whether a normal is inside an interval of normals, given the decisions and distances at its two ends.
fn within(f: &Feature, above_lo: bool, to_lo: f64, below_hi: bool, to_hi: f64, sign: f64) -> bool {
    let width = f.hi - f.lo;
    if width < PI - NEAR {
        return above_lo && below_hi;
    }
    if to_lo.abs() < NEAR {
        return above_lo;
    }
    if to_hi.abs() < NEAR {
        return below_hi;
    }
    // Away from both ends: by the distance from the middle.
    let from_lo = sign * to_lo;
    wrap(from_lo - 0.5 * width).abs() < 0.5 * width
}

// One part: its outline, and the features of its joints.

/// Distance from an end of an interval of normals (radians) below which only that end decides.
const NEAR: f64 = 1e-3;

/// One part with the features of its joints.
#[derive(Debug)]
pub(super) struct Side {
    pub(super) outline: Outline,
    pub(super) vertex: Vec<Option<u32>>,
    pub(super) line: Vec<Option<u32>>,
    pub(super) cones: Vec<Cone>,
}

/// The normals of a feature: a cone about the middle one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cone {
    middle: Vector,
    /// Cosine of slightly more than half its width.
    least: f64,
}

impl Cone {
    fn new(f: &Feature) -> Self {
        Self {
            middle: Vector::from_angle(0.5 * (f.lo + f.hi)),
            least: (0.5 * (f.hi - f.lo) + NEAR).min(PI).cos(),
        }
    }

    /// Whether a direction is among the normals, or near them: a fast test before the decision.
    pub(super) fn may_hold(&self, direction: Vector) -> bool {
        self.middle.dot(direction) >= self.least
    }
}

impl Side {
    pub(super) fn new(outline: Outline) -> Self {
        Self {
            vertex: outline.of_joints(FeatureKind::Vertex),
            line: outline.of_joints(FeatureKind::Line),
            cones: outline.features.iter().map(Cone::new).collect(),
            outline,
        }
    }

    pub(super) fn point(&self, joint: u32) -> Point {
        self.outline.joints[joint as usize].point
    }

    pub(super) fn normal(&self, joint: u32) -> Vector {
        self.outline.joints[joint as usize].normal
    }

    pub(super) fn angle(&self, joint: u32) -> f64 {
        self.outline.joints[joint as usize].angle
    }

    /// Normal, start and angle of a line.
    pub(super) fn line(&self, line: &Feature) -> (Vector, Point, f64) {
        let start = line.start;
        (self.normal(start), self.point(start), self.angle(start))
    }

    /// Whether a point of the other part, as seen from this part, is beside a line and not beyond its ends.
    pub(super) fn beside(
        &self,
        line: &Feature,
        point: Point,
    ) -> impl Fn(Placement) -> bool + use<> {
        let (start, along, length) = self.segment(line);
        move |seen| {
            let at = along.dot(seen.point(point) - start);
            0.0 < at && at < length
        }
    }

    /// Start of a line, its unit direction of travel, and its length.
    pub(super) fn segment(&self, line: &Feature) -> (Point, Vector, f64) {
        let (start, end) = (self.point(line.start), self.point(line.end));
        let along = self.normal(line.start).left();
        (start, along, along.dot(end - start))
    }
}

//! One part: its outline, and what its joints belong to.

use core::f64::consts::PI;

use crate::feature::{Feature, Outline};
use crate::geometry::{Point, Vector};

/// Normals nearer than this to an end of an interval of normals are told by that end alone (radians).
pub(super) const NEAR: f64 = 1e-3;

/// One part with what its joints belong to.
#[derive(Debug)]
pub(super) struct Side {
    pub(super) outline: Outline,
    pub(super) vertex: Vec<Option<u32>>,
    pub(super) line: Vec<Option<u32>>,
    pub(super) cones: Vec<Cone>,
}

/// The normals of a feature: about a middle one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cone {
    middle: Vector,
    /// Cosine of half its width and a little more.
    least: f64,
}

impl Cone {
    fn new(f: &Feature) -> Self {
        Self {
            middle: Vector::from_angle(0.5 * (f.lo + f.hi)),
            least: (0.5 * (f.hi - f.lo) + NEAR).min(PI).cos(),
        }
    }

    /// Whether a direction is among the normals, or near to them: a quick look before the decision.
    pub(super) fn may_hold(&self, direction: Vector) -> bool {
        self.middle.dot(direction) >= self.least
    }
}

impl Side {
    pub(super) fn new(outline: Outline) -> Self {
        Self {
            vertex: outline.vertex_of_joint(),
            line: outline.line_of_joint(),
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

    /// Start of a line's, its unit direction of travel, and its length.
    pub(super) fn segment(&self, line: &Feature) -> (Point, Vector, f64) {
        let (start, end) = (self.point(line.start), self.point(line.end));
        let along = self.normal(line.start).left();
        (start, along, along.dot(end - start))
    }
}

//! Two pieces that are near each other, and how their distance changes.

use cspace::{FeatureName, Point, Vector};

use super::pose::{Coords, Pose};

/// Two pieces that are near each other.
#[derive(Debug, Clone, Copy)]
pub struct Near {
    /// Their distance along the common normal.
    pub distance: f64,
    /// How it changes with each coordinate.
    pub gradient: Coords,
    /// The features of the fixed and of the moving part.
    pub features: (FeatureName, FeatureName),
    /// The nearest points, each in its part's own frame.
    pub(super) points: (Point, Point),
    /// From the one on the fixed part to the other, of unit length.
    pub(super) direction: Vector,
}

impl Near {
    /// Two features that touch, whose distance changes by a gradient.
    pub(crate) fn growing(gradient: Coords, features: (FeatureName, FeatureName)) -> Self {
        Self {
            distance: 0.0,
            gradient,
            features,
            points: (Point::ORIGIN, Point::ORIGIN),
            direction: Vector::ZERO,
        }
    }

    /// How fast the distance changes on a leg.
    pub(super) fn rate(&self, poses: (&Pose, &Pose)) -> f64 {
        let (a, b) = (poses.0.at(0.0), poses.1.at(0.0));
        let relative = b.point(self.points.1).velocity - a.point(self.points.0).velocity;
        self.direction.dot(relative)
    }
}

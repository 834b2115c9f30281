//! Discs about edges: what cannot touch is told from them.

use crate::contact::{FeatureShape, Placement};
use crate::number::Enclosure;

use super::{DrawnEdge, DrawnPair};

/// A disc in which an edge lies, in all drawings: about the middle of its chord, as large as half the chord or the height of the arc.
pub(super) struct Disc<T> {
    center: [T; 2],
    radius: f64,
}

impl<T: Enclosure> Disc<T> {
    pub(super) fn about(edge: &DrawnEdge<T>) -> Self {
        let FeatureShape::Edge { start, end, bulge } = edge.shape else {
            return Self {
                center: [T::constant(0.0); 2],
                radius: f64::INFINITY,
            };
        };
        let half = T::constant(0.5);
        let chord = (end[0] - start[0]).hypot(end[1] - start[1]);
        let height = bulge.abs().ball().ends()[1].max(1.0);
        Self {
            center: [half * (start[0] + end[0]), half * (start[1] + end[1])],
            radius: (half * chord * T::constant(height)).ball().ends()[1],
        }
    }
}

/// How far the middles of two discs are apart, anywhere in an enclosure.
pub(super) struct Apart {
    distance: f64,
    spread: f64,
    /// Both radii together.
    touching: f64,
}

impl Apart {
    /// Whether the discs do not meet.
    pub(super) fn is_certain(&self) -> bool {
        self.distance > (self.touching + self.spread) * (1.0 + 1e-9)
    }

    /// Whether a narrower enclosure would tell much more.
    pub(super) fn is_vague(&self) -> bool {
        self.spread > self.touching || self.spread.is_nan()
    }
}

impl<T: Enclosure> Disc<T> {
    /// How far this disc of the fixed part and one of the moving part are apart.
    pub(super) fn apart(&self, moving: &Self, facing: &Placement<T>) -> Apart {
        let [x, y] = facing.point(moving.center);
        let [x, y] = [x - self.center[0], y - self.center[1]].map(T::ball);
        Apart {
            distance: x.mid.hypot(y.mid),
            spread: x.radius.hypot(y.radius),
            touching: self.radius + moving.radius,
        }
    }
}

impl<T: Enclosure> DrawnPair<T> {
    /// Discs about the edges of both parts.
    pub(super) fn discs(&self) -> [Vec<Disc<T>>; 2] {
        [0, 1].map(|part| self.edges[part].iter().map(Disc::about).collect())
    }
}

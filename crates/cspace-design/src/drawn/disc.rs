//! Discs about edges, by which pairs of edges that cannot touch are excluded.

use cspace::{FeatureShape, Placement};

use super::{DrawnEdge, DrawnPair, Enclosure};

/// A disc that contains an edge in all drawings: its centre is the middle of the chord, its radius half the chord or the height of the arc.
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

/// Distance between the centres of two discs, over a whole enclosure.
pub(super) struct Apart {
    distance: f64,
    spread: f64,
    /// Sum of both radii.
    touching: f64,
}

impl Apart {
    /// Whether the discs certainly do not meet.
    pub(super) fn is_certain(&self) -> bool {
        self.distance > (self.touching + self.spread) * (1.0 + 1e-9)
    }

    /// Whether a narrower enclosure would decide much more.
    pub(super) fn is_vague(&self) -> bool {
        self.spread > self.touching || self.spread.is_nan()
    }
}

impl<T: Enclosure> Disc<T> {
    /// Distance of this disc of the fixed part from a disc of the moving part.
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

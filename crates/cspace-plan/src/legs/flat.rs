//! Lines, and arcs so flat that their centres are far away.
//!
//! A flat arc is told by its middle m, the unit tangent t there with its left normal n, and its curvature k; a line has k = 0.
//! The height of a point c above it, with w = c − m, is
//!
//! ```text
//! h = (1 − |n − k w|) / k = (2 n·w − k |w|²) / (1 + |n − k w|)
//! ```
//!
//! The second form subtracts no large numbers. The centre m + n/k is not used.

use cspace::{Edge, Point, Vector};

/// A line or a flat arc, in its part's own frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flat {
    pub(super) middle: Point,
    /// The unit tangent in the middle.
    pub(super) along: Vector,
    /// Half the length of the chord.
    pub(super) half: f64,
    /// Positive if the arc bends to the left of `along`.
    pub(super) curvature: f64,
}

/// Where a point is, as seen from a flat arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    /// Its signed distance from the whole circle, positive to the left of the arc.
    pub(super) height: f64,
    /// The unit normal at the foot, to the left of the arc: the gradient of the height.
    pub(super) up: Vector,
    /// The place of the foot along the chord, from its middle.
    pub(super) foot: f64,
    /// |n − k w|: one, but for points as far away as the centre.
    pub(super) stretch: f64,
}

impl Flat {
    pub(super) fn of(e: &Edge) -> Self {
        let chord = e.end - e.start;
        let length = chord.length();
        let along = chord * (1.0 / length);
        Self {
            middle: e.middle(),
            along,
            half: 0.5 * length,
            curvature: e.curvature(),
        }
    }

    pub(super) fn seen(&self, c: Point) -> Seen {
        let w = c - self.middle;
        let n = self.along.left();
        let k = self.curvature;
        let from_center = n - w * k;
        let stretch = from_center.length();
        Seen {
            height: (2.0 * n.dot(w) - k * w.length_squared()) / (1.0 + stretch),
            up: from_center * (1.0 / stretch),
            foot: w.dot(self.along) / stretch,
            stretch,
        }
    }

    /// The point of the arc at a place along the chord.
    pub(super) fn point(&self, x: f64) -> Point {
        let k = self.curvature;
        let rise = k * x * x / (1.0 + (1.0 - (k * x).powi(2)).max(0.0).sqrt());
        self.middle + self.along * x + self.along.left() * rise
    }

    pub(super) fn ends(&self) -> [Point; 2] {
        [-self.half, self.half].map(|x| self.point(x))
    }

    /// The angle by which the normal turns from the middle to an end, radians.
    pub(super) fn turn(&self) -> f64 {
        (self.half * self.curvature).abs().min(1.0).asin()
    }

    /// Whether a place along the chord belongs to the arc, up to a share of its length.
    pub(super) fn has(&self, foot: f64, slack: f64) -> bool {
        foot.abs() <= self.half * (1.0 + slack)
    }
}

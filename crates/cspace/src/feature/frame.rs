//! The frame in which a pair is computed.

use super::tolerance::{CONTACT, GROWTH, MITRE};
use super::types::Outline;
use crate::geometry::{Configuration, Point, Rotation, Vector};
use crate::part::{Edge, Part};

/// Both parts about their own centres, scaled by a power of two into the unit disc.
///
/// With centres c and d of the fixed and the moving part, and scale s, a configuration (p, θ) of the pair is at
/// s (p − c + `R_θ` d) in this frame. The scale is a power of two, so scaling is exact. Contact functions and boundary curves
/// of [`Patch`](crate::Patch)es are written in this frame.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairFrame {
    /// Centre of the fixed part, in its own frame.
    pub fixed_center: Point,
    /// Centre of the moving part, in its own frame.
    pub moving_center: Point,
    /// Scale from the model's unit to the frame: a power of two.
    pub scale: f64,
}

impl PairFrame {
    /// The frame of two parts about their own centres.
    pub(crate) fn new(fixed: &Part, moving: &Part) -> Self {
        let (fixed_center, moving_center) = (Self::center(fixed), Self::center(moving));
        Self {
            fixed_center,
            moving_center,
            scale: Self::scale_of([(fixed, fixed_center), (moving, moving_center)]),
        }
    }

    /// The centre of a part without symmetry: that of its box, or of a slightly larger one.
    pub(crate) fn center(part: &Part) -> Point {
        let (mut lo, mut hi) = (
            Point::new(f64::INFINITY, f64::INFINITY),
            Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
        );
        for p in part.edges().flat_map(extent) {
            lo = Point::new(lo.x.min(p.x), lo.y.min(p.y));
            hi = Point::new(hi.x.max(p.x), hi.y.max(p.y));
        }
        lo.midpoint(hi)
    }

    /// The power of two that scales parts about their centres into the unit disc.
    pub(crate) fn scale_of(parts: [(&Part, Point); 2]) -> f64 {
        let [a, b] = parts.map(|(part, center)| radius_about(part, center));
        let radius = a.max(b);
        if radius > 0.0 && radius.is_finite() {
            (-radius.log2().ceil()).exp2()
        } else {
            1.0
        }
    }

    /// Largest distance from the origin of this frame at which the moving part can be in contact with the fixed part: the sum of their
    /// radii, plus growth.
    pub(crate) fn reach(&self, fixed: &Part, moving: &Part) -> f64 {
        let grown = 4.0 * MITRE * GROWTH;
        let radii =
            radius_about(fixed, self.fixed_center) + radius_about(moving, self.moving_center);
        radii * self.scale + grown
    }

    /// Largest displacement of a contact of these parts that comes from growth, in this frame: it increases with the sharpness of their
    /// corners. 0 where it is within half of [`CONTACT`].
    ///
    /// Each part comes with the largest growth of its sides.
    pub(crate) fn grown(&self, fixed: (&Part, f64), moving: (&Part, f64)) -> f64 {
        let mitre = |part, center| Outline::longest_mitre(part, center, self.scale);
        let grown = fixed.1 * mitre(fixed.0, self.fixed_center)
            + moving.1 * mitre(moving.0, self.moving_center);
        if grown > 0.5 * CONTACT { grown } else { 0.0 }
    }

    /// Bound of the rounding error of positions within reach, in this frame: parts may be drawn far from their origins.
    pub(crate) fn rounding(&self) -> f64 {
        let drawn = |center: Point| center.to_vector().length() * self.scale;
        32.0 * f64::EPSILON * (drawn(self.fixed_center) + drawn(self.moving_center) + 2.0)
    }

    /// Converts a configuration's position to this frame.
    pub(crate) fn inner_from_outer(&self, c: Configuration) -> Point {
        let turned = Rotation::by(c.theta) * self.moving_center.to_vector();
        let v = (c.position() - self.fixed_center) + turned;
        Point::ORIGIN + v * self.scale
    }

    /// Converts a position of this frame to a configuration.
    pub(crate) fn outer_from_inner(&self, p: Point, theta: f64) -> Configuration {
        let turned = Rotation::by(theta) * self.moving_center.to_vector();
        let q = self.fixed_center + (p.to_vector() * (1.0 / self.scale) - turned);
        Configuration::new(q.x, q.y, theta)
    }

    /// Converts a length of this frame to the model's unit.
    #[inline]
    pub(crate) fn outer_length(&self, length: f64) -> f64 {
        length / self.scale
    }
}

/// Upper bound of the distance of the boundary from a point.
fn radius_about(part: &Part, center: Point) -> f64 {
    part.edges()
        .map(|e| {
            let far_end = center.distance(e.start).max(center.distance(e.end));
            far_end + e.height()
        })
        .fold(0.0, f64::max)
}

/// Points whose bounding box contains the edge: its ends, and the corners of its bulge.
fn extent(edge: Edge) -> impl Iterator<Item = Point> {
    let chord = edge.end - edge.start;
    let up = chord.right() * (0.5 * edge.bulge);
    // An arc beyond a half circle is wider than its chord, by its radius minus half the chord on either side.
    let wide = if edge.bulge.abs() > 1.0 {
        let excess = edge.radius() / chord.length() - 0.5;
        chord * excess
    } else {
        Vector::ZERO
    };
    [
        edge.start + (-wide),
        edge.end + wide,
        edge.start + up + (-wide),
        edge.end + up + wide,
    ]
    .into_iter()
}

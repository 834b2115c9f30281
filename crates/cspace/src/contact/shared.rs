//! Ends, circles and directions that two sheets share by construction, and that are therefore known to be equal without computing.

use crate::feature::tolerance::{CLOSE_CENTERS, SAME_CARRIER};

use super::sheet::Sheet;
use super::spiral::Spiral;

/// Ends that two sheets share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SharedEnds {
    /// Whether the carriers are one, or tangent at every orientation: then the curves do not cross.
    pub(crate) tangent: bool,
    /// Whether the curves cross where the first ends, and where it starts, but only there.
    pub(crate) corners: [bool; 2],
}

impl Sheet {
    /// Whether both curves are lines that are parallel at every orientation, or opposite.
    pub(crate) fn is_parallel(&self, other: &Self) -> bool {
        let lines = self.is_line() && self.locus.carrier.kind == other.locus.carrier.kind;
        lines
            && self
                .locus
                .carrier
                .normal
                .cross(other.locus.carrier.normal)
                .abs()
                <= SAME_CARRIER
    }

    /// The ends that two sheets share.
    ///
    /// Where normals agree (at every shared end except that of two vertices) the curves are tangent there and have no other crossing. Where
    /// two vertices touch, they cross at the shared end, which is not a crossing of interiors.
    pub(crate) fn shared_ends(&self, other: &Self, first_vertex_name: u32) -> SharedEnds {
        let mut shared = SharedEnds {
            tangent: self.always_tangent(other)
                || (self.fixed == other.fixed && self.moving == other.moving),
            corners: self.shared_corners(other, first_vertex_name),
        };
        let smooth = |name: u32, other: u32| name == other && name < first_vertex_name;
        shared.tangent |= smooth(self.end.name, other.start.name);
        shared.tangent |= smooth(self.start.name, other.end.name);
        shared
    }

    /// Whether this sheet's end, and its start, is an end of two vertices that it shares with another sheet.
    pub(crate) fn shared_corners(&self, other: &Self, first_vertex_name: u32) -> [bool; 2] {
        let corner = |name: u32, other: u32| name == other && name >= first_vertex_name;
        [
            corner(self.end.name, other.start.name),
            corner(self.start.name, other.end.name),
        ]
    }

    /// The centre of its circle, if that of another sheet is so near to it that places where the circles cross would be lost in the
    /// rounding of the two centres; and the distance.
    ///
    /// Two arcs of a part as small as 1e-9 sizes touch an arc of the other part on circles as near as that. Their crossing follows from the
    /// direction from one centre to the other, which is computed from the difference of two spirals, without cancellation.
    pub(crate) fn close_to(&self, other: &Self) -> Option<(Spiral, f64)> {
        if !(self.is_circle() && other.is_circle()) {
            return None;
        }
        let (c, d) = (self.locus.carrier.through, other.locus.carrier.through);
        let apart = (d.u - c.u).length() + (d.w - c.w).length();
        (0.0 < apart && apart < CLOSE_CENTERS).then_some((c, apart))
    }
}

//! Layers of a part: outlines at different heights.
//!
//! A part is a stack of prisms, each over the even-odd interior of its own loops. Two parts meet where their layers overlap in height by more
//! than nothing; a part drawn as one outline without heights is at every height.

use std::ops::Range;

use super::tolerance::RESOLUTION;

/// The lowest and the highest place of a layer, in the model's unit of length; `None` at every height.
pub type Heights = Option<[f64; 2]>;

/// An outline of a part, and the heights at which it is material.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    pub(super) z: Heights,
    pub(super) loops: Range<usize>,
}

impl Layer {
    /// The heights at which the layer is.
    pub const fn z(&self) -> Heights {
        self.z
    }

    /// The loops, by their numbers in the part.
    pub fn loops(&self) -> Range<usize> {
        self.loops.clone()
    }

    /// Whether the layer is at a height: from its lowest place on, and below its highest.
    pub fn is_at(&self, height: f64) -> bool {
        self.z.is_none_or(|[lo, hi]| lo <= height && height < hi)
    }

    /// Whether the heights of two layers overlap by more than nothing: faces that only touch do not meet.
    pub fn meets(&self, other: &Self) -> bool {
        meet(self.z, other.z)
    }
}

/// Whether two intervals of heights overlap by more than [`RESOLUTION`] of the largest: they are sums of thicknesses, which are rounded.
pub(super) fn meet(a: Heights, b: Heights) -> bool {
    match (a, b) {
        (Some([a, b]), Some([c, d])) => {
            let largest = [a, b, c, d].map(f64::abs).into_iter().fold(0.0, f64::max);
            b.min(d) - a.max(c) > RESOLUTION * largest
        }
        _ => true,
    }
}

//! Layers of a part: outlines at different heights.
//!
//! A part is a stack of prisms, each over the even-odd interior of its own loops. Two parts meet where their layers overlap in height by more
//! than nothing; a part drawn as one outline without heights is at every height.

use std::ops::Range;

/// An outline of a part, and the heights at which it is material.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    pub(super) z: Option<[f64; 2]>,
    pub(super) loops: Range<usize>,
}

impl Layer {
    /// The lowest and the highest place, in the model's unit of length; `None` if the layer is at every height.
    pub const fn z(&self) -> Option<[f64; 2]> {
        self.z
    }

    /// The loops, by their numbers in the part.
    pub fn loops(&self) -> Range<usize> {
        self.loops.clone()
    }

    /// Whether the heights of two layers overlap by more than nothing: faces that only touch do not meet.
    pub fn meets(&self, other: &Self) -> bool {
        meet(self.z, other.z)
    }
}

/// Whether two intervals of heights overlap by more than nothing.
pub(super) fn meet(a: Option<[f64; 2]>, b: Option<[f64; 2]>) -> bool {
    match (a, b) {
        (Some([a, b]), Some([c, d])) => a.max(c) < b.min(d),
        _ => true,
    }
}

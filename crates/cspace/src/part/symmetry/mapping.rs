//! Correspondence that a symmetry must have: elements to be mapped, tolerance, and images of loops.

/// Largest deviation of a part from its own image under a rotation, as a fraction of its size, at which it is symmetric: 2⁻³⁰ ≈ 9·10⁻¹⁰.
///
/// Drawings are written with rounded coordinates. Rounding to ten digits is within this, and intended differences are not. The contact
/// space computed with symmetry is that of the nearest symmetric part, and reports the deviation from the drawing.
pub const SYMMETRIC: f64 = 1.0 / (1_u64 << 30) as f64;

/// Elements of a part that a symmetry must map to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Corresponding {
    /// The outline: whole circles have no vertices.
    Outlines,
    /// All vertices.
    Vertices,
}

/// Image of a loop under a rotation: vertex t, in order of travel, is mapped to vertex t + shift of the target, which has so many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LoopImage {
    pub(crate) target: u32,
    pub(crate) shift: u32,
    pub(crate) count: u32,
}

impl LoopImage {
    pub(crate) const fn new(target: u32, shift: u32, count: u32) -> Self {
        Self {
            target,
            shift,
            count,
        }
    }

    /// The loop and vertex to which a vertex is mapped.
    pub(crate) fn of(&self, vertex: usize) -> (usize, usize) {
        let shifted = vertex + self.shift as usize;
        (self.target as usize, shifted % self.count as usize)
    }
}

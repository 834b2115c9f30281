//! Correspondence that a symmetry must have: elements to be mapped, tolerance, and images of loops.

/// How far a part may be off its own image under a rotation, as a fraction of its size: 2⁻³⁰ ≈ 9·10⁻¹⁰.
///
/// Drawings are written with rounded coordinates. Ten digits are within this, and what a designer means as a
/// difference is not. The contact space computed with symmetry is that of the nearest symmetric part, and tells how far
/// that is from the drawing.
pub const SYMMETRIC: f64 = 1.0 / (1_u64 << 30) as f64;

/// Elements of a part that a symmetry must map to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Corresponding {
    /// The outline: whole circles have no vertices.
    Outlines,
    /// All vertices.
    Vertices,
}

/// Where a rotation takes a loop: vertex t, in order of travel, to vertex t + shift of the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LoopImage {
    pub(crate) target: u32,
    pub(crate) shift: u32,
}

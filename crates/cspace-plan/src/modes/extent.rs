//! Range of a coordinate, and its resolution.

/// The values of the coordinate of a part: radians, or the model's unit of length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extent {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Whether the ends are the same place, a full turn apart.
    pub(crate) circle: bool,
    /// Openings smaller than this are closed.
    pub(crate) opening: f64,
    /// Critical values nearer to each other than this are one.
    pub(crate) narrowest: f64,
}

impl Extent {
    /// Copy with the larger of both extents' tolerances.
    pub(crate) fn coarser(self, other: &Self) -> Self {
        Self {
            opening: self.opening.max(other.opening),
            narrowest: self.narrowest.max(other.narrowest),
            ..self
        }
    }
}

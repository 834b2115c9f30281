//! The tolerances of offsets, as shares of the part's size and twice the distance together.

/// Places nearer than this are one. It is some times the resolution of parts, and a hundred thousand times the rounding of a
/// crossing at a wide angle.
pub(super) const NEAR: f64 = 1e-10;

/// A place of the offset outline that is nearer to the part than the distance by less than this has that distance: the rounding
/// of distances.
pub(super) const SLACK: f64 = 1e-12;

/// Edges whose directions differ by less at a vertex, in radians, have no corner there: offset by all of the size, the ends that
/// the corner would have between them are one place.
pub(super) const SMOOTH: f64 = 1e-10;

/// Largest distance (a length): that of a part's coordinates, whose squares are finite.
pub(super) const LARGEST: f64 = 1e150;

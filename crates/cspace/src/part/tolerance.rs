//! Limits within which loops make a part, each with its unit and its reason.

/// The finest detail of a part, as a fraction of its size (the diagonal of its bounding box).
///
/// Places nearer than this are one place, and edges that leave a vertex within this angle (radians) have one direction: two lines as long
/// as the part that open by this angle are nowhere farther apart than this. 2⁻³⁶ ≈ 1.5·10⁻¹¹ leaves 16 bits between the finest detail and
/// the rounding of an f64, for the few multiplications that decide on which side a point lies.
pub const RESOLUTION: f64 = 1.0 / (1_u64 << 36) as f64;

/// The largest bulge that counts as 0, a line.
///
/// An arc deviates from its chord by bulge · chord / 2, so one this flat stays within [`RESOLUTION`] / 2 of the chord, for any length.
pub const FLAT_BULGE: f64 = RESOLUTION;

/// The largest |bulge| of an arc.
///
/// The rest of its circle is an arc of bulge 1 / 2³⁶, which is flat (see [`FLAT_BULGE`]): the arc cannot be distinguished from a whole
/// circle, and its ends not from each other.
pub const FULL_BULGE: f64 = 1.0 / FLAT_BULGE;

/// The largest |coordinate|, of vertices and of arcs, in the model's unit. Squares stay finite.
pub const MAX_COORDINATE: f64 = 1e150;

/// The smallest size of a part, in the model's unit. Squares of its details stay normal numbers.
pub const MIN_SIZE: f64 = 1e-120;

/// Largest distance from the origin at which a part may be drawn, in sizes of the part.
///
/// At 2³⁰ ≈ 10⁹ sizes coordinates are rounded to 2⁻²³ of the size; beyond, a drawing has lost detail that is usually intended.
pub const MAX_OFFSET: f64 = (1_u64 << 30) as f64;

/// The largest number of vertices of a part, all loops together. It bounds the time and memory for checking a part: some seconds, under a
/// gigabyte.
pub const MAX_VERTICES: usize = 1_000_000;

/// The largest number of layers of a part. Layers are moved apart by parts of the growth, and vertices by a quarter of that, which must stay
/// above the rounding of f64.
pub const MAX_LAYERS: usize = 16;

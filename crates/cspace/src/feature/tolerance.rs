//! The tolerances that decide what the kernel resolves, each with its unit and reason.
//!
//! Bounds on rounding errors, and limits of iterations, stand where they are used, with a name of their own.
//!
//! Lengths are in units of the pair's frame, in which both parts fit the unit disc.

// Growth: how far drawn parts are changed.

/// By how much the fixed part is grown before anything is computed (length, about 9.1e-13).
///
/// The regularised meaning of a contact in numbers: where parts leave each other less than this, they leave nothing.
/// It turns every coincidence that would last over a range of orientations (zero clearance, equal radii, a corner
/// that exactly fills another) into a definite overlap some thousand times larger than the rounding of f64.
pub(crate) const GROWTH: f64 = 1.0 / (1u64 << 40) as f64;

/// By how much the moving part is grown (length, about 2.1e-13).
///
/// Where lengths of the fixed part alone equal one of the moving part, as a step as high as the radius of a disc that rolls
/// over it, growth of the fixed part changes nothing: both ends of the length are moved. Growth of the other part does. It is
/// the lesser growth by far, and no simple part of the other.
pub(crate) const MOVING_GROWTH: f64 = 0.236_067_977_499_789_7 * GROWTH;

/// By how much the moving part is made smaller, in place of growth, where exact fits are sought (length, about 9.3e-10).
///
/// Parts that fit exactly then have a play of twice as much, four times [`LEAST_CLEARANCE`], and so have parts that overlap by a little
/// less than that. A pair of discs inside the parts is smaller by more, so that it still overlaps for certain.
pub(crate) const ROOM: f64 = 1.0 / (1u64 << 30) as f64;

/// By how much vertices of the moving part are moved where it is smaller by [`ROOM`] (length, about 5.8e-11): what fits exactly in
/// several places has the same play in each, and its contacts would be tangent to each other.
pub(crate) const MOVED_IN_ROOM: f64 = ROOM / 16.0;

/// By how much more a loop is grown that is one level above another (length, about 2.3e-13): twice [`SAME_CARRIER`], so that
/// contacts of both are told apart.
///
/// Levels are where the radii of two loops of each part have equal sums, which growing them evenly does not change. All in
/// all that is less than half of [`CONTACT`]: at most 1.75 [`GROWTH`] of the fixed part and 2.24 of the moving one.
pub(crate) const LEVEL: f64 = GROWTH / 4.0;

/// The longest mitre of a grown convex corner, in units of [`GROWTH`]; sharper corners are cut off there.
///
/// It is how far a contact of the corner may be off its place: 9.3e-10. The resolution of a pair says so.
pub(crate) const MITRE: f64 = 1024.0;

/// How far edges that meet in a concave corner are carried on into the material, in units of [`GROWTH`].
///
/// Nothing can touch a concave corner, so contact curves end there in blocked space. Carrying them on makes them
/// cross each other properly instead of sharing an end point.
pub(crate) const OVERSHOOT: f64 = 64.0;

/// The separation that carrying on must give at nearly smooth concave corners (length, about 1.4e-14).
pub(crate) const OVERSHOOT_SEPARATION: f64 = 1.0 / (1u64 << 46) as f64;

/// By how much vertices of the fixed part are moved to make it generic (length, about 1.1e-13): less than it is grown by, so that
/// what is grown still covers what is drawn.
pub(crate) const PERTURBATION: f64 = GROWTH / 8.0;

/// Length by which vertices of the moving part are moved to make it generic (about 5.4e-14).
pub(crate) const MOVING_PERTURBATION: f64 = MOVING_GROWTH / 4.0;

/// How much cheaper it is to slide a vertex by a length than to move it across by as much.
///
/// A kink δ where an arc of radius r meets an edge of length l is mended by a slide of r δ where l is more than r / SLIDE,
/// and by turning the edge, which moves its end by l δ, where it is less: that is at most r δ / SLIDE ≈ 1e-13, and the slide
/// at most SLIDE δ ≈ 1/500 of the edge.
pub(crate) const SLIDE: f64 = (1u32 << 17) as f64;

/// The part of a short edge by which its ends may be moved as easily as those of a long one. They are never moved by more than
/// twice as much.
pub(crate) const LARGEST_PART: f64 = 1.0 / 64.0;

/// The part of a short edge by which a wish moves its ends, at most.
pub(crate) const WISHED_PART: f64 = 1.0 / (1u32 << 16) as f64;

/// The part of an arc's sagitta by which a wish changes it, at most, and beyond which a change is not as easy.
pub(crate) const SAGITTA_PART: f64 = 1.0 / 1024.0;

/// Moves across of at most so many times the longest wish are wished for.
pub(crate) const MOST_WISHES: f64 = 4.0;

// Features: what is smooth, straight, large or one.

/// Two edges, one of them an arc, that meet at an angle below this are smoothly joined (radians, about 1.5e-8).
///
/// The error made on the boundary is of second order: radius × SMOOTH² / 2, below the rounding of f64.
pub(crate) const SMOOTH: f64 = 1.0 / (1u64 << 26) as f64;

/// An arc that turns by less than this is taken for its chord, and two lines that meet at less than twice this for one
/// (radians, about 2.3e-10).
///
/// It is within 2⁻³⁵ ≈ 2.9e-11 of the length of the chord. The orientations at which it touches a line are as many; so there are
/// some [`NARROWEST_BAND`] of them at least.
pub(crate) const STRAIGHT: f64 = 1.0 / (1u64 << 32) as f64;

/// Where two edges are joined smoothly beside their vertex, an end is moved by no larger part of its edge.
pub(crate) const MOVED_PART: f64 = 1.0 / 1024.0;

/// Carriers nearer to each other than this at every orientation are one (length and sine of an angle, 1.1e-13).
///
/// Tips of a gear computed with sines and cosines differ in the last digits; a tenth of [`GROWTH`] tells them from
/// carriers that differ by growth.
pub(crate) const SAME_CARRIER: f64 = GROWTH / 8.0;

/// Loops are of one length if their lengths differ by less (length).
pub(crate) const ONE_LENGTH: f64 = 1e-9;

/// Circles of a larger radius are reckoned from a point near them instead of from their centres (length).
///
/// A place on a circle about its centre is as exact as the radius times the rounding of f64: up to here that is a thirtieth
/// of [`GROWTH`].
pub(crate) const LARGEST_CIRCLE: f64 = 128.0;

/// The place of an arc nearest to a point is not found about its centre if its bulge tan(sweep / 4) is less: the centre is far
/// away.
pub(crate) const FLAT_BULGE: f64 = 1.0 / 512.0;

// Contacts.

/// Positions nearer than this to a contact curve are in contact (length, about 7.3e-12): several times what the parts are
/// grown by, unless they have sharp corners.
pub(crate) const CONTACT: f64 = 8.0 * GROWTH;

/// Circles on which a contact curve could lie and that are smaller than this are no contact (length).
///
/// A pin in a socket with less play than this is held to be an exact fit.
pub(crate) const SMALLEST_CIRCLE: f64 = 8.0 * GROWTH;

/// Doubles do not tell places on circles of a smaller radius (length).
pub(crate) const SMALL_CIRCLE: f64 = 1e-6;

/// Centres of circles nearer than this are close (length): farther ones are known to 1e-10 of their distance.
pub(crate) const CLOSE_CENTERS: f64 = 1.0 / (1u64 << 20) as f64;

/// The largest distance of two positions in contact (length): each part fits the unit disc.
pub(crate) const LONGEST: f64 = 4.0;

/// More than the height of the arc of a large circle over its chord (length).
///
/// One of the arcs that touch is large, so that it and what touches it turn by no more than [`LONGEST`] / [`LARGEST_CIRCLE`].
pub(crate) const WIDEST_SAGITTA: f64 = 0.125 * LONGEST * LONGEST / LARGEST_CIRCLE;

/// Flat arcs are followed up to this angle about their centres (radians): what is near the parts is far below.
pub(crate) const WIDEST_ARC: f64 = 0.5;

/// Whether curves are tangent at every orientation is told from orientations this far from each other (radians): flat arcs can
/// be followed as far.
pub(crate) const TANGENCY_STEP: f64 = 0.1;

/// The full turn is cut at an orientation at least this far from any at which two normals oppose each other (radians), unless
/// these are too dense.
pub(crate) const CLEAR_CUT: f64 = 1e-7;

/// How far in the material a point is that is in the material, whatever the parts are grown by (length).
pub(crate) const WITHIN: f64 = 4.0 * GROWTH;

// Contact spaces.

/// Critical orientations nearer to each other than this are one (radians, about 1.2e-10): bands are at least this wide.
///
/// Growth and the perturbation of vertices open pockets that the drawing does not have, and close others; they last about
/// 1e-12 rad, divided by how fast the contacts part. Bands a hundred times wider are the drawing's.
pub(crate) const NARROWEST_BAND: f64 = 1.0 / (1u64 << 33) as f64;

/// A play by which parts fit into each other is seen if it is larger than this (length, about 4.7e-10).
///
/// A part of the frame's size with a play c can turn by about c, one with long teeth by a half or a third of it: four times
/// [`NARROWEST_BAND`].
pub(crate) const LEAST_CLEARANCE: f64 = 4.0 * NARROWEST_BAND;

/// Vertical neighbours must share at least this length of a patch to be linked (length).
pub(crate) const SHORTEST_OVERLAP: f64 = 1e-11;

// Slices.

/// Ends of a slice's curves that nothing else joins are one place within this (length).
///
/// Curves that touch cross at a place known to the square root of the rounding, and beside a tangency a critical orientation
/// is known to 1e-6 rad: curves of the band before may be seen in the band after.
pub(crate) const TORN: f64 = 1e-6;

/// A ray that passes where one curve ends and the next begins nearer than this meets them (length).
///
/// It is more than such places are off by rounding; what is free along a ray is told free only up to there.
pub(crate) const JOINT: f64 = 1e-11;

/// Curves of a slice that face each other further apart than this are in the order in which a ray meets them, as a share of the
/// way to the first.
pub(crate) const FACING: f64 = 1e-7;

/// And further than this as a share of the way to the farthest end of a curve, at least [`LEAST_CLEARANCE`] if that is a size away:
/// what is between may have closed just there, and at a critical orientation they may have passed each other by so much.
pub(crate) const FACING_FAR: f64 = 1e-9;

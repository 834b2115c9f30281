//! Tolerances of sliding.
//!
//! Lengths are of weighted coordinates: those of the pair's frame, in which both parts fit the unit disc, and radians by how far they
//! move the part. What counts as contact (the distance of contact) is a length that the space gives; shares of it and multiples have no
//! unit.

/// Motions of parts on axes may sink by this share of the distance of contact, so that one along a contact is not stopped by rounding.
pub(super) const DEPTH: f64 = 0.5;
/// Motions along a contact stop short of others by this share of the distance of contact: so a part comes out again of where two meet at
/// a small angle.
pub(super) const ABOVE: f64 = 0.5;
/// Halvings of a motion that went too far: more than a double has bits.
pub(super) const HALVINGS: usize = 60;
/// Halvings end when this share of what counts as contact is left.
pub(super) const FINEST: f64 = 0.1;
/// A motion that went too far is first taken back by so many times what counts as contact, then by ever more: mostly it is little.
pub(super) const FIRST_BACK: f64 = 2.0;
pub(super) const BACK_GROWTH: f64 = 8.0;
/// How far beside an orientation it is also asked which patches touch (radians): a critical one is known to a tenth of it.
pub(super) const BESIDE: f64 = 1e-9;
/// So far may a contact curve move over [`BESIDE`], but where curves become tangent (length per radian).
pub(super) const END_SPEED: f64 = 4.0;
/// A moving part is taken to be no smaller than this (length): an orientation of a mere point would not count at all.
pub(super) const LEAST_RADIUS: f64 = 1e-3;
/// So far a motion is first looked for (length): what presses on a surface mostly goes no farther, and little is near.
pub(super) const PROBE: f64 = 0.005;
/// At the ends of the window an orientation may be rounded by this (radians).
pub(super) const SEAM: f64 = 1.0 / (1u64 << 33) as f64;

/// Patches within so many distances of contact touch: two on either side, for the part and the patch are both known to two.
pub(super) const TOUCHES: f64 = 4.0;
/// A step along the surface is no longer than this (length): contact functions are followed by their gradients.
pub(super) const LONGEST_STEP: f64 = 0.1;
/// A motion no farther than so many distances of contact only presses on what it touches.
pub(super) const PRESSED: f64 = 8.0;
/// A goal nearer than this share of the way is reached: less is not seen, and the next motion begins there.
pub(super) const REACHED: f64 = 1e-3;
/// A step comes nearer to the goal by more than this share of the distance of contact: less is rounding, and would go on for ever.
pub(super) const NEARER: f64 = 1e-3;
/// A step that comes less far than this share of its length is none: a shorter one comes as far.
pub(super) const LEAST_STEP: f64 = 0.05;
/// Bounds of how much shorter or longer than straight a step is for a surface's curvature (ratio): it is told from two gradients only.
pub(super) const LEAST_BEND: f64 = 0.02;
pub(super) const MOST_BEND: f64 = 4.0;
/// A step follows the contacts that its end is nearer to than this share of its length: rounding of products of unit vectors.
pub(super) const FOLLOWED: f64 = 1e-9;
/// As above, for contacts that hold it. A surface that is curved comes nearer than to first order: with less room than this a step has to
/// keep to it.
pub(super) const FOLLOWED_HELD: f64 = 1e-3;
/// A step that is brought to the surface by more than so many of its lengths has not found the surface it was on.
pub(super) const FARTHEST_LANDING: f64 = 2.0;
/// So much of a step is taken if its end is blocked.
pub(super) const SHORT_OF_CORNER: f64 = 0.9;
/// A step is lifted off the surface by so many distances of contact more than the surface rises: it is not stopped by what it leaves.
pub(super) const CLEAR: f64 = 2.0;
/// So many times what the surface rises halfway: no arc is higher by half elsewhere on a step that short.
pub(super) const RISE: f64 = 1.5;
/// A lift leads off other contacts with less room than so many lifts: a way off several is longer than off one.
pub(super) const LIFT_ROOM: f64 = 8.0;
/// Between contacts that all but oppose each other there is no room: what leads off both is so many times as long as what leads off one.
pub(super) const STEEPEST: f64 = 100.0;
/// A place is on the surface when contact functions are no more than this share of the distance of contact: far below what is contact.
pub(super) const ON_SURFACE: f64 = 0.05;
/// A way may lead beyond a half-space by this share of what is wanted: rounding.
pub(super) const ROUNDING: f64 = 1e-9;
/// Square of the sine of the angle to the others below which a vector depends on them: what rounding leaves of it is no direction.
pub(super) const DEPENDENT: f64 = 1e-10;

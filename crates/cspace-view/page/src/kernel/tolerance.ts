/** Tolerances of the kernel. Lengths are in units of the pair's frame, in which both parts fit the unit disc. */

// The space, as the command computes it.

/** By so much outlines are grown when a space is computed: 2⁻⁴⁰ of the fixed part, less of the moving. */
export const GROWTH = 2 ** -40;
export const MOVING_GROWTH = 0.2360679774997897 * GROWTH;

/** Ends of curves that follow each other in a slice are within this, or the slice is doubtful. */
export const TORN = 1e-6;

/** Two curves that face each other nearer than this share of the way of a ray, or of the way to the farthest joint, may be met in the wrong order. */
export const FACING = 1e-7;
export const FACING_FAR = 1e-9;

// Features that are near each other.

/** Directions nearer to each other than this are one (radians): what is drawn flush is turned by rounding. */
export const ALIGNED = 1e-9;
/** Two edges, one of them an arc, that meet at less than this are joined smoothly (radians); two lines at less than twice STRAIGHT. */
export const SMOOTH = 2 ** -26;
export const STRAIGHT = 2 ** -32;
/** Rounding errors of points, as a share of how far the parts reach and of how far the moving one is. */
export const ROUNDED = 32 * Number.EPSILON;
export const PLACED = 8 * Number.EPSILON;
/** The nearest features are looked for within this share of the parts' size first, and then within twice as much again and again. */
export const NEAREST = 2 ** -12;

// Motions. What counts as contact (the distance of contact) is a length that the scene gives; shares of it and multiples have no unit.

/** Motions may sink by this share of the distance of contact, so that one along a contact is not stopped by rounding. */
export const DEPTH = 0.5;
/** Motions along a contact stop short of others by this share of it: so a part comes out again of where two meet at a small angle. */
export const ABOVE = 0.5;
/** A function this near to the depth allowed is at it (share of the distance of contact): little of that depth. */
export const AT_DEPTH = 0.1;
/** A contact function may vanish along a motion if it comes to so many distances of contact: one is contact, and one is for rounding. */
export const WITHIN_REACH = 2;
/** Halvings of a motion that went too far: more than a double has bits. */
export const HALVINGS = 60;
/** Halvings end when this share of what counts as contact is left. */
export const FINEST = 0.1;
/** A motion that went too far is first taken back by so many times what counts as contact, then by ever more: mostly it is little. */
export const FIRST_BACK = 2;
export const BACK_GROWTH = 8;

/** What is as near as this to a curve, in distances of contact, is on it: twice, for curves meet where both are known to one. */
export const ON_CURVE = 2;
/** What passes the end of a curve no farther than this, in distances of contact, may have passed it by rounding. */
export const BEYOND_END = 256;
/** Ends of contact curves move by no more than this per radian but where curves become tangent (length of the pair's frame). */
export const END_SPEED = 4;
/** A patch that a motion is beside is not come to for this share of the time that the way to it takes: curves bend and ends move. */
export const AWAY = 0.5;
/** A patch is looked for so far before its first and beyond its last orientation (radians): that is how well critical ones are known. */
export const SEAM = 2 ** -33;
/** How far beside an orientation it is also asked which patches touch (radians): a critical one is known to a tenth of it. */
export const BESIDE = 1e-9;
/** A moving part is taken to be no smaller than this (length of the pair's frame): an orientation of a mere point would not count at all. */
export const LEAST_RADIUS = 1e-3;
/** A distance to an arc is not looked at when its circle is farther than the limit by these shares of limit and radius: rounding. */
export const LIMIT_ROUNDING = 1e-9;
export const RADIUS_ROUNDING = 1e-12;

// Sliding. Lengths are of weighted coordinates: those of the pair's frame, and radians by how far they move the part.

/** Patches within so many distances of contact touch: two on either side, for the part and the patch are both known to two. */
export const TOUCHES = 4;
/** A step along the surface is no longer than this (length): contact functions are followed by their gradients. */
export const LONGEST_STEP = 0.1;
/** A motion no farther than so many distances of contact only presses on what it touches. */
export const PRESSED = 8;
/** A goal nearer than this share of the way is reached: less is not seen, and the next motion begins there. */
export const REACHED = 1e-3;
/** A step comes nearer to the goal by more than this share of the distance of contact: less is rounding, and would go on for ever. */
export const NEARER = 1e-3;
/** A step that comes less far than this share of its length is none: a shorter one comes as far. */
export const LEAST_STEP = 0.05;
/** Bounds of how much shorter or longer than straight a step is for a surface's curvature (ratio): it is told from two gradients only. */
export const LEAST_BEND = 0.02;
export const MOST_BEND = 4;
/** A step follows the contacts that its end is nearer to than this share of its length: rounding of products of unit vectors. */
export const FOLLOWED = 1e-9;
/**
 * The same for contacts that hold it. A surface that is curved comes nearer than to first order: with less room than this a step has to keep
 * to it.
 */
export const FOLLOWED_HELD = 1e-3;
/** A step that is brought to the surface by more than so many of its lengths has not found the surface it was on. */
export const FARTHEST_LANDING = 2;
/** So much of a step is taken if its end is blocked. */
export const SHORT_OF_CORNER = 0.9;
/** A step is lifted off the surface by so many distances of contact more than the surface rises: it is not stopped by what it leaves. */
export const CLEAR = 2;
/** So many times what the surface rises halfway: no arc is higher by half elsewhere on a step that short. */
export const RISE = 1.5;
/** A lift leads off other contacts with less room than so many lifts: a way off several is longer than off one. */
export const LIFT_ROOM = 8;
/** Between contacts that all but oppose each other there is no room: what leads off both is so many times as long as what leads off one. */
export const STEEPEST = 100;
/** A place is on the surface when contact functions are no more than this share of the distance of contact: far below what is contact. */
export const ON_SURFACE = 0.05;
/** A way may lead beyond a half-space by this share of what is wanted: rounding. */
export const ROUNDING = 1e-9;
/** Square of the sine of the angle to the others below which a vector depends on them: what rounding leaves of it is no direction. */
export const DEPENDENT = 1e-10;

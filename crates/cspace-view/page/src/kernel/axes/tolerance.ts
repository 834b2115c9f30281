/** Tolerances of pairs on fixed axes. Lengths are in units of the pair's frame, in which both parts fit the unit disc. */

/** Lengths, and sines of angles, below this do not matter. */
export const INDEPENDENT = 2 ** -43;

/** How far a contact within the resolution may lie outside a cell's box: rounding of a root, and of crossings (radians or length). */
export const NEAR = 1e-9;

/**
 * A configuration farther than this from a curve whose function vanishes there, but for the resolution, is looked at itself (radians or
 * length): the square root of the rounding, which a place beside a tangency may be off.
 */
export const ASTRAY = 1e-7;

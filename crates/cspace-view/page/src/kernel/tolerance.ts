/** Tolerances of the kernel, those of the command. Lengths are in units of the pair's frame, in which both parts fit the unit disc. */

/** By so much outlines are grown when a space is computed: 2⁻⁴⁰ of the fixed part, less of the moving. */
export const GROWTH = 2 ** -40;
export const MOVING_GROWTH = 0.2360679774997897 * GROWTH;

/** Ends of curves that follow each other in a slice are within this, or the slice is doubtful. */
export const TORN = 1e-6;

/** Two curves that face each other nearer than this share of the way of a ray, or of the way to the farthest, may be met in the wrong order. */
export const FACING = 1e-7;
export const FACING_FAR = 1e-9;

/**
 * The first contact along a motion, by the contact functions themselves.
 *
 * Along a motion the function of a pair of features is f(t), with its slope and a bound of its curvature known in closed form. So a step is
 * known over which f cannot vanish, however short-lived a contact is; steps shrink towards a root as Newton's do. At a root it is asked
 * whether the patch is there.
 */

import { AT_DEPTH } from "./tolerance.js";

/** A contact function along a motion: f and f′ at t, and bounds of −f″, f″ and |f′| from there to `until`. */
export interface Sample {
  value: number;
  slope: number;
  sinking: number;
  rising: number;
  speed: number;
}

export interface Track {
  /** f from t on; bounds hold up to `until`. */
  at(t: number, until: number): Sample;
  /** Whether the patch is at the place that the motion has at t, to within what counts as contact. */
  isOn(t: number): boolean;
  /** How long the patch is not come to for certain, if f vanishes and it is not there; 0 if that is not known. */
  away(t: number): number;
}

/** More steps than any motion takes; where so many do not do, it ends there, on the safe side. */
const MOST_STEPS = 2000;

/**
 * The first time in [lo, hi] at which f sinks to −depth with the patch there; null if it does not. `depth` and the nearness at which that is
 * taken for reached are shares of `contact`, within which configurations are in contact whichever side they are on.
 */
export function firstTime(track: Track, lo: number, hi: number, contact: number, depth: number): number | null {
  const near = AT_DEPTH * contact;
  let t = lo;
  for (let k = 0; k < MOST_STEPS; k++) {
    const { value, slope, sinking, rising, speed } = track.at(t, hi);
    const f = value + depth;
    if (!Number.isFinite(f)) return null;
    const within = Math.abs(f) <= near || (f < 0 && value >= -contact);
    if (within && slope < 0 && track.isOn(t)) return t;
    const [rate, bend] = f < 0 ? [-slope, rising] : [slope, sinking];
    const step0 = Math.max(untilRoot(Math.abs(f), rate, bend), Math.abs(f) / speed);
    // Past a root that is no contact: as far as what is near reaches, or as the patch is known to be away.
    const step = within ? Math.max(step0, near / speed, track.away(t)) : step0;
    if (!(t + step < hi)) return null;
    t = t + step > t ? t + step : t + Math.abs(t) * Number.EPSILON + Number.MIN_VALUE;
  }
  return t;
}

/** Where size + rate h − bend h²/2 vanishes first: up to there a function is positive whose second derivative is no less than −bend. */
function untilRoot(size: number, rate: number, bend: number): number {
  if (bend === Infinity) return 0;
  const root = Math.sqrt(rate * rate + 2 * bend * size);
  // Of two forms that are equal the one in which nothing cancels.
  if (rate < 0) return (2 * size) / (root - rate);
  return bend > 0 ? (rate + root) / bend : Infinity;
}

/** Which ways lead along some contacts nearest to where a part is wanted. */

import { ROUNDING } from "./tolerance.js";
import { dot, size, weighted, weightsOf, type Vec } from "./vector.js";

/** Displacements d that a contact leaves open, to first order: normal · d ≥ −room. */
export interface HalfSpace {
  /** Of unit length. */
  normal: Vec;
  room: number;
}

export interface Way {
  by: number[];
  /** Indices of the half-spaces in whose boundaries it ends. */
  held: number[];
  /** Whether all of the half-spaces allow it. */
  allowed: boolean;
}

/** No more contacts hold a part at once than it has degrees of freedom; three in the plane. */
const MOST_HELD = 3;

/**
 * The wanted displacement projected to the boundaries of up to three half-spaces that it is pressed against, the nearest to it first.
 *
 * The one that all half-spaces allow comes before any other: it is the projection to all that they have in common. The others are right where
 * an obstacle has an edge: there free space is what either of two contacts allows, and a part goes past it along one of them.
 */
export function waysAlong(wanted: Vec, spaces: readonly HalfSpace[]): Way[] {
  const slack = ROUNDING * Math.max(size(wanted), ...spaces.map((s) => -s.room));
  const found: (Way & { off: number })[] = [];
  const consider = (held: number[]): void => {
    const rows = held.map((i) => spaces[i]!.normal);
    const weights = weightsOf(rows, held.map((i, k) => -spaces[i]!.room - dot(rows[k]!, wanted)));
    // A contact does not pull.
    if (!weights || weights.some((w) => w < -slack)) return;
    const by = weighted(rows, weights, wanted);
    const allowed = spaces.every((s) => dot(s.normal, by) >= -s.room - slack);
    found.push({ by, held, allowed, off: dot(by, by) - 2 * dot(by, wanted) });
  };
  const most = Math.min(MOST_HELD, wanted.length);
  const extend = (held: number[], next: number): void => {
    consider(held);
    if (held.length === most) return;
    for (let i = next; i < spaces.length; i++) extend([...held, i], i + 1);
  };
  extend([], 0);
  return found.sort((a, b) => Number(b.allowed) - Number(a.allowed) || a.off - b.off);
}

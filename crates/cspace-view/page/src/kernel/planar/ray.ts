/** What a ray from a position meets first in a slice. */

import { curvePoint, hitCurve } from "../curve.js";
import { cross, dot, fromAngle, sub, type Point } from "../plane.js";
import { FACING, FACING_FAR, TORN } from "../tolerance.js";
import type { Slice } from "./surface.js";

export interface Met {
  /** Index of the curve in the slice. */
  curve: number;
  /** Whether the ray comes from the curve's free side. */
  fromFree: boolean;
}

/** The first of the directions (radians), no engineer's, and the step from each to the next: the golden section of a turn. */
const FIRST = 1.23456789;
const STEP = 2.399963229728653;
const DIRECTIONS = 7;
/** A ray that passes a joint of two curves at more than this, as a share of the way to the farthest, does not slip through between them. */
const BESIDE = 2 * TORN;

export function firstMet(slice: Slice, position: Point): Met | null {
  const joints = slice.curves.map((c) => sub(curvePoint(c.curve, 0), position));
  const farthest = joints.reduce((most, v) => Math.max(most, dot(v, v)), 0);
  const [beside, closed] = [BESIDE, FACING_FAR].map((share) => share * Math.sqrt(farthest)) as [number, number];
  let widest = -Infinity;
  let answer: Met | null = null;
  for (let k = 0; k < DIRECTIONS; k++) {
    const d = fromAngle(FIRST + STEP * k);
    // The nearest curve met from its free side, and from its blocked side.
    let free = Infinity;
    let blocked = Infinity;
    let freeCurve = 0;
    let blockedCurve = 0;
    slice.curves.forEach((c, i) => {
      const hit = hitCurve(c.curve, position, d);
      if (!hit) return;
      const [t, towardsFree] = hit;
      if (towardsFree < 0) {
        if (t < free) [free, freeCurve] = [t, i];
      } else if (t < blocked) [blocked, blockedCurve] = [t, i];
    });
    const fromFree = free < blocked;
    const first = fromFree ? free : blocked;
    const met = Number.isFinite(first) ? { curve: fromFree ? freeCurve : blockedCurve, fromFree } : null;
    const apart = met ? Math.abs(free - blocked) : Infinity;
    // How near the way to what is met passes a joint.
    let clear = Infinity;
    for (const v of joints) {
      const along = dot(d, v);
      if (along >= -beside && along <= first + beside) clear = Math.min(clear, Math.abs(cross(d, v)));
    }
    const room = Math.min(apart, clear);
    if (room > widest) {
      widest = room;
      answer = met;
    }
    if ((!met || apart > Math.max(FACING * first, closed)) && clear > beside) break;
  }
  return answer;
}

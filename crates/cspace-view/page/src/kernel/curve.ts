/** Pieces of the boundary of free space in a slice: segments and arcs, free space on their right. */

import { footOn, hitArc, pointAlong, type Edge } from "./edge.js";
import { add, angleOf, cross, distance, dot, fromAngle, lerp, right, signum, sub, TAU, times, type Point } from "./plane.js";
import { LIMIT_ROUNDING, RADIUS_ROUNDING } from "./tolerance.js";

export type Curve =
  | { kind: "segment"; start: Point; end: Point }
  | { kind: "arc"; center: Point; radius: number; startAngle: number; sweep: number }
  | ({ kind: "flat" } & Edge);

/** Whether a direction from the centre leads to the arc. */
function isOnArc(startAngle: number, sweep: number, angle: number): boolean {
  const turned = (angle - startAngle) * signum(sweep);
  return turned - TAU * Math.floor(turned / TAU) <= Math.abs(sweep);
}

/** The point at a fraction of the way, 0 the start and 1 the end. */
export function curvePoint(c: Curve, s: number): Point {
  switch (c.kind) {
    case "segment":
      return lerp(c.start, c.end, s);
    case "arc":
      return add(c.center, times(fromAngle(c.startAngle + s * c.sweep), c.radius));
    case "flat":
      return pointAlong(c, s);
  }
}

function nearer(p: Point, start: Point, end: Point): Point {
  return distance(p, start) <= distance(p, end) ? start : end;
}

/** The point of the curve nearest to another. */
export function nearestOn(c: Curve, p: Point): Point {
  switch (c.kind) {
    case "segment": {
      const v = sub(c.end, c.start);
      const s = dot(sub(p, c.start), v) / dot(v, v);
      // NaN for a segment of no length.
      return s > 0 ? lerp(c.start, c.end, Math.min(s, 1)) : c.start;
    }
    case "arc": {
      const angle = angleOf(sub(p, c.center));
      if (isOnArc(c.startAngle, c.sweep, angle)) return add(c.center, times(fromAngle(angle), c.radius));
      return nearer(p, curvePoint(c, 0), curvePoint(c, 1));
    }
    case "flat":
      return footOn(c, p) ?? nearer(p, c.start, c.end);
  }
}

/** The first distance along a ray at which the curve is met, and the product of its direction with the normal towards free space. */
export function hitCurve(c: Curve, p: Point, d: Point): [number, number] | null {
  switch (c.kind) {
    case "segment": {
      const v = sub(c.end, c.start);
      const slope = cross(d, v);
      const w = sub(c.start, p);
      const t = cross(w, v) / slope;
      const s = cross(w, d) / slope;
      return t > 0 && s >= 0 && s <= 1 ? [t, dot(d, right(v))] : null;
    }
    case "arc": {
      const v = sub(c.center, p);
      const along = dot(v, d);
      const across = cross(v, d);
      const square = (c.radius - across) * (c.radius + across);
      if (square < 0) return null;
      const half = Math.sqrt(square);
      for (const t of [along - half, along + half]) {
        const q = sub(add(p, times(d, t)), c.center);
        if (t > 0 && isOnArc(c.startAngle, c.sweep, angleOf(q))) return [t, dot(d, q) * signum(c.sweep)];
      }
      return null;
    }
    case "flat":
      return hitArc(c, p, d);
  }
}

/** The unit normal towards free space at a point of the curve; zero of what is but a point. */
export function freeNormalAt(c: Curve, p: Point): Point {
  if (c.kind === "arc") {
    const v = sub(p, c.center);
    const size = Math.hypot(v.x, v.y);
    return size > 0 ? times(v, signum(c.sweep) / size) : { x: 0, y: 0 };
  }
  const v = sub(c.end, c.start);
  const size = Math.hypot(v.x, v.y);
  if (size === 0) return { x: 0, y: 0 };
  return times(right(v), 1 / size);
}

/** How far a point is from the curve, if that is less than a limit; or else anything that is not less. */
export function distanceBelow(c: Curve, p: Point, limit: number): number {
  if (c.kind === "arc") {
    // The circle is no farther than the arc; rounding is far below the margin.
    const off = Math.abs(distance(p, c.center) - c.radius);
    if (off > limit * (1 + LIMIT_ROUNDING) + RADIUS_ROUNDING * c.radius) return off;
  }
  return distance(nearestOn(c, p), p);
}

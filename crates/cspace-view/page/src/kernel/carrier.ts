/** Carriers of contact curves at one orientation, and where two of them cross. */

import { crossingPlace, normalAt, pointOn, wayAlong, flatDistance, type Equation, type FlatArc } from "./flat-arc.js";
import { add, cross, distance, dot, left, length, signum, sub, times, type Point } from "./plane.js";

export type Carrier =
  | { kind: "line"; normal: Point; through: Point }
  | { kind: "circle"; center: Point; radius: number }
  | ({ kind: "flat" } & FlatArc);

/** How far a point is from a carrier. */
export function offCarrier(c: Carrier, p: Point): number {
  switch (c.kind) {
    case "line":
      return Math.abs(dot(c.normal, sub(p, c.through)));
    case "circle":
      return Math.abs(distance(p, c.center) - Math.abs(c.radius));
    case "flat":
      return Math.abs(flatDistance(c, p));
  }
}

function equation(c: Carrier, from: Point): Equation {
  switch (c.kind) {
    case "line":
      return { a: c.normal, k: 0, c: -dot(c.normal, sub(c.through, from)) };
    case "flat": {
      const e = sub(c.through, from);
      const k = c.curvature;
      return { a: sub(c.normal, times(e, k)), k, c: k * 0.5 * dot(e, e) - dot(c.normal, e) };
    }
    case "circle": {
      const e = sub(c.center, from);
      const s = signum(c.radius);
      return { a: times(e, -s), k: s, c: s * 0.5 * (dot(e, e) - c.radius * c.radius) };
    }
  }
}

function root(square: number): number {
  return Math.sqrt(Math.max(square, 0));
}

/**
 * Where two carriers cross, as a place on the first: the distance along a line or a flat arc (in x), the way from the centre of a circle.
 * Where they do not, the nearest place to a crossing.
 */
export function placeOn(f: Carrier, g: Carrier, which: number): Point {
  if (f.kind === "flat" || g.kind === "flat") return placeOfFlatArc(f, g, which === 1);
  if (f.kind === "line") {
    const along = left(f.normal);
    if (g.kind === "line") {
      return { x: -dot(g.normal, sub(f.through, g.through)) / dot(g.normal, along), y: 0 };
    }
    const v = sub(g.center, f.through);
    const offset = dot(f.normal, v);
    const r = Math.abs(g.radius);
    const half = root((r - offset) * (r + offset));
    return { x: dot(along, v) + (which === 1 ? half : -half), y: 0 };
  }
  if (g.kind === "line") {
    const n = g.normal;
    const offset = dot(n, sub(f.center, g.through));
    const r = Math.abs(f.radius);
    const size = root((r - offset) * (r + offset));
    const half = which === 1 ? size : -size;
    return { x: -(n.x * offset) - n.y * half, y: -(n.y * offset) + n.x * half };
  }
  const v = sub(g.center, f.center);
  const square = dot(v, v);
  const a1 = Math.abs(f.radius);
  const a2 = Math.abs(g.radius);
  const sum = a1 + a2;
  const difference = a1 - a2;
  const product = (sum * sum - square) * (square - difference * difference);
  const twice = 2 * square;
  const along = (square + sum * difference) / twice;
  const size = root(product) / twice;
  const across = which === 1 ? size : -size;
  return { x: v.x * along - v.y * across, y: v.y * along + v.x * across };
}

function placeOfFlatArc(f: Carrier, g: Carrier, enters: boolean): Point {
  if (f.kind === "circle") {
    if (g.kind !== "flat") return { x: 0, y: 0 };
    // Where f enters the blocked side of g, g leaves that of f.
    const d = wayAlong(g, crossingPlace(g, equation(f, g.through), !enters));
    return add(sub(g.through, f.center), d);
  }
  const arc: FlatArc = f.kind === "flat" ? f : { through: f.through, normal: f.normal, curvature: 0 };
  return { x: crossingPlace(arc, equation(g, arc.through), enters), y: 0 };
}

/** The point of a carrier at a place given as by {@link placeOn}. */
export function pointAtPlace(f: Carrier, v: Point): Point {
  switch (f.kind) {
    case "line":
      return { x: f.through.x - f.normal.y * v.x, y: f.through.y + f.normal.x * v.x };
    case "circle":
      return add(f.center, v);
    case "flat":
      return pointOn(f, v.x);
  }
}

/** Rounding error of a place where two carriers cross squarely (length of the pair's frame). */
const PLACE_ERROR = 1e-14;

function curvature(c: Carrier): number {
  return c.kind === "line" ? 0 : c.kind === "circle" ? 1 / c.radius : c.curvature;
}

/** The rounding error of a place. */
export function placeError(f: Carrier, g: Carrier, place: Point): number {
  let normal: Point;
  let at: Point;
  // The place may be off the circle if there is no crossing, or none that rounding leaves.
  let off = 0;
  if (f.kind === "line") {
    normal = f.normal;
    at = add(f.through, times(left(normal), place.x));
  } else if (f.kind === "flat") {
    at = pointOn(f, place.x);
    normal = normalAt(f, at);
  } else {
    const size = length(place);
    off = Math.abs(size - Math.abs(f.radius));
    normal = times(place, signum(f.radius) / size);
    at = add(f.center, place);
  }
  const other =
    g.kind === "line" ? g.normal : g.kind === "circle" ? times(sub(at, g.center), 1 / g.radius) : normalAt(g, at);
  // Seen from one side of the common tangent.
  const bend = Math.abs(curvature(f) - curvature(g) * signum(dot(normal, other)));
  const error = off + PLACE_ERROR / Math.max(Math.abs(cross(normal, other)), Math.sqrt(0.5 * PLACE_ERROR * bend));
  return Number.isNaN(error) ? Infinity : error;
}

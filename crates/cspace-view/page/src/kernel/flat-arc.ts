/**
 * Flat arcs: circles much larger than the parts, as curves through a point near these.
 *
 * A circle with the curvature κ = 1/r through a point P with the unit normal n is n·d + κ d²/2 = 0 for the way d from P. Nothing in it is
 * large, so that a place on it is as exact as P is, however far away the centre. A line is one with κ = 0.
 */

import { add, dot, left, sub, times, unit, withSign, type Point } from "./plane.js";

export interface FlatArc {
  through: Point;
  normal: Point;
  curvature: number;
}

/** a·d + k d²/2 + c = 0 for the way d from some point. */
export interface Equation {
  a: Point;
  k: number;
  c: number;
}

/** The place u on an arc at which it crosses another curve, seen from the arc's point. */
export function crossingPlace(arc: FlatArc, other: Equation, enters: boolean): number {
  const n = arc.normal;
  const kappa = arc.curvature;
  const square = (other.k - kappa * dot(other.a, n)) * 0.5 + other.c * (0.25 * kappa * kappa);
  const slope = dot(other.a, left(n));
  const root = Math.sqrt(Math.max(slope * slope - 4 * square * other.c, 0));
  const steep = enters ? -root : root;
  // Of two forms that are equal the one in which nothing cancels.
  return enters === slope < 0 ? (-2 * other.c) / (slope + steep) : (steep - slope) / (2 * square);
}

/** The way from the arc's point to a place on it. */
export function wayAlong(arc: FlatArc, u: number): Point {
  const n = arc.normal;
  const half = u * 0.5 * arc.curvature;
  const t = u / (1 + half * half);
  const fall = -(t * half);
  return { x: fall * n.x - t * n.y, y: fall * n.y + t * n.x };
}

export function pointOn(arc: FlatArc, u: number): Point {
  return add(arc.through, wayAlong(arc, u));
}

/** The place on the arc, if the point is on it. */
export function placeOf(arc: FlatArc, p: Point): number {
  const d = sub(p, arc.through);
  return dot(left(arc.normal), d) / (1 + 0.5 * arc.curvature * dot(arc.normal, d));
}

export function normalAt(arc: FlatArc, p: Point): Point {
  return unit(add(arc.normal, times(sub(p, arc.through), arc.curvature)));
}

/** How far a point is from the arc's circle, positive on the side of the normal. */
export function flatDistance(arc: FlatArc, p: Point): number {
  const d = sub(p, arc.through);
  const f = dot(arc.normal, d) + 0.5 * arc.curvature * dot(d, d);
  return (2 * f) / (1 + Math.sqrt(Math.max(1 + 2 * arc.curvature * f, 0)));
}

/** tan(sweep / 4) between two places. */
export function flatBulge(arc: FlatArc, from: number, to: number): number {
  const half = 0.5 * arc.curvature;
  const last = Math.max(to, from);
  const angle = 2 * Math.atan((half * (last - from)) / (1 + half * half * from * last));
  return Math.tan(0.25 * angle);
}

/** The two distances along a ray at which it meets the circle; NaN where it does not. */
export function flatMet(arc: FlatArc, p: Point, d: Point): [number, number] {
  const q = sub(p, arc.through);
  const n = arc.normal;
  const k = arc.curvature;
  const square = 0.5 * k;
  const slope = dot(d, n) + k * dot(q, d);
  const level = dot(n, q) + 0.5 * k * dot(q, q);
  const root = Math.sqrt(slope * slope - 4 * square * level);
  const sum = -(slope + withSign(root, slope));
  return [(2 * level) / sum, sum / (2 * square)];
}

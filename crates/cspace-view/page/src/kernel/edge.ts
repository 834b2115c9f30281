/** An edge of an outline, a line or an arc by its chord and bulge; never by the centre, so that flat arcs keep their accuracy. */

import { add, cross, distance, dot, left, length, lerp, signum, sub, TAU, times, turnBy, turned, unit, withSign, type Point, type Turn } from "./plane.js";

export interface Edge {
  start: Point;
  end: Point;
  /** tan(sweep / 4), positive counter-clockwise; 0 a line. */
  bulge: number;
}

/** Curves by their vertices, each with the bulge of the edge that leaves it, as parts are saved. */
export type DrawnLoops = readonly (readonly { x: number; y: number; bulge?: number }[])[];

export function edgesOf(loops: DrawnLoops): Edge[][] {
  return loops.map((loop) =>
    loop.map((v, i) => {
      const next = loop[(i + 1) % loop.length]!;
      return { start: { x: v.x, y: v.y }, end: { x: next.x, y: next.y }, bulge: v.bulge ?? 0 };
    }),
  );
}

export function placedEdge(e: Edge, t: Turn, by: Point): Edge {
  return { start: add(turned(t, e.start), by), end: add(turned(t, e.end), by), bulge: e.bulge };
}

export function sweepOf(e: Edge): number {
  return 4 * Math.atan(e.bulge);
}

export function startDirection(e: Edge): Point {
  const b = e.bulge;
  const q = 1 + b * b;
  const cos = ((1 - b) * (1 + b)) / q;
  const sin = (2 * b) / q;
  const d = unit(sub(e.end, e.start));
  return { x: cos * d.x + sin * d.y, y: cos * d.y - sin * d.x };
}

export function edgeLength(e: Edge): number {
  const chord = distance(e.start, e.end);
  return e.bulge === 0 ? chord : chord * (1 + e.bulge * e.bulge) * (Math.atan(e.bulge) / e.bulge);
}

export function radiusOf(e: Edge): number {
  return (distance(e.start, e.end) * (1 + e.bulge * e.bulge)) / (4 * Math.abs(e.bulge));
}

/** The point at a fraction of the way. */
export function pointAlong(e: Edge, u: number): Point {
  if (e.bulge === 0) return lerp(e.start, e.end, u);
  if (e.start.x === e.end.x && e.start.y === e.end.y) return e.start;
  const half = 0.5 * u * sweepOf(e);
  const ratio = half === 0 ? 1 : Math.sin(half) / half;
  return add(e.start, times(turned(turnBy(half), startDirection(e)), edgeLength(e) * u * ratio));
}

export function directionAlong(e: Edge, u: number): Point {
  return turned(turnBy(u * sweepOf(e)), startDirection(e));
}

/** Vanishes on the circle and is positive on its left. */
export function levelOf(e: Edge, p: Point): number {
  const b = e.bulge;
  const c = sub(e.end, e.start);
  const q = sub(p, e.start);
  return (1 - b) * (1 + b) * cross(c, q) + 2 * b * dot(q, sub(c, q));
}

/** Whether the point on the circle at a way from the start is on the edge. */
export function coversWay(e: Edge, q: Point): boolean {
  const b = Math.abs(e.bulge);
  const c = sub(e.end, e.start);
  const height = -signum(e.bulge) * cross(c, q);
  // The circle meets the chord at a wide angle: the arc is what lies on its own side.
  if (b >= 0.5 && b <= 2) return height >= 0;
  const along = dot(c, q);
  const beside = along >= 0 && along <= dot(c, c);
  if (b === 0) return beside;
  // An arc of less than half a turn lies beside its chord, on the chord's side of the centre, which is (1 − b²) / (4 b) chords from the
  // chord. A longer one is the rest of the circle.
  const center = (((1 - b) * (1 + b)) / (4 * b)) * dot(c, c);
  return b < 1 ? beside && height >= -center : !(beside && height <= -center);
}

/** The point of an arc nearest to a point, if it is not an end. */
export function footOn(e: Edge, p: Point): Point | null {
  const chord = length(sub(e.end, e.start));
  const wide = chord * (1 + e.bulge * e.bulge);
  const curvature = (4 * e.bulge) / wide;
  const gradient = sub(left(startDirection(e)), times(sub(p, e.start), curvature));
  const slope = length(gradient);
  if (slope === 0) return null;
  const offset = (2 * (levelOf(e, p) / wide)) / (1 + slope);
  const foot = add(p, times(gradient, -offset / slope));
  return coversWay(e, sub(foot, e.start)) ? foot : null;
}

/** The first distance along a ray at which an arc is met, and the product of the direction with its right normal, up to a positive factor. */
export function hitArc(e: Edge, p: Point, d: Point): [number, number] | null {
  const b = e.bulge;
  const c = sub(e.end, e.start);
  const q = sub(p, e.start);
  const flat = (1 - b) * (1 + b);
  const square = -2 * b;
  const slope = flat * cross(c, d) + 2 * b * (dot(d, c) - 2 * dot(q, d));
  const level = levelOf(e, p);
  const inside = slope * slope - 4 * square * level;
  if (inside < 0) return null;
  const sum = -(slope + withSign(Math.sqrt(inside), slope));
  const first = (2 * level) / sum;
  const second = sum / (2 * square);
  for (const t of first <= second ? [first, second] : [second, first]) {
    // The level is positive on the left, and grows by this along the ray.
    if (t > 0 && Number.isFinite(t) && coversWay(e, add(q, times(d, t)))) return [t, -(slope + 2 * square * t)];
  }
  return null;
}

/** The fraction of the way at which an arc heads in a direction; null of a line, and of an arc that does not. */
export function fractionHeading(e: Edge, heading: Point): number | null {
  const sweep = sweepOf(e);
  if (sweep === 0) return null;
  const from = startDirection(e);
  const turn = Math.atan2(cross(from, heading), dot(from, heading)) * signum(sweep);
  const u = (turn < 0 ? turn + TAU : turn) / Math.abs(sweep);
  return u <= 1 ? u : null;
}

export interface Box {
  lo: Point;
  hi: Point;
}

export function boxOf(e: Edge): Box {
  const points = [e.start, e.end];
  for (const heading of [{ x: 1, y: 0 }, { x: 0, y: 1 }, { x: -1, y: 0 }, { x: 0, y: -1 }]) {
    const u = fractionHeading(e, heading);
    if (u !== null) points.push(pointAlong(e, u));
  }
  return {
    lo: { x: Math.min(...points.map((p) => p.x)), y: Math.min(...points.map((p) => p.y)) },
    hi: { x: Math.max(...points.map((p) => p.x)), y: Math.max(...points.map((p) => p.y)) },
  };
}

/** Whether boxes are farther from each other than a distance, along an axis. */
export function areApart(a: Box, b: Box, by: number): boolean {
  return a.lo.x - b.hi.x > by || b.lo.x - a.hi.x > by || a.lo.y - b.hi.y > by || b.lo.y - a.hi.y > by;
}

export function centerOf(e: Edge): Point {
  const heading = startDirection(e);
  return add(e.start, times(left(heading), radiusOf(e) * signum(e.bulge)));
}

/** Whether a point is between an arc and its chord. */
export function isBetweenChordAndArc(e: Edge, p: Point): boolean {
  const beside = -signum(e.bulge) * cross(sub(e.end, e.start), sub(p, e.start)) > 0;
  const center = centerOf(e);
  // About the centre the test is exact enough but for a flat arc, of which the height over the chord tells.
  if (Math.abs(e.bulge) > 1 / 512) return beside && distance(p, center) < radiusOf(e);
  const foot = footOn(e, p);
  return beside && foot !== null && cross(sub(e.end, e.start), sub(p, foot)) * signum(e.bulge) > 0 && Math.abs(sweepOf(e)) < Math.PI;
}

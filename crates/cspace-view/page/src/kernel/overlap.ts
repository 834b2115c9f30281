/** Whether two placed parts overlap, from their outlines alone: boundaries that cross or all but touch, or one within the other. */

import type { PlanarConfiguration } from "./api.js";
import {
  areApart,
  boxOf,
  centerOf,
  coversWay,
  edgesOf,
  footOn,
  hitArc,
  isBetweenChordAndArc,
  placedEdge,
  pointAlong,
  radiusOf,
  type Box,
  type DrawnLoops,
  type Edge,
} from "./edge.js";
import { add, cross, distance, dot, left, length, signum, sub, TAU, times, turnBy, unit, type Point } from "./plane.js";

export interface DrawnPart {
  loops: DrawnLoops;
}

/** The distance of a point from an edge. */
function distanceTo(e: Edge, p: Point): number {
  const ends = Math.min(distance(p, e.start), distance(p, e.end));
  if (e.bulge === 0) {
    const c = sub(e.end, e.start);
    const q = sub(p, e.start);
    return coversWay(e, q) ? Math.abs(cross(c, q)) / length(c) : ends;
  }
  const foot = footOn(e, p);
  return foot ? Math.min(ends, distance(foot, p)) : ends;
}

/** Points of one edge at which it may be nearest to the inside of another. */
function candidates(e: Edge, other: Edge): Point[] {
  if (e.bulge === 0) {
    if (other.bulge === 0) return [];
    const d = unit(sub(e.end, e.start));
    const way = dot(sub(centerOf(other), e.start), d);
    return way > 0 && way < distance(e.start, e.end) ? [add(e.start, times(d, way))] : [];
  }
  const center = centerOf(e);
  const axis = other.bulge === 0 ? left(sub(other.end, other.start)) : sub(centerOf(other), center);
  const size = length(axis);
  if (size === 0) return [];
  const r = radiusOf(e) / size;
  return [times(axis, r), times(axis, -r)].map((v) => add(center, v)).filter((p) => coversWay(e, sub(p, e.start)));
}

/** Whether two edges cross. */
function cross2(a: Edge, b: Edge): boolean {
  if (a.bulge === 0 && b.bulge === 0) {
    const side = (e: Edge, p: Point) => cross(sub(e.end, e.start), sub(p, e.start));
    return side(a, b.start) * side(a, b.end) < 0 && side(b, a.start) * side(b, a.end) < 0;
  }
  if (a.bulge === 0) return lineCrossesArc(a, b);
  if (b.bulge === 0) return lineCrossesArc(b, a);
  const c = centerOf(a);
  const v = sub(centerOf(b), c);
  const [r1, r2] = [radiusOf(a), radiusOf(b)];
  const square = dot(v, v);
  const d = Math.sqrt(square);
  if (d === 0) return false;
  const product = (r1 + r2 - d) * (r1 + r2 + d) * (d - (r1 - r2)) * (d + (r1 - r2));
  if (product <= 0) return false;
  const along = (square + (r1 - r2) * (r1 + r2)) / (2 * square);
  const across = Math.sqrt(product) / (2 * square);
  return [across, -across].some((s) => {
    const p = add(c, add(times(v, along), times(left(v), s)));
    return coversWay(a, sub(p, a.start)) && coversWay(b, sub(p, b.start));
  });
}

function lineCrossesArc(line: Edge, arc: Edge): boolean {
  const way = sub(line.end, line.start);
  const size = length(way);
  const d = times(way, 1 / size);
  const hit = hitArc(arc, line.start, d);
  return hit !== null && hit[0] < size;
}

function edgeDistance(a: Edge, b: Edge): number {
  if (cross2(a, b)) return 0;
  let least = Math.min(distanceTo(a, b.start), distanceTo(a, b.end), distanceTo(b, a.start), distanceTo(b, a.end));
  for (const p of candidates(a, b)) least = Math.min(least, distanceTo(b, p));
  for (const p of candidates(b, a)) least = Math.min(least, distanceTo(a, p));
  return least;
}

/** Whether a point is within a part: inside an odd number of its loops. */
function contains(loops: Edge[][], p: Point): boolean {
  let inside = false;
  for (const loop of loops) {
    let angle = 0;
    for (const e of loop) {
      const a = sub(e.start, p);
      const b = sub(e.end, p);
      angle += Math.atan2(cross(a, b), dot(a, b));
      if (e.bulge !== 0 && isBetweenChordAndArc(e, p)) angle += TAU * signum(e.bulge);
    }
    if (Math.abs(angle) > Math.PI) inside = !inside;
  }
  return inside;
}

export class Overlap {
  private readonly fixed: Edge[][];
  private readonly moving: Edge[][];
  private readonly boxes: Box[];

  /** `near`: boundaries nearer than this count as crossing (model unit): an exact fit does not go in. */
  constructor(
    fixed: DrawnPart,
    moving: DrawnPart,
    private readonly near: number,
  ) {
    this.fixed = edgesOf(fixed.loops);
    this.moving = edgesOf(moving.loops);
    this.boxes = this.fixed.flat().map(boxOf);
  }

  at(c: PlanarConfiguration): boolean {
    const t = turnBy(c.theta);
    const by = { x: c.x, y: c.y };
    const fixed = this.fixed.flat();
    const moving = this.moving.map((loop) => loop.map((e) => placedEdge(e, t, by)));
    for (const e of moving.flat()) {
      const box = boxOf(e);
      for (let i = 0; i < fixed.length; i++) {
        if (!areApart(this.boxes[i]!, box, this.near) && edgeDistance(fixed[i]!, e) <= this.near) return true;
      }
    }
    const samples = (loops: Edge[][]) => loops.filter((l) => l.length > 0).map((l) => pointAlong(l[0]!, 0.5));
    return samples(moving).some((p) => contains(this.fixed, p)) || samples(this.fixed).some((p) => contains(moving, p));
  }
}

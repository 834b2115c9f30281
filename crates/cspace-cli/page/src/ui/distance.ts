/** The least distance of two features: points, lines and arcs, exactly from where they can be nearest to each other. */

import type { Place } from "../scene.js";
import { nearestOn } from "./edit-shape.js";
import { arcOf, type Arc, type Edge } from "./outline.js";

/** A point, or an edge. */
export type Measured = { point: Place } | { edge: Edge };

export interface Distance {
  from: Place;
  to: Place;
  length: number;
}

export function distanceOf(a: Measured, b: Measured): Distance {
  const starts = [...candidates(a, b), ...candidates(b, a)];
  return starts
    .map((p): Distance => {
      const from = nearest(a, p);
      const to = nearest(b, from);
      return { from, to, length: Math.hypot(to.x - from.x, to.y - from.y) };
    })
    .reduce((least, d) => (d.length < least.length ? d : least));
}

function nearest(to: Measured, p: Place): Place {
  return "point" in to ? to.point : nearestOn(to.edge, p).at;
}

/** Places at which `a` may be nearest to `b`: ends, feet of centres, and crossings. */
function candidates(a: Measured, b: Measured): Place[] {
  if ("point" in a) return [a.point];
  const places = [a.edge.from, a.edge.to];
  if ("point" in b) return [...places, b.point];
  places.push(nearestOn(a.edge, b.edge.from).at, nearestOn(a.edge, b.edge.to).at);
  const [arc, other] = [arcOf(a.edge), arcOf(b.edge)];
  if (arc) {
    const toward = other ? other.center : foot(b.edge, arc.center);
    places.push(...through(arc, toward));
  }
  if (arc && other) places.push(...circlesMeet(arc, other));
  else if (arc) places.push(...lineMeets(b.edge, arc));
  else if (!other) places.push(...linesMeet(a.edge, b.edge));
  return places;
}

/** Where the line through a circle's centre and a point meets the circle. */
function through({ center, radius }: Arc, p: Place): Place[] {
  const [dx, dy] = [p.x - center.x, p.y - center.y];
  const away = Math.hypot(dx, dy);
  if (away === 0) return [];
  return [1, -1].map((s) => ({ x: center.x + (s * radius * dx) / away, y: center.y + (s * radius * dy) / away }));
}

/** The foot of a perpendicular on the line of an edge. */
function foot({ from, to }: Edge, p: Place): Place {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const f = ((p.x - from.x) * dx + (p.y - from.y) * dy) / (dx * dx + dy * dy || 1);
  return { x: from.x + f * dx, y: from.y + f * dy };
}

function lineMeets(line: Edge, { center, radius }: Arc): Place[] {
  const middle = foot(line, center);
  const left = radius * radius - (middle.x - center.x) ** 2 - (middle.y - center.y) ** 2;
  const [dx, dy] = [line.to.x - line.from.x, line.to.y - line.from.y];
  const length = Math.hypot(dx, dy);
  if (left < 0 || length === 0) return [];
  return [1, -1].map((s) => ({ x: middle.x + (s * Math.sqrt(left) * dx) / length, y: middle.y + (s * Math.sqrt(left) * dy) / length }));
}

function circlesMeet(a: Arc, b: Arc): Place[] {
  const [dx, dy] = [b.center.x - a.center.x, b.center.y - a.center.y];
  const d2 = dx * dx + dy * dy;
  if (d2 === 0) return [];
  // Both lie on their radical line.
  const f = (d2 + a.radius * a.radius - b.radius * b.radius) / (2 * d2);
  const h2 = (a.radius * a.radius) / d2 - f * f;
  if (h2 < 0) return [];
  return [1, -1].map((s) => ({ x: a.center.x + f * dx - s * Math.sqrt(h2) * dy, y: a.center.y + f * dy + s * Math.sqrt(h2) * dx }));
}

function linesMeet(a: Edge, b: Edge): Place[] {
  const [ax, ay, bx, by] = [a.to.x - a.from.x, a.to.y - a.from.y, b.to.x - b.from.x, b.to.y - b.from.y];
  const turn = ax * by - ay * bx;
  if (turn === 0) return [];
  const f = ((b.from.x - a.from.x) * by - (b.from.y - a.from.y) * bx) / turn;
  return [{ x: a.from.x + f * ax, y: a.from.y + f * ay }];
}

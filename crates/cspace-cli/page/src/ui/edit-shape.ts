/**
 * What an edit does to a loop. Radii are what a designer has chosen, so that they stay when a vertex is moved: arcs go through their new ends
 * with the radius they had, and a circle is moved as a whole.
 */

import type { Place, SceneVertex } from "../scene.js";
import { arcOf, bulgeOfRadius, bulgeThrough, edgeOf, edgesOf, type Edge } from "./outline.js";

export type Loop = readonly SceneVertex[];

/** A bulge of less is a line: it is drawn so by whoever drags the middle back onto the chord. Of the edge's length. */
const STRAIGHT = 0.004;
/** Centres and radii of arcs that differ by less are the same, of the radius: drawings are written with some digits. */
const SAME_CIRCLE = 1e-6;

/** The circle that all edges lie on, if the loop is one. */
export function circleOf(loop: Loop): { center: Place; radius: number } | null {
  const arcs = edgesOf(loop).map(arcOf);
  const [first] = arcs;
  if (!first) return null;
  const same = arcs.every((a) => a && isSame(a, first) && a.sweep > 0 === first.sweep > 0);
  return same ? { center: first.center, radius: first.radius } : null;
}

function isSame(a: { center: Place; radius: number }, b: { center: Place; radius: number }): boolean {
  const off = Math.hypot(a.center.x - b.center.x, a.center.y - b.center.y) + Math.abs(a.radius - b.radius);
  return off < SAME_CIRCLE * b.radius;
}

/** The arc of a radius between an edge's ends; of the least radius that reaches where they are too far apart. */
function held(edge: Edge, radius: number): number {
  return bulgeOfRadius(edge, radius) ?? Math.sign(edge.bulge);
}

export function moveVertex(loop: Loop, index: number, to: Place): Loop {
  const was = loop[index];
  if (!was) return loop;
  if (circleOf(loop)) return loop.map((v) => ({ ...v, x: v.x + to.x - was.x, y: v.y + to.y - was.y }));
  const moved = loop.map((v, i) => (i === index ? { ...v, x: to.x, y: to.y } : v));
  const before = (index + loop.length - 1) % loop.length;
  return moved.map((v, i) => {
    const [old, now] = [edgeOf(loop, i), edgeOf(moved, i)];
    const arc = (i === index || i === before) && old ? arcOf(old) : null;
    return arc && now ? { ...v, bulge: held(now, arc.radius) } : v;
  });
}

/** The arc whose middle is nearest to a point; of a circle, that whose radius reaches to it. */
export function bend(loop: Loop, index: number, to: Place): Loop {
  const circle = circleOf(loop);
  if (circle) return withCircle(loop, circle, Math.hypot(to.x - circle.center.x, to.y - circle.center.y));
  const edge = edgeOf(loop, index);
  if (!edge) return loop;
  const bulge = bulgeThrough(edge, to);
  return withBulge(loop, index, Math.abs(bulge) < STRAIGHT ? 0 : bulge);
}

/** Null if no arc of that radius reaches from one end of the edge to the other. */
export function setRadius(loop: Loop, index: number, radius: number): Loop | null {
  const circle = circleOf(loop);
  if (circle) return radius > 0 ? withCircle(loop, circle, radius) : null;
  const edge = edgeOf(loop, index);
  const bulge = edge && bulgeOfRadius(edge, radius);
  return bulge === null ? null : withBulge(loop, index, bulge);
}

function withBulge(loop: Loop, index: number, bulge: number): Loop {
  return loop.map((v, i) => (i === index ? { ...v, bulge } : v));
}

function withCircle(loop: Loop, { center, radius }: { center: Place; radius: number }, to: number): Loop {
  if (!(to > 0)) return loop;
  const by = to / radius;
  return loop.map((v) => ({ ...v, x: center.x + by * (v.x - center.x), y: center.y + by * (v.y - center.y) }));
}

/** The place on an edge that is nearest to a point, and how much of the edge is before it. */
export function nearestOn(edge: Edge, p: Place): { at: Place; share: number } {
  const arc = arcOf(edge);
  if (!arc) {
    const [dx, dy] = [edge.to.x - edge.from.x, edge.to.y - edge.from.y];
    const share = clamp(((p.x - edge.from.x) * dx + (p.y - edge.from.y) * dy) / (dx * dx + dy * dy || 1));
    return { share, at: { x: edge.from.x + share * dx, y: edge.from.y + share * dy } };
  }
  const { center, radius, start, sweep } = arc;
  // The turn from the arc's middle to the point, in [−π, π).
  const middle = start + sweep / 2;
  const off = Math.atan2(p.y - center.y, p.x - center.x) - middle;
  const turn = off - 2 * Math.PI * Math.floor((off + Math.PI) / (2 * Math.PI));
  const share = clamp(0.5 + turn / sweep);
  const angle = start + share * sweep;
  return { share, at: { x: center.x + radius * Math.cos(angle), y: center.y + radius * Math.sin(angle) } };
}

const clamp = (f: number) => Math.min(1, Math.max(0, f));

/** Divides an edge at the place nearest to a point; both halves lie where the edge lay. Null at its ends. */
export function addVertex(loop: Loop, index: number, near: Place): Loop | null {
  const edge = edgeOf(loop, index);
  if (!edge) return null;
  const { at, share } = nearestOn(edge, near);
  if (share <= 0 || share >= 1) return null;
  const turn = Math.atan(edge.bulge);
  const halves = [Math.tan(turn * share), Math.tan(turn * (1 - share))] as const;
  return loop.flatMap((v, i) => (i === index ? [{ ...v, bulge: halves[0] }, { ...at, bulge: halves[1] }] : [v]));
}

/** Two edges become one: an arc if both were of one circle, else a line. Null if too little would be left. */
export function removeVertex(loop: Loop, index: number): Loop | null {
  const before = (index + loop.length - 1) % loop.length;
  const [a, b] = [edgeOf(loop, before), edgeOf(loop, index)];
  if (!a || !b || loop.length < 3) return null;
  const [first, second] = [arcOf(a), arcOf(b)];
  const one = first && second && isSame(first, second) && first.sweep > 0 === second.sweep > 0;
  const bulge = one ? Math.tan(Math.atan(a.bulge) + Math.atan(b.bulge)) : 0;
  const left = loop.map((v, i) => (i === before ? { ...v, bulge } : v)).filter((_, i) => i !== index);
  return left.length > 2 || left.some((v) => v.bulge !== 0) ? left : null;
}

/** Outlines of parts: edges with bulges, as arcs, paths of SVG, boxes, and by the names of features. */

import type { Place, ScenePart, SceneVertex } from "../scene.js";

export interface Edge {
  from: Place;
  to: Place;
  bulge: number;
}

export interface Arc {
  center: Place;
  radius: number;
  /** Angle of the first point, and the turn to the last, counter-clockwise positive. */
  start: number;
  sweep: number;
}

export interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

export function edgeOf(loop: readonly SceneVertex[], index: number): Edge | null {
  const from = loop[index];
  const to = loop[(index + 1) % loop.length];
  return from && to ? { from, to, bulge: from.bulge } : null;
}

export function edgesOf(loop: readonly SceneVertex[]): Edge[] {
  return loop.flatMap((_, i) => edgeOf(loop, i) ?? []);
}

/** The arc of an edge, null for a line. */
export function arcOf({ from, to, bulge }: Edge): Arc | null {
  if (bulge === 0) return null;
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  // The centre lies on the chord's bisector, (1 − b²)/(4b) chords to its left.
  const off = (1 - bulge * bulge) / (4 * bulge);
  const center = { x: (from.x + to.x) / 2 - off * dy, y: (from.y + to.y) / 2 + off * dx };
  return {
    center,
    radius: (Math.hypot(dx, dy) * (1 + bulge * bulge)) / (4 * Math.abs(bulge)),
    start: Math.atan2(from.y - center.y, from.x - center.x),
    sweep: 4 * Math.atan(bulge),
  };
}

/** The middle of an edge. */
export function middleOf({ from, to, bulge }: Edge): Place {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  return { x: (from.x + to.x) / 2 + (bulge * dy) / 2, y: (from.y + to.y) / 2 - (bulge * dx) / 2 };
}

/** The bulge with which an edge's middle is nearest to a point. */
export function bulgeThrough({ from, to }: Edge, p: Place): number {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const chord2 = dx * dx + dy * dy;
  if (chord2 === 0) return 0;
  return (2 * (dy * (p.x - (from.x + to.x) / 2) - dx * (p.y - (from.y + to.y) / 2))) / chord2;
}

/** The bulge of the same turning and the same side of the half circle that has a radius; null if the chord is too long for it. */
export function bulgeOfRadius(edge: Edge, radius: number): number | null {
  const half = Math.hypot(edge.to.x - edge.from.x, edge.to.y - edge.from.y) / 2;
  if (!(radius >= half) || half === 0) return null;
  const rest = Math.sqrt(Math.max(0, radius * radius - half * half));
  const size = Math.abs(edge.bulge) > 1 ? (radius + rest) / half : (radius - rest) / half;
  return edge.bulge < 0 ? -size : size;
}

/** The part of an SVG path that goes along an edge; axes as in the model, y upwards. */
function along({ from, to, bulge }: Edge): string {
  const arc = arcOf({ from, to, bulge });
  if (!arc || !Number.isFinite(arc.radius)) return `L${to.x} ${to.y}`;
  return `A${arc.radius} ${arc.radius} 0 ${Math.abs(bulge) > 1 ? 1 : 0} ${bulge > 0 ? 1 : 0} ${to.x} ${to.y}`;
}

export function edgePath(edge: Edge): string {
  return `M${edge.from.x} ${edge.from.y}${along(edge)}`;
}

/** The path along the edges between vertices, which is not closed. */
export function curvePath(vertices: readonly SceneVertex[]): string {
  const [first] = vertices;
  const edges = vertices.flatMap((_, i) => (i + 1 < vertices.length ? (edgeOf(vertices, i) ?? []) : []));
  return first ? `M${first.x} ${first.y}${edges.map(along).join("")}` : "";
}

export function outlinePath(loops: readonly SceneVertex[][]): string {
  return loops.map((loop) => (loop[0] ? `M${loop[0].x} ${loop[0].y}${edgesOf(loop).map(along).join("")}Z` : "")).join("");
}

export function emptyBox(): Box {
  return { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
}

export function grow(box: Box, p: Place): void {
  box.x0 = Math.min(box.x0, p.x);
  box.y0 = Math.min(box.y0, p.y);
  box.x1 = Math.max(box.x1, p.x);
  box.y1 = Math.max(box.y1, p.y);
}

/** The same for points as x, y, x, y. */
export function growBy(box: Box, points: ArrayLike<number>): Box {
  for (let i = 0; i + 1 < points.length; i += 2) grow(box, { x: points[i] ?? 0, y: points[i + 1] ?? 0 });
  return box;
}

export const centerOf = ({ x0, y0, x1, y1 }: Box): Place => ({ x: (x0 + x1) / 2, y: (y0 + y1) / 2 });

/** The box of outlines, with the extremes of arcs. */
export function boxOf(loops: readonly SceneVertex[][]): Box {
  const box = emptyBox();
  for (const loop of loops) {
    for (const edge of edgesOf(loop)) {
      grow(box, edge.from);
      const arc = arcOf(edge);
      if (!arc) continue;
      const [lo, hi] = arc.sweep > 0 ? [arc.start, arc.start + arc.sweep] : [arc.start + arc.sweep, arc.start];
      for (let k = Math.ceil(lo / (Math.PI / 2)); k * (Math.PI / 2) <= hi; k += 1) {
        const a = (k * Math.PI) / 2;
        grow(box, { x: arc.center.x + arc.radius * Math.cos(a), y: arc.center.y + arc.radius * Math.sin(a) });
      }
    }
  }
  return box;
}

export interface FeaturePlace {
  kind: "edge" | "vertex";
  loop: number;
  index: number;
}

/** What a feature is called without a name of the model's: `line 3 of loop 0`, `convex arc 19 of loop 0`, `vertex 2 of loop 0`. */
const PLAIN_NAME = /^(line|arc|convex arc|concave arc|edge|vertex) (\d+) of loop (\d+)$/;

/** Where a feature is, by the name that the command prints; null for a name that the part does not have. */
export function featurePlace(part: ScenePart, name: string): FeaturePlace | null {
  const plain = Object.keys(part.feature_names).find((k) => part.feature_names[k] === name) ?? name;
  const match = PLAIN_NAME.exec(plain);
  if (!match) return null;
  const [loop, index] = [Number(match[3]), Number(match[2])];
  if (index >= (part.loops[loop]?.length ?? 0)) return null;
  return { kind: match[1] === "vertex" ? "vertex" : "edge", loop, index };
}

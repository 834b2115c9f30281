/** Features of parts as they are drawn: what they are called, and how far two of them are apart along their normal. */

import type { PatchKind } from "./api.js";
import { TAU, cross, dot, sub, type Point, type Turn } from "./plane.js";
import { edgesOf, isBetweenChordAndArc, type DrawnLoops, type Edge } from "./edge.js";

/** The name of a feature in a saved space. */
export interface FeatureKey {
  /** `line`, `convexarc`, `concavearc` or `vertex`. */
  kind: string;
  loop_index: number;
  index: number;
}

interface FeaturePlace {
  loop_index: number;
  index: number;
}

interface NamedFeature {
  edge?: FeaturePlace;
  vertex?: FeaturePlace;
}

/** A part of a saved space. */
export interface SavedPart {
  name: string;
  loops: DrawnLoops;
  names?: [NamedFeature, string][];
}

/** A point p of a part at `at + R p`. */
export interface Placement {
  at: Point;
  turn: Turn;
}

function place(by: Placement, p: Point): Point {
  const v = rotate(by, p);
  return { x: by.at.x + v.x, y: by.at.y + v.y };
}

function rotate({ turn: t }: Placement, v: Point): Point {
  return { x: t.cos * v.x - t.sin * v.y, y: t.sin * v.x + t.cos * v.y };
}

export function inverse({ at, turn }: Placement): Placement {
  const back: Placement = { at: { x: 0, y: 0 }, turn: { cos: turn.cos, sin: -turn.sin } };
  const v = rotate(back, at);
  return { at: { x: -v.x, y: -v.y }, turn: back.turn };
}

export function compose(a: Placement, b: Placement): Placement {
  return {
    at: place(a, b.at),
    turn: { cos: a.turn.cos * b.turn.cos - a.turn.sin * b.turn.sin, sin: a.turn.sin * b.turn.cos + a.turn.cos * b.turn.sin },
  };
}

export { place, rotate };

/** An oriented circle that touches an edge in its middle; a vertex is one of radius 0. */
export interface Osculating {
  point: Point;
  normal: Point;
  curvature: number;
  radius: number;
  bulge: number;
}

/** The features of one part. */
export class Features {
  /** By their indices, each in the direction that has material on its left. */
  readonly edges: Edge[][];
  /** Whether a loop is so travelled from the last of its edges to the first. */
  readonly reversed: boolean[];
  private readonly names = new Map<string, string>();
  private readonly known = new Map<string, Osculating>();
  /** The farthest of a part's bounds from its centre, and the diagonal of these (model unit). */
  readonly arm: number;
  readonly size: number;

  /** `given`: names by what features are called without. Places are about a centre: parts may be drawn far away. */
  constructor(part: SavedPart, center: Point, given: Record<string, string> = {}) {
    const drawn = edgesOf(part.loops).map((loop) => loop.map((e) => ({ ...e, start: sub(e.start, center), end: sub(e.end, center) })));
    this.reversed = drawn.map((loop, i) => {
      const first = loop[0]?.start ?? { x: 0, y: 0 };
      const within = drawn.filter((other, k) => k !== i && isInLoop(other, first)).length;
      return signedAreaOf(loop) > 0 === (within % 2 === 1);
    });
    this.edges = drawn.map((loop, i) =>
      this.reversed[i] ? loop.map((e) => ({ start: e.end, end: e.start, bulge: -e.bulge })) : loop,
    );
    for (const [text, name] of Object.entries(given)) this.names.set(text, name);
    for (const [feature, name] of part.names ?? []) this.addName(feature, name);
    const points = this.edges.flat().flatMap((e) => [e.start, e.end, ...bulgePoints(e)]);
    const xs = points.map((p) => p.x);
    const ys = points.map((p) => p.y);
    const lo = { x: Math.min(...xs), y: Math.min(...ys) };
    const hi = { x: Math.max(...xs), y: Math.max(...ys) };
    this.arm = Math.max(Math.hypot(lo.x, lo.y), Math.hypot(hi.x, hi.y));
    this.size = Math.hypot(hi.x - lo.x, hi.y - lo.y);
  }

  private addName(feature: NamedFeature, name: string): void {
    const at = feature.vertex ?? feature.edge;
    if (!at) return;
    const kinds = feature.vertex ? ["vertex"] : ["line", "convex arc", "concave arc"];
    for (const kind of kinds) this.names.set(`${kind} ${at.index} of loop ${at.loop_index}`, name);
  }

  /** As the command calls a feature. */
  text(f: FeatureKey): string {
    const plain = plainText(f);
    return this.names.get(plain) ?? plain;
  }

  circle(f: FeatureKey): Osculating {
    const key = `${f.kind === "vertex" ? "v" : "e"}${f.loop_index}.${f.index}`;
    let found = this.known.get(key);
    if (!found) {
      found = this.osculating(f);
      this.known.set(key, found);
    }
    return found;
  }

  private osculating(f: FeatureKey): Osculating {
    const e = this.edges[f.loop_index]?.[f.index];
    if (!e) throw new Error(`a patch names ${plainText(f)}, which the part does not have`);
    const { start, end, bulge } = e;
    const back = this.reversed[f.loop_index];
    if (f.kind === "vertex") return { point: back ? end : start, normal: { x: 0, y: 0 }, curvature: Infinity, radius: 0, bulge: Infinity };
    const chord = sub(end, start);
    const right = { x: chord.y, y: -chord.x };
    const long = Math.sqrt(dot(chord, chord));
    const curvature = (4 * bulge) / (long * (1 + bulge * bulge));
    return {
      point: {
        x: (start.x + end.x) * 0.5 + right.x * (0.5 * bulge),
        y: (start.y + end.y) * 0.5 + right.y * (0.5 * bulge),
      },
      normal: { x: right.x / long, y: right.y / long },
      curvature,
      radius: bulge === 0 ? Infinity : 1 / curvature,
      bulge,
    };
  }
}

function plainText(f: FeatureKey): string {
  const kind = f.kind === "convexarc" ? "convex arc" : f.kind === "concavearc" ? "concave arc" : f.kind;
  return `${kind} ${f.index} of loop ${f.loop_index}`;
}

function bulgePoints(e: Edge): Point[] {
  if (e.bulge === 0) return [];
  const c = sub(e.end, e.start);
  const up = { x: c.y * 0.5 * e.bulge, y: -c.x * 0.5 * e.bulge };
  return [
    { x: e.start.x + up.x, y: e.start.y + up.y },
    { x: e.end.x + up.x, y: e.end.y + up.y },
  ];
}

function signedAreaOf(loop: Edge[]): number {
  const from = loop[0]?.start ?? { x: 0, y: 0 };
  let twice = 0;
  for (const e of loop) {
    twice += cross(sub(e.start, from), sub(e.end, from));
    const c = sub(e.end, e.start);
    const sweep = 4 * Math.atan(e.bulge);
    if (e.bulge !== 0) {
      const r = (Math.sqrt(dot(c, c)) * (1 + e.bulge * e.bulge)) / (4 * e.bulge);
      twice += r * r * (sweep - Math.sin(sweep));
    }
  }
  return 0.5 * twice;
}

function isInLoop(loop: Edge[], p: Point): boolean {
  let angle = 0;
  for (const e of loop) {
    const a = sub(e.start, p);
    const b = sub(e.end, p);
    angle += Math.atan2(cross(a, b), dot(a, b));
    if (e.bulge !== 0 && isBetweenChordAndArc(e, p)) angle += e.bulge > 0 ? TAU : -TAU;
  }
  return Math.abs(angle) > Math.PI;
}

/** What kind of contact two features make. */
export function patchKind(fixed: FeatureKey, moving: FeatureKey): PatchKind {
  const kind = (f: FeatureKey) => (f.kind === "line" || f.kind === "vertex" ? f.kind : "arc");
  const [a, b] = [kind(fixed), kind(moving)];
  if (a === "line" || b === "line") return a === "vertex" || b === "vertex" ? "line-vertex" : "line-arc";
  return a === "vertex" || b === "vertex" ? "arc-vertex" : "arc-arc";
}

/** Where two features touch, or would if moved along their normal. */
export interface Touching {
  /** Distance along the normal; negative where they overlap. */
  gap: number;
  onFixed: Point;
  onMoving: Point;
  /** The outward unit normal of the fixed part. */
  normal: Point;
}

/** Of arcs of more bulge than this the centre is near. */
const NEAR_CENTER = 0.125;

/** Everything in the fixed part's frame; `moving` is where the moving part is placed. The flatter circle is the base of the other. */
export function touchingAt(fixed: Osculating, moving: Osculating, by: Placement): Touching {
  const moves = Math.abs(moving.curvature) < Math.abs(fixed.curvature);
  const base = moves ? moving : fixed;
  const placed = moves ? inverse(by) : by;
  const loose = moves ? fixed : moving;
  const other: Osculating = { ...loose, point: place(placed, loose.point), normal: rotate(placed, loose.normal) };
  const { gap, normal } = gapBetween(base, other);
  const r = other.radius;
  const onOther =
    r === 0 ? other.point : { x: other.point.x - (other.normal.x + normal.x) * r, y: other.point.y - (other.normal.y + normal.y) * r };
  const onBase = { x: onOther.x - normal.x * gap, y: onOther.y - normal.y * gap };
  if (!moves) return { gap, onFixed: onBase, onMoving: onOther, normal };
  const turned = rotate(by, normal);
  return { gap, onFixed: place(by, onOther), onMoving: place(by, onBase), normal: { x: -turned.x, y: -turned.y } };
}

function gapBetween(base: Osculating, other: Osculating): { gap: number; normal: Point } {
  if (Math.abs(base.bulge) > NEAR_CENTER) {
    const center = (o: Osculating): Point =>
      o.radius === 0 ? o.point : { x: o.point.x - o.normal.x * o.radius, y: o.point.y - o.normal.y * o.radius };
    const apart = sub(center(other), center(base));
    const radius = base.radius + other.radius;
    const sign = radius < 0 ? -1 : 1;
    const far = Math.sqrt(dot(apart, apart));
    return { gap: far * sign - radius, normal: { x: (apart.x * sign) / far, y: (apart.y * sign) / far } };
  }
  const { curvature: k, normal: n } = base;
  const r = other.radius;
  const facing = r === 0 ? { x: 0, y: 0 } : { x: (n.x + other.normal.x) * r, y: (n.y + other.normal.y) * r };
  const d = sub(sub(other.point, base.point), facing);
  const bend = k / (1 + k * r);
  const g = dot(n, d) + 0.5 * bend * dot(d, d);
  const root = Math.sqrt(1 + 2 * bend * g);
  const normal = { x: n.x + d.x * bend, y: n.y + d.y * bend };
  const size = Math.sqrt(dot(normal, normal));
  return { gap: (2 * g) / (1 + root), normal: { x: normal.x / size, y: normal.y / size } };
}

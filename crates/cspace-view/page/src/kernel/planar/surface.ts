/** Slices read off the contact space. */

import type { PatchData, PlanarSpace } from "../../scene.js";
import { carrierOf } from "../contact-function.js";
import { curvePoint, type Curve } from "../curve.js";
import { flatBulge, placeOf } from "../flat-arc.js";
import { add, clamp, cross, distance, dot, length, partitionPoint, signum, sub, TAU, times, turnBy, turned, angleOf, type Point, type Turn } from "../plane.js";
import { TORN } from "../tolerance.js";
import { Alive } from "./alive.js";
import { boundaryAt, turnedInto } from "./patch.js";

/** A patch's curve in a slice, in the user's frame: free space is on its right. */
export interface SliceCurve {
  patch: number;
  curve: Curve;
  start: Point;
  end: Point;
}

export interface Slice {
  theta: number;
  curves: SliceCurve[];
  /** Whether the curves are not to be relied upon. */
  doubtful: boolean;
}

interface Turned {
  theta: number;
  turn: Turn;
}

function turnedBy(theta: number): Turned {
  return { theta, turn: turnBy(theta) };
}

/** An arc whose ends have passed each other by less than this (radians) has just ended. */
const PASSED_ENDS = 1e-5;

function sweepBetween(from: Point, to: Point, radius: number): number {
  const turned = Math.atan2(cross(from, to), dot(from, to)) * signum(radius);
  return (turned < -PASSED_ENDS ? turned + TAU : Math.max(turned, 0)) * signum(radius);
}

/** Orientations nearer to a critical one than this, relative to their size, are it but for rounding; it is taken by so much more. */
const NEAR = 4e-15;
const BESIDE = 8e-15;

export class Surface {
  readonly alive: Alive;
  /** Links at the right boundary of each patch. */
  private readonly after: number[][];
  private last: Slice | null = null;

  constructor(readonly space: PlanarSpace) {
    this.alive = new Alive(space.window, space.patches);
    this.after = space.patches.map(() => []);
    space.side_links.forEach((l, i) => this.after[l.before]?.push(i));
  }

  get patches(): readonly PatchData[] {
    return this.space.patches;
  }

  /** From lengths of the pair's frame to the model's unit. */
  outerLength(size: number): number {
    return size / this.space.frame.scale;
  }

  /** The position in the pair's frame. */
  inner(p: Point, turn: Turn): Point {
    const { fixed_center, moving_center, scale } = this.space.frame;
    return times(add(sub(p, fixed_center), turned(turn, moving_center)), scale);
  }

  /** An orientation, or one just above it where it is critical but for rounding. */
  settled(theta: number): number {
    const { window, critical_orientations: critical } = this.space;
    const scale = Math.max(Math.abs(theta), 1);
    const turns = window.full_turn ? TAU * Math.floor((theta + Math.PI) / TAU) : 0;
    const at = theta - turns;
    const next = partitionPoint(critical, (c) => c < at - NEAR * scale);
    const c = next < critical.length ? critical[next]! : critical.length > 0 ? critical[0]! + TAU : null;
    if (c === null) return theta;
    const aside = theta + (c - at) + BESIDE * scale;
    const within = window.full_turn || aside < window.hi;
    return Math.abs(c - at) <= NEAR * scale && within ? aside : theta;
  }

  /** The orientation brought into the interval of a patch that exists there. */
  present(patch: PatchData, theta: number): number | null {
    const window = this.space.window;
    if (!window.full_turn && theta === window.hi) return patch.hi >= theta ? patch.hi : null;
    const t = turnedInto(patch, theta);
    return t !== null && t < patch.hi ? t : null;
  }

  isDoubtful(theta: number): boolean {
    const { window, doubtful_orientations: doubtful } = this.space;
    if (doubtful.length === 0) return false;
    const t =
      window.full_turn && !(theta >= -Math.PI && theta <= Math.PI)
        ? clamp(theta - TAU * Math.floor((theta + Math.PI) / TAU), -Math.PI, Math.PI)
        : theta;
    const next = doubtful[partitionPoint(doubtful, (i) => i[1] < t)];
    return next !== undefined && next[0] <= t;
  }

  /** The curve of a patch at one of its orientations, placed as at another that is the same but for turns and rounding. */
  curve(patch: PatchData, theta: number, asked = theta): { curve: Curve; start: Point; end: Point } {
    return this.curveWithEnds(patch, turnedBy(theta), turnedBy(asked));
  }

  private curveWithEnds(patch: PatchData, at: Turned, asked: Turned): { curve: Curve; start: Point; end: Point } {
    const { fixed_center, moving_center, scale } = this.space.frame;
    const moved = turned(asked.turn, moving_center);
    const unscale = 1 / scale;
    const outer = (p: Point): Point => ({
      x: fixed_center.x + (p.x * unscale - moved.x),
      y: fixed_center.y + (p.y * unscale - moved.y),
    });
    const own = carrierOf(patch.function, at.turn);
    const first = boundaryAt(patch, own, patch.left, at.theta, at.turn);
    const last = boundaryAt(patch, own, patch.right, at.theta, at.turn);
    const start = outer(first);
    const end = outer(last);
    if (own.kind === "line") return { curve: { kind: "segment", start, end }, start, end };
    if (own.kind === "flat") {
      const bulge = flatBulge(own, placeOf(own, first), placeOf(own, last));
      return { curve: { kind: "flat", start, end, bulge }, start, end };
    }
    const { center: c, radius } = own;
    const sweep = sweepBetween(sub(first, c), sub(last, c), radius);
    const curve: Curve = {
      kind: "arc",
      center: outer(c),
      radius: this.outerLength(Math.abs(radius)),
      startAngle: angleOf(sub(first, c)),
      sweep,
    };
    const onCircle = (p: Point, s: number): Point => {
      const arm = sub(p, c);
      const q = add(c, times(arm, Math.abs(radius) / length(arm)));
      return Number.isFinite(q.x) && Number.isFinite(q.y) ? outer(q) : curvePoint(curve, s);
    };
    // An arc that has just ended is one point.
    return { curve, start: onCircle(first, 0), end: onCircle(sweep === 0 ? first : last, 1) };
  }

  /** The slice at an orientation; at a critical one that just above it. */
  slice(theta: number): Slice {
    if (this.last && this.last.theta === theta) return this.last;
    const settled = this.settled(theta);
    const asked = turnedBy(theta);
    let at = turnedBy(settled);
    const curves: SliceCurve[] = [];
    const times: number[] = [];
    for (const i of this.alive.at(theta)) {
      const patch = this.patches[i]!;
      const t = this.present(patch, settled);
      if (t === null) continue;
      if (t !== at.theta) at = turnedBy(t);
      curves.push({ patch: i, ...this.curveWithEnds(patch, at, asked) });
      times.push(t);
    }
    this.last = { theta, curves, doubtful: this.isDoubtful(theta) || this.isTorn(curves, times) };
    return this.last;
  }

  /** Whether some curve does not begin where the one before it ends. */
  private isTorn(curves: SliceCurve[], times: number[]): boolean {
    const n = curves.length;
    const torn = this.outerLength(TORN);
    const place = new Map<number, number>();
    curves.forEach((c, k) => place.set(c.patch, k));
    const next = new Int32Array(n).fill(-1);
    curves.forEach((c, k) => {
      const t = times[k]!;
      const isLast = t === this.patches[c.patch]!.hi;
      for (const i of this.after[c.patch]!) {
        const l = this.space.side_links[i]!;
        if (l.lo <= t && (t < l.hi || (isLast && t <= l.hi))) {
          next[k] = place.get(l.after) ?? -1;
          break;
        }
      }
    });
    closeLoops(curves, next, torn);
    for (let k = 0; k < n; k++) {
      const follower = curves[next[k]!];
      if (!follower || distance(curves[k]!.end, follower.start) > torn) return true;
    }
    return false;
  }
}

/**
 * Lets every curve without a successor be followed by the nearest that begins within a distance and follows none: where more than two curves
 * meet in a point but for rounding, the order in which they are met there may leave an end open.
 */
function closeLoops(curves: SliceCurve[], next: Int32Array, within: number): void {
  if (!next.includes(-1)) return;
  const follows = new Uint8Array(curves.length);
  for (const k of next) if (k >= 0) follows[k] = 1;
  const near: [number, number, number][] = [];
  curves.forEach((c, i) => {
    if (next[i] !== -1) return;
    const end = curvePoint(c.curve, 1);
    curves.forEach((d, j) => {
      if (follows[j]) return;
      const apart = distance(end, curvePoint(d.curve, 0));
      if (apart <= within) near.push([apart, i, j]);
    });
  });
  near.sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2]);
  for (const [, i, j] of near) {
    if (next[i] === -1 && !follows[j]) {
      next[i] = j;
      follows[j] = 1;
    }
  }
}

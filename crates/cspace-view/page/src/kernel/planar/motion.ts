/** Motions of a planar pair up to contact, and along it. */

import type { Motion, PlanarConfiguration } from "../api.js";
import type { PatchData } from "../../scene.js";
import { gradientOf, valueOf } from "../contact-function.js";
import { distanceBelow, nearestOn } from "../curve.js";
import { firstTime, type Track } from "../march.js";
import { clamp, distance, length as size, sub, TAU, times, turnBy, turned, type Point } from "../plane.js";
import { slideOn, type Constraint, type Ground, type Stop, type Vec } from "../slide.js";
import {
  ABOVE,
  AWAY,
  BACK_GROWTH,
  BESIDE,
  BEYOND_END,
  DEPTH,
  END_SPEED,
  FINEST,
  FIRST_BACK,
  HALVINGS,
  LEAST_RADIUS,
  LONGEST_STEP,
  ON_CURVE,
  SEAM,
  TOUCHES,
  WITHIN_REACH,
} from "../tolerance.js";
import type { Classifier } from "./classify.js";
import { turnedInto } from "./patch.js";
import { Path } from "./path.js";
import type { Surface } from "./surface.js";

/** Sizes of neighbourhoods whose patches are kept (length of the pair's frame): a motion up to half as long is looked for in one. */
const NEIGHBOURHOODS = [0.005, 0.02, 0.08, 0.32];

/** So far a motion is looked for among the patches that are near, before it is among all that it may come to (length of the frame). */
const PROBE = 0.005;

const NOWHERE: Point = { x: 0, y: 0 };

/** The patches that may be within a distance of a position, and of an orientation by how far it moves the part. In the pair's frame. */
interface Neighbourhood {
  at: Point;
  theta: number;
  patches: readonly number[];
}

export class PlanarMotion {
  /** Radius of the moving part about its centre (length of the pair's frame): so much an orientation counts. */
  private readonly radius: number;
  /** Distance that counts as contact, in the pair's frame. */
  private readonly contact: number;
  private readonly neighbourhoods: (Neighbourhood | undefined)[] = [];

  constructor(
    private readonly surface: Surface,
    private readonly classifier: Classifier,
    private readonly contactDistance: number,
    moving: { loops: readonly (readonly { x: number; y: number; bulge?: number }[])[] },
  ) {
    const { moving_center: center, scale } = surface.space.frame;
    this.contact = contactDistance * scale;
    const far = moving.loops.flat().map((p) => distance(p, center) * scale);
    this.radius = Math.max(...far, LEAST_RADIUS);
  }

  /** As far as the straight way in (x, y, θ) is free. The first contact is found by contact functions, and checked by classification. */
  advance(from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    const goal = this.within(to);
    const start = this.classifier.located(from);
    if (!start || !Number.isFinite(goal.x + goal.y + goal.theta)) return { at: from, stopped: null };
    // Out of blocked space any way leads.
    if (start.class === "blocked") return { at: goal, stopped: null };
    const { fixed_center, moving_center, scale } = this.surface.space.frame;
    const path = new Path(
      times(sub(from, fixed_center), scale),
      times(sub(goal, from), scale),
      times(moving_center, scale),
      from.theta,
      goal.theta - from.theta,
    );
    let { time, patch } = this.first(path, DEPTH);
    const at = (t: number): PlanarConfiguration =>
      t >= 1
        ? goal
        : { x: from.x + t * (goal.x - from.x), y: from.y + t * (goal.y - from.y), theta: from.theta + t * (goal.theta - from.theta) };
    const fine = this.contact / (size(path.v) + Math.abs(path.omega) * (this.radius + size(path.m)));
    // A motion may leave the last orientation at which its contacts exist before it sinks into them, where free space ends there.
    const soon = BEYOND_END * fine;
    if (start.class === "contact" && soon < time && this.isBlocked(at(soon))) [time, patch] = [soon, null];
    const checked = this.lastNotBlocked(at, patch === null ? time : this.pressed(at, time, fine), fine);
    return { at: at(checked), stopped: checked >= 1 ? null : (patch ?? this.nearestPatch(at(checked))) };
  }

  /** The same, then along the surface. Nearest to the goal is meant in weighted coordinates, about the moving part's centre. */
  slide(from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    const first = this.advance(from, to);
    if (first.stopped === null) return first;
    const goal = this.within(to);
    const found = slideOn(this.ground, this.weighted(first.at), this.weighted(goal), first.stopped);
    const at = found.stopped === null ? goal : this.unweighted(found.at);
    return this.isBlocked(at) ? first : { at, stopped: found.stopped };
  }

  /** With the orientation brought into the window. */
  private within(c: PlanarConfiguration): PlanarConfiguration {
    const { lo, hi, full_turn } = this.surface.space.window;
    return full_turn ? c : { ...c, theta: clamp(c.theta, lo, hi) };
  }

  /** The first contact of a motion, 1 and none if there is none. */
  private first(path: Path, depth: number): { time: number; patch: number | null } {
    let time = 1;
    let patch: number | null = null;
    const [a, b] = [path.theta(0), path.theta(1)];
    const fullTurn = this.surface.space.window.full_turn;
    const far = path.reach();
    for (const i of this.around(path)) {
      const p = this.surface.patches[i]!;
      if (!fullTurn && (p.hi < Math.min(a, b) - SEAM || p.lo > Math.max(a, b) + SEAM)) continue;
      if (far.isAway(p.function, WITHIN_REACH * this.contact)) continue;
      for (const [lo, hi] of presences(p, path, fullTurn)) {
        if (lo >= time) continue;
        const found = firstTime(this.track(p, path), lo, Math.min(hi, time), this.contact, depth * this.contact);
        if (found !== null && found < time) [time, patch] = [found, i];
      }
    }
    return { time, patch };
  }

  /** Patches among which are all that a motion may come to. Those of a neighbourhood are kept: motions along a surface are many and short. */
  private around(path: Path): readonly number[] {
    const [start, end] = [path.at(0), path.at(1)];
    const [a, b] = [path.theta(0), path.theta(1)];
    const away = (p: Point, theta: number, n: Neighbourhood): number =>
      Math.max(distance(p, n.at), Math.abs(theta - n.theta) * this.radius);
    const length = Math.max(distance(start, end), Math.abs(b - a) * this.radius) + Math.abs(b - a) * size(path.m);
    const between = (from: number, to: number) => this.surface.alive.between(from - SEAM, to + SEAM);
    const level = NEIGHBOURHOODS.findIndex((s) => 2 * length <= s);
    if (level < 0) return between(Math.min(a, b), Math.max(a, b));
    const known = this.neighbourhoods[level];
    if (known && away(start, a, known) + length <= NEIGHBOURHOODS[level]!) return known.patches;
    const all = NEIGHBOURHOODS[level]!;
    const turn = all / this.radius;
    const reach = new Path(start, { x: all, y: 0 }, { x: 0, y: 0 }, a, turn).reach();
    const patches = between(a - turn, a + turn).filter((i) => !reach.isAway(this.surface.patches[i]!.function, WITHIN_REACH * this.contact));
    this.neighbourhoods[level] = { at: start, theta: a, patches };
    return patches;
  }

  /** The contact function of a patch along a motion, and where the patch is there. */
  private track(patch: PatchData, path: Path): Track {
    const off = (t: number): number => {
      const theta = path.theta(t);
      const c = this.outer(path.at(t), theta);
      return distance(nearestOn(this.curveNear(patch, theta), c), c);
    };
    const { scale } = this.surface.space.frame;
    const speed = Math.hypot(path.v.x, path.v.y) + Math.abs(path.omega) * (END_SPEED + Math.hypot(path.m.x, path.m.y));
    return {
      at: (t, until) => path.sample(patch, t, until),
      isOn: (t) => {
        const by = off(t);
        if (by <= ON_CURVE * this.contactDistance) return true;
        if (by > BEYOND_END * this.contactDistance) return false;
        // Where two curves meet at a small angle, what is a little beyond both is far beyond their ends: whether it goes on tells.
        const later = Math.min(t + (2 * by * scale) / speed, 1);
        return this.isBlocked(this.outer(path.at(later), path.theta(later)));
      },
      away: (t) => (AWAY * off(t) * scale) / speed,
    };
  }

  /** The curve of a patch at an orientation, or at the nearest it has. */
  private curveNear(patch: PatchData, theta: number) {
    const before = theta + TAU * Math.round((0.5 * (patch.lo + patch.hi) - theta) / TAU);
    const t = turnedInto(patch, theta) ?? clamp(before, patch.lo, patch.hi);
    return this.surface.curve(patch, t, theta).curve;
  }

  /** The configuration of a position in the pair's frame. */
  private outer(p: Point, theta: number): PlanarConfiguration {
    const { fixed_center, moving_center, scale } = this.surface.space.frame;
    const moved = turned(turnBy(theta), moving_center);
    return { x: fixed_center.x + (p.x / scale - moved.x), y: fixed_center.y + (p.y / scale - moved.y), theta };
  }

  /** Patches whose curves are within a distance, at orientations no farther than `beside` from this one. */
  near(c: PlanarConfiguration, within: number, beside: number): number[] {
    const turn = turnBy(c.theta);
    const p = this.surface.inner(c, turn);
    const { scale } = this.surface.space.frame;
    const fullTurn = this.surface.space.window.full_turn;
    return this.around(new Path(p, NOWHERE, NOWHERE, c.theta, 0)).filter((i) => {
      const patch = this.surface.patches[i]!;
      if (Math.abs(valueOf(patch.function, p, turn)) > within * scale) return false;
      const turns = fullTurn ? TAU * Math.ceil((patch.lo - beside - c.theta) / TAU) : 0;
      const t = c.theta + turns;
      if (t < patch.lo - beside || t > patch.hi + beside) return false;
      return distance(nearestOn(this.curveNear(patch, c.theta), c), c) <= within;
    });
  }

  /** The patch of the slice whose curve is nearest; null if the slice has none. */
  private nearestPatch(c: PlanarConfiguration): number | null {
    let [found, least]: [number | null, number] = [null, Infinity];
    for (const { patch, curve } of this.surface.slice(c.theta).curves) {
      const away = distanceBelow(curve, c, least);
      if (away < least) [found, least] = [patch, away];
    }
    return found;
  }

  /** Outside of the window nothing is free. */
  private isBlocked(c: PlanarConfiguration): boolean {
    return (this.classifier.located(c)?.class ?? "blocked") === "blocked";
  }

  /** The time of a contact, or a moment later if it is only all but come to by then. */
  private pressed(at: (t: number) => PlanarConfiguration, time: number, fine: number): number {
    if (this.classifier.located(at(time))?.class !== "free") return time;
    for (let by = fine; by <= 2 * BEYOND_END * fine; by *= 2) {
      const later = Math.min(time + by, 1);
      if (this.classifier.located(at(later))?.class !== "free") return later;
    }
    return time;
  }

  /** `fine`: how long what counts as contact takes to pass. The time itself, if it is not blocked then; or the last before at which it is not, as far as halving tells. */
  private lastNotBlocked(at: (t: number) => PlanarConfiguration, time: number, fine: number): number {
    const isBlocked = (t: number) => this.isBlocked(at(t));
    if (!isBlocked(time)) return time;
    let [lo, hi] = [0, time];
    // It has mostly gone too far by little.
    for (let back = FIRST_BACK * fine; back < time; back *= BACK_GROWTH) {
      if (isBlocked(time - back)) {
        hi = time - back;
        continue;
      }
      lo = time - back;
      break;
    }
    for (let k = 0; k < HALVINGS && hi - lo > FINEST * fine; k++) {
      const mid = 0.5 * (lo + hi);
      if (isBlocked(mid)) hi = mid;
      else lo = mid;
    }
    return lo;
  }

  // Positions in the pair's frame, and the orientation by how far it moves the part.

  private weighted(c: PlanarConfiguration): Vec {
    const p = this.surface.inner(c, turnBy(c.theta));
    return [p.x, p.y, c.theta * this.radius];
  }

  private unweighted(v: Vec): PlanarConfiguration {
    const { lo, hi, full_turn } = this.surface.space.window;
    const theta = v[2]! / this.radius;
    // At the window's ends rounding may leave it just beyond.
    const beyond = !full_turn && (Math.abs(theta - lo) <= SEAM || Math.abs(theta - hi) <= SEAM);
    return this.outer({ x: v[0]!, y: v[1]! }, beyond ? clamp(theta, lo, hi) : theta);
  }

  /** The first contact of a motion that is straight in weighted coordinates. */
  private straight(from: Vec, to: Vec): Stop {
    const [a, b] = [from[2]! / this.radius, to[2]! / this.radius];
    const path = new Path({ x: from[0]!, y: from[1]! }, { x: to[0]! - from[0]!, y: to[1]! - from[1]! }, NOWHERE, a, b - a);
    const { time, patch } = this.first(path, -ABOVE);
    return { at: time >= 1 ? to : from.map((x, i) => x + time * (to[i]! - x)), stopped: time >= 1 ? null : patch };
  }

  /** The surface as sliding sees it. */
  private get ground(): Ground {
    const { lo, hi, full_turn } = this.surface.space.window;
    return {
      contact: this.contact,
      longest: LONGEST_STEP,
      limits: [null, null, full_turn ? null : [lo * this.radius, hi * this.radius]],
      advance: (from, goal) => {
        const to: Vec = full_turn ? goal : [goal[0]!, goal[1]!, clamp(goal[2]!, lo * this.radius, hi * this.radius)];
        // What presses on the surface mostly goes no farther: few patches are near.
        const share = PROBE / Math.hypot(...to.map((x, i) => x - from[i]!));
        const soon = share < 0.5 ? this.straight(from, to.map((x, i) => from[i]! + share * (x - from[i]!))) : null;
        return soon && soon.stopped !== null ? soon : this.straight(from, to);
      },
      // At a critical orientation some patches begin and others end: both touch.
      touching: (v) => this.near(this.unweighted(v), TOUCHES * this.contactDistance, BESIDE),
      constraint: (patch, v) => this.constraint(this.surface.patches[patch]!, v),
      isBlocked: (v) => {
        const c = this.unweighted(v);
        // Most steps end in contact, which is told without the slice.
        const isSure = this.classifier.covers(c) && !this.surface.isDoubtful(c.theta);
        return !(isSure && this.near(c, this.contactDistance, 0).length > 0) && this.isBlocked(c);
      },
    };
  }

  /** The contact function of a patch and its gradient, in weighted coordinates. */
  private constraint(patch: PatchData, v: Vec): Constraint {
    const p = { x: v[0]!, y: v[1]! };
    const turn = turnBy(v[2]! / this.radius);
    const { normal, byTheta } = gradientOf(patch.function, p, turn);
    return { value: valueOf(patch.function, p, turn), gradient: [normal.x, normal.y, byTheta / this.radius] };
  }
}

/** The times of a motion at which a patch exists. */
function presences(patch: PatchData, path: Path, fullTurn: boolean): [number, number][] {
  const [a, b] = [path.theta(0), path.theta(1)];
  const [least, most] = [Math.min(a, b), Math.max(a, b)];
  const first = fullTurn ? Math.ceil((least - patch.hi - SEAM) / TAU) : 0;
  const last = fullTurn ? Math.floor((most - patch.lo + SEAM) / TAU) : 0;
  const found: [number, number][] = [];
  for (let k = first; k <= last; k++) {
    const [begin, end] = [patch.lo + k * TAU - SEAM, patch.hi + k * TAU + SEAM];
    if (begin > most || end < least) continue;
    if (path.omega === 0) {
      found.push([0, 1]);
      continue;
    }
    const [s, t] = [(begin - a) / path.omega, (end - a) / path.omega];
    found.push([Math.max(Math.min(s, t), 0), Math.min(Math.max(s, t), 1)]);
  }
  return found;
}

/** Motions of two parts on their axes up to contact, and along it. */

import type { AxesConfiguration, Motion } from "../api.js";
import { firstTime, type Track } from "../march.js";
import { clamp, TAU, type Point } from "../plane.js";
import { slideOn, type Ground, type Vec } from "../slide.js";
import { DEPTH, HALVINGS, LONGEST_STEP, TOUCHES } from "../tolerance.js";
import type { AxesClassifier } from "./classify.js";
import type { AxesSpaceData } from "./data.js";
import type { Extent, Range } from "./extent.js";
import type { Graphs } from "./graphs.js";
import { AxesPath } from "./path.js";
import type { PlaneMap } from "./plane-map.js";
import { NEAR } from "./tolerance.js";

export class AxesMotion {
  /** Distance that counts as contact, in the pair's frame. */
  private readonly contact: number;

  constructor(
    private readonly space: AxesSpaceData,
    private readonly graphs: Graphs,
    private readonly map: PlaneMap,
    private readonly classifier: AxesClassifier,
    contactDistance: number,
  ) {
    this.contact = contactDistance * space.map.frame.scale;
  }

  /** As far as the straight way in (u, v) is free. */
  advance(from: AxesConfiguration, to: AxesConfiguration): Motion<AxesConfiguration> {
    const start = this.classifier.classify(from.u, from.v);
    const goal = this.within(to);
    if (start === null || !Number.isFinite(goal.u + goal.v)) return { at: from, stopped: null };
    // Out of blocked space any way leads.
    if (start === "blocked") return { at: goal, stopped: null };
    const found = this.checked(this.inner(from), this.inner(goal));
    return { at: found.stopped === null ? goal : this.outer(found.at), stopped: found.stopped };
  }

  /** The same, then along the curves of contact. */
  slide(from: AxesConfiguration, to: AxesConfiguration): Motion<AxesConfiguration> {
    const first = this.advance(from, to);
    if (first.stopped === null) return first;
    const goal = this.within(to);
    const found = slideOn(this.ground, this.inner(first.at), this.inner(goal), first.stopped);
    const at = found.stopped === null ? goal : this.outer(found.at);
    return (this.classifier.classify(at.u, at.v) ?? "blocked") === "blocked" ? first : { at, stopped: found.stopped };
  }

  /** Within the ranges of motion. */
  private within(c: AxesConfiguration): AxesConfiguration {
    const { x, y, motions } = this.graphs;
    const p = this.map.inner(c.u, c.v);
    const into = (t: number, e: Extent, moves: boolean) => (!moves ? 0 : e.isLimited ? clamp(t, e.lo, e.hi) : t);
    const q = { x: into(p.x, x, motions.first.kind !== "still"), y: into(p.y, y, motions.second.kind !== "still") };
    const { u, v } = this.outer([q.x, q.y]);
    // What is within is not to be rounded.
    return { u: q.x === p.x && q.y === p.y ? c.u : this.limited(u, c.u, "u"), v: q.x === p.x && q.y === p.y ? c.v : this.limited(v, c.v, "v") };
  }

  /** A coordinate brought to the end of its range, as the model gives that. */
  private limited(brought: number, asked: number, which: "u" | "v"): number {
    const { range, motion } = which === "u" ? this.space.fixed_axis : this.space.moving_axis;
    if (motion.type === "fixed") return 0;
    return range ? clamp(asked, range[0], range[1]) : brought;
  }

  private inner(c: AxesConfiguration): Vec {
    const p = this.map.inner(c.u, c.v);
    return [p.x, p.y];
  }

  private outer(v: Vec): AxesConfiguration {
    return this.map.outer(v[0]!, v[1]!);
  }

  /** Of two slides along one line only a difference counts. */
  private counted([x, y]: Vec): Point {
    const share = this.map.oneLine;
    return share === null ? { x: x!, y: y! } : { x: 0, y: y! - x! * share };
  }

  private isBlocked(v: Vec): boolean {
    const { u, v: w } = this.outer(v);
    return (this.classifier.classify(u, w) ?? "blocked") === "blocked";
  }

  /** The first contact of a straight motion by contact conditions alone. */
  private straight(from: Vec, to: Vec): { at: Vec; stopped: number | null } {
    const [a, b] = [this.counted(from), this.counted(to)];
    const path = new AxesPath(a, { x: b.x - a.x, y: b.y - a.y });
    let time = 1;
    let patch: number | null = null;
    const near = this.classifier.byX.between(Math.min(a.x, b.x) - NEAR, Math.max(a.x, b.x) + NEAR);
    for (const i of near) {
      const branch = this.space.branches[i]!;
      const start = this.entry(branch.cell, path, 0);
      if (start >= time) continue;
      const found = firstTime(this.track(branch.cell, path), start, time, this.contact, DEPTH * this.contact);
      if (found !== null && found < time) [time, patch] = [found, branch.patch];
    }
    return { at: pointAt(from, to, time), stopped: patch };
  }

  /** The same, and not blocked where it ends. */
  private checked(from: Vec, to: Vec): { at: Vec; stopped: number | null } {
    const found = this.straight(from, to);
    if (!this.isBlocked(found.at)) return found;
    const at = (t: number) => pointAt(from, found.at, t);
    const last = at(this.lastNotBlocked(at));
    return { at: last, stopped: found.stopped ?? this.touching(last, Infinity)[0] ?? 0 };
  }

  /** The last time before a motion is blocked at its end, as far as halving tells. */
  private lastNotBlocked(at: (t: number) => Vec): number {
    let [lo, hi] = [0, 1];
    for (let k = 0; k < HALVINGS; k++) {
      const mid = 0.5 * (lo + hi);
      if (this.isBlocked(at(mid))) hi = mid;
      else lo = mid;
    }
    return lo;
  }

  /** The contact condition of a cell along a motion, and whether the motion is in the cell. */
  private track(cell: number, path: AxesPath): Track {
    const condition = this.graphs.condition(cell);
    return {
      at: (t, until) => path.sample(condition, t, until),
      isOn: (t) => {
        const p = path.at(t);
        return this.classifier.touch(cell, p.x, p.y, this.contact, this.contact) !== null;
      },
      away: (t) => this.entry(cell, path, t) - t,
    };
  }

  /** The first time from t on at which a motion is in the box of a cell; more than 1 if it is not. */
  private entry(cell: number, path: AxesPath, t: number): number {
    const box = this.graphs.box(cell);
    let at = t;
    // In turns, each coordinate waits for the other: a motion that goes around comes again.
    for (let k = 0; k < 8; k++) {
      const p = path.at(at);
      const x = waiting(p.x, path.by.x, box.x, this.graphs.x);
      const y = waiting(p.y, path.by.y, box.y, this.graphs.y);
      const wait = Math.max(x, y);
      if (!(wait > 0)) return at;
      at += wait;
      if (!(at <= 1)) return 2;
    }
    return at;
  }

  /** Patches within a distance (length of the pair's frame), nearest first. */
  private touching(v: Vec, within: number): number[] {
    const p = this.counted(v);
    const { u, v: w } = this.map.outer(p.x, p.y);
    return this.classifier.contacts(u, w, within / this.space.map.frame.scale).map(([patch]) => patch);
  }

  /** The curves of contact as sliding sees them. */
  private get ground(): Ground {
    const limits = (e: Extent): Range | null => (e.isLimited ? [e.lo, e.hi] : null);
    return {
      contact: this.contact,
      longest: LONGEST_STEP,
      limits: [limits(this.graphs.x), limits(this.graphs.y)],
      advance: (from, to) => this.straight(from, this.inner(this.within(this.outer(to)))),
      touching: (v) => this.touching(v, TOUCHES * this.contact),
      constraint: (patch, v) => {
        const p = this.counted(v);
        const first = this.space.patches[patch]!.branches.start;
        const condition = this.graphs.condition(this.space.branches[first]!.cell);
        const [byX, byY] = condition.gradient(p.x, p.y);
        const share = this.map.oneLine;
        return { value: condition.value(p.x, p.y), gradient: share === null ? [byX, byY] : [-share * byY, byY] };
      },
      isBlocked: (v) => this.isBlocked(v),
    };
  }
}

function pointAt(from: Vec, to: Vec, t: number): Vec {
  return t >= 1 ? to : from.map((x, i) => x + t * (to[i]! - x));
}

/** How long a coordinate takes to come into a range; 0 if it is there, infinite if it does not come. */
function waiting(t: number, rate: number, [lo, hi]: Range, extent: Extent): number {
  if (extent.brought(t, [lo, hi], NEAR) !== null) return 0;
  if (rate === 0) return Infinity;
  let way = rate > 0 ? lo - NEAR - t : t - hi - NEAR;
  if (extent.isCircle) way -= TAU * Math.floor(way / TAU);
  else if (way < 0) return Infinity;
  return way / Math.abs(rate);
}

/** Lower pairs: two parts that a joint keeps in permanent contact. A configuration is in contact if the joint allows it. */

import type { Classification, Kernel, Motion, PatchInfo, PlanarConfiguration, Touch } from "./api.js";
import type { LowerSpace, ScenePair } from "../scene.js";
import { Features, type SavedPart } from "./features.js";
import { clamp, dot, TAU, turnBy, turned, unit, wrapped, type Point } from "./plane.js";

type Joint = { kind: "revolute"; at: Point } | { kind: "prismatic"; direction: Point } | { kind: "rigid" };

/** Contacts are known to this share of the pair's size: 2⁻³⁷. */
const RESOLUTION = 2 ** -37;

function jointOf(data: Record<string, unknown>): Joint {
  const kind = String(data["type"] ?? data["kind"]);
  if (kind === "revolute") return { kind, at: data["at"] as Point };
  if (kind === "prismatic") return { kind, direction: data["direction"] as Point };
  return { kind: "rigid" };
}

export class LowerPair implements Kernel<PlanarConfiguration> {
  readonly class = "lower";
  readonly coordinates = "planar";
  readonly patchCount = 0;
  private readonly joint: Joint;
  private readonly limits: [number, number] | null;
  private readonly size: number;
  private readonly resolution: number;

  constructor(_pair: ScenePair, space: LowerSpace) {
    const parts = space as unknown as { fixed: SavedPart; moving: SavedPart };
    this.joint = jointOf(space.joint as unknown as Record<string, unknown>);
    this.limits = space.limits;
    const ofJoint = this.joint.kind === "revolute" ? Math.hypot(this.joint.at.x, this.joint.at.y) : 0;
    this.size = Math.max(...[parts.fixed, parts.moving].map((p) => new Features(p, { x: 0, y: 0 }).size), ofJoint);
    this.resolution = RESOLUTION * this.size;
  }

  patch(index: number): PatchInfo {
    throw new RangeError(`there is no patch ${index}: a joint has none`);
  }

  classify(c: PlanarConfiguration): Classification | null {
    if (![c.x, c.y, c.theta].every(Number.isFinite)) return null;
    return this.isOnJoint(c) ? "contact" : "blocked";
  }

  private isOnJoint(c: PlanarConfiguration): boolean {
    const t = this.motionOf(c);
    if (t === null) return false;
    // Orientation first: what it is off by moves the position, too.
    const off = wrapped(c.theta - this.at(t).theta);
    if (Math.abs(off) > this.resolution / this.size) return false;
    const there = this.joint.kind === "revolute" ? this.at(c.theta) : this.at(t);
    return Math.hypot(c.x - there.x, c.y - there.y) <= this.resolution;
  }

  /** The joint's motion at a configuration; null beyond its limits. */
  private motionOf(c: PlanarConfiguration): number | null {
    if (this.joint.kind === "rigid") return 0;
    const turning = this.joint.kind === "revolute";
    let t = this.joint.kind === "revolute" ? c.theta : dot(unit(this.joint.direction), c);
    if (!this.limits) return t;
    const [lo, hi] = this.limits;
    const slack = turning ? this.resolution / this.size : this.resolution;
    if (turning) t += TAU * Math.ceil((lo - slack - t) / TAU);
    return lo - slack <= t && t <= hi + slack ? clamp(t, lo, hi) : null;
  }

  /** The configuration at a motion of the joint. */
  private at(t: number): PlanarConfiguration {
    switch (this.joint.kind) {
      case "revolute": {
        const { at } = this.joint;
        const v = turned(turnBy(t), at);
        return { x: at.x - v.x, y: at.y - v.y, theta: t };
      }
      case "prismatic": {
        const d = unit(this.joint.direction);
        return { x: d.x * t, y: d.y * t, theta: 0 };
      }
      case "rigid":
        return { x: 0, y: 0, theta: 0 };
    }
  }

  region(_c: PlanarConfiguration): null {
    return null;
  }

  touching(_c: PlanarConfiguration, _within?: number): Touch[] {
    return [];
  }

  nearest(_c: PlanarConfiguration): null {
    return null;
  }

  patchesTouching(_c: PlanarConfiguration): number[] {
    return [];
  }

  /** To the configuration of the joint that is as far along it as the asked one. */
  advance(_from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    if (this.joint.kind === "rigid") return { at: this.at(0), stopped: null };
    const t = this.joint.kind === "revolute" ? to.theta : dot(unit(this.joint.direction), to);
    return { at: this.at(this.limits ? clamp(t, this.limits[0], this.limits[1]) : t), stopped: null };
  }

  slide(from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    return this.advance(from, to);
  }
}

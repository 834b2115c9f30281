/** Pairs joined for good: one motion, no contacts. */

import type { PlanarConfiguration } from "../kernel/api.js";
import type { LowerSpace, Place, ScenePair } from "../scene.js";
import { ofMotion, turnAbout, unit } from "./placement.js";

export interface LowerPair {
  type: "revolute" | "prismatic";
  limits: [number, number] | null;
  /** Where a revolute joint is, in the fixed part's frame. */
  pivot: Place | null;
  at(s: number): PlanarConfiguration;
  /** The motion whose configuration is nearest. */
  coordinate(c: PlanarConfiguration): number;
}

/** What a lower pair's space tells of its joint; null for other pairs. */
export function lowerPair(pair: ScenePair): LowerPair | null {
  if (pair.class !== "lower" || pair.space === null) return null;
  const { joint, limits } = JSON.parse(pair.space) as LowerSpace;
  const held = (s: number) => (limits ? Math.min(limits[1], Math.max(limits[0], s)) : s);
  if (joint.type === "revolute" && joint.at) {
    const at = joint.at;
    return { type: joint.type, limits, pivot: at, at: (s) => turnAbout(at, held(s)), coordinate: (c) => held(c.theta) };
  }
  if (!joint.direction) return null;
  const direction = unit(joint.direction);
  return {
    type: "prismatic",
    limits,
    pivot: null,
    at: (s) => ofMotion({ type: "prismatic", direction, range: null }, held(s)),
    coordinate: (c) => held(c.x * direction.x + c.y * direction.y),
  };
}

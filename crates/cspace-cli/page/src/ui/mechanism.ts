/** How the configuration of a pair and the placements of all parts follow from each other. */

import type { AxesConfiguration, Configuration, PlanarConfiguration } from "../kernel/api.js";
import type { Place, Scene, SceneJoint, ScenePair } from "../scene.js";
import { IDENTITY, apply, compose, coordinateOf, ofMotion, relative, rotate, turnAbout, unit, type Placement } from "./placement.js";

export function isAxes(c: Configuration): c is AxesConfiguration {
  return "u" in c;
}

export function isPlanar(c: Configuration): c is PlanarConfiguration {
  return "theta" in c;
}

/** Whether the pair's configurations are (u, v). */
export function hasAxes(pair: ScenePair): boolean {
  return pair.class === "fixed-axes";
}

/** All parts as they are drawn. */
export function atRest(scene: Scene): Placement[] {
  return scene.parts.map(() => IDENTITY);
}

/** The configuration of a pair whose parts are placed so. */
export function configurationOf(scene: Scene, pair: ScenePair, placements: readonly Placement[]): Configuration {
  const [f, m] = [placements[pair.fixed] ?? IDENTITY, placements[pair.moving] ?? IDENTITY];
  if (hasAxes(pair)) {
    const [fixed, moving] = [scene.parts[pair.fixed], scene.parts[pair.moving]];
    return { u: fixed ? coordinateOf(fixed.motion, f) : 0, v: moving ? coordinateOf(moving.motion, m) : 0 };
  }
  return relative(f, m);
}

/** Which of a pair's parts keeps its place where the configuration does not say both. */
export type Anchor = "fixed" | "moving";

/** The placements once the pair is in a configuration; joined parts go along, others stay. */
export function placed(
  scene: Scene,
  pair: ScenePair,
  placements: readonly Placement[],
  c: Configuration,
  anchor: Anchor = "fixed",
): Placement[] {
  const now = [...placements];
  const [fixed, moving] = [scene.parts[pair.fixed], scene.parts[pair.moving]];
  if (isAxes(c)) {
    if (fixed) now[pair.fixed] = ofMotion(fixed.motion, c.u);
    if (moving) now[pair.moving] = ofMotion(moving.motion, c.v);
  } else if (anchor === "fixed") {
    now[pair.moving] = compose(now[pair.fixed] ?? IDENTITY, c);
  } else {
    now[pair.fixed] = compose(now[pair.moving] ?? IDENTITY, relative(c, IDENTITY));
  }
  return followJoints(scene, placements, now, [pair.fixed, pair.moving]);
}

/** Takes along what is joined to parts that have moved, from joint to joint. */
export function followJoints(scene: Scene, before: readonly Placement[], now: readonly Placement[], given: readonly number[]): Placement[] {
  const result = [...now];
  const settled = new Set(given);
  const queue = [...given];
  for (let part = queue.shift(); part !== undefined; part = queue.shift()) {
    for (const joint of scene.joints) {
      const at = joint.parts.indexOf(part);
      const other = at < 0 ? undefined : joint.parts[1 - at];
      if (other === undefined || settled.has(other)) continue;
      settled.add(other);
      if (same(result[part], before[part])) continue;
      const to = follower(scene, joint, other, result[part] ?? IDENTITY, before[part] ?? IDENTITY, before[other] ?? IDENTITY);
      if (!to) continue;
      result[other] = to;
      queue.push(other);
    }
  }
  return result;
}

function same(a: Placement | undefined, b: Placement | undefined): boolean {
  return !!a && !!b && a.x === b.x && a.y === b.y && a.theta === b.theta;
}

/** Where a part goes whose partner at a joint has moved; null if it stays. */
function follower(scene: Scene, joint: SceneJoint, other: number, partner: Placement, partnerBefore: Placement, before: Placement): Placement | null {
  const motion = scene.parts[other]?.motion ?? { type: "fixed" };
  if (motion.type === "fixed") return null;
  if (joint.type === "revolute") return hinged(motion, joint.at, apply(partner, joint.at), before);
  if (joint.type === "prismatic" && motion.type === "planar") return compose(partner, relative(partnerBefore, before));
  return null;
}

/** A part whose point `at` is taken to `to` as well as its own motion allows. */
function hinged(motion: Scene["parts"][number]["motion"], at: Place, to: Place, before: Placement): Placement {
  switch (motion.type) {
    case "revolute": {
      const c = motion.center;
      const from = Math.atan2(at.y - c.y, at.x - c.x);
      const onAxis = at.x === c.x && at.y === c.y;
      return onAxis ? before : turnAbout(c, Math.atan2(to.y - c.y, to.x - c.x) - from);
    }
    case "prismatic": {
      const d = unit(motion.direction);
      return ofMotion(motion, (to.x - at.x) * d.x + (to.y - at.y) * d.y);
    }
    case "fixed":
      return IDENTITY;
    case "planar": {
      const r = rotate(at, before.theta);
      return { x: to.x - r.x, y: to.y - r.y, theta: before.theta };
    }
  }
}

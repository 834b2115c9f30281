/** Which free regions opened or closed when a space was computed again. */

import type { Configuration, Kernel } from "../kernel/api.js";
import type { ScenePair, SceneRegion } from "../scene.js";
import { regionNames } from "./region-names.js";

interface Regions {
  class: ScenePair["class"];
  regions: SceneRegion[];
  kernel: Pick<Kernel, "region">;
}

/** Regions are the same if a configuration known to be in one of them is in the other. */
export function regionChanges(before: Regions, after: Regions): string {
  const kept = new Set<number>();
  const known = new Set<number>();
  before.regions.forEach((region, i) => {
    const now = regionAt(after, region);
    if (now === null) return;
    kept.add(i);
    known.add(now);
  });
  after.regions.forEach((region, i) => {
    const was = regionAt(before, region);
    if (was === null) return;
    kept.add(was);
    known.add(i);
  });
  // A free region alone that has moved away from all that is known of it is no other.
  if (before.regions.length === 1 && after.regions.length === 1) return "";
  const closed = before.regions.flatMap((_, i) => (kept.has(i) ? [] : [i]));
  const opened = after.regions.flatMap((_, i) => (known.has(i) ? [] : [i]));
  const said: string[] = [];
  if (closed.length > 0) said.push(`${regionNames(before, closed)} closed`);
  if (opened.length > 0) said.push(`${regionNames(after, opened)} opened`);
  if (said.length === 0 && before.regions.length > after.regions.length) said.push("regions joined");
  if (said.length === 0 && before.regions.length < after.regions.length) said.push("a region was divided");
  return said.length > 0 ? `${said.join(", ")}: ${count(before)} before, ${count(after)} now` : "";
}

function regionAt({ kernel }: Regions, { sample: [a = 0, b = 0, c] }: SceneRegion): number | null {
  const at: Configuration = c === undefined ? { u: a, v: b } : { x: a, y: b, theta: c };
  return kernel.region(at);
}

function count({ regions }: Regions): string {
  return regions.length === 1 ? "1 region" : `${regions.length} regions`;
}

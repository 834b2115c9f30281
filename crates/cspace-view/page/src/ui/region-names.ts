/** What free regions are called: by what they are, with the numbers that the command gives them. */

import type { ScenePair } from "../scene.js";

/** `outside`, `pocket 1`; of a pair on fixed axes, where nothing is outside, `region 1`. */
export function regionName({ class: kind, regions }: Pick<ScenePair, "class" | "regions">, index: number): string {
  if (kind === "fixed-axes") return `region ${index}`;
  if (!regions[index]?.unbounded) return `pocket ${index}`;
  return regions.filter((r) => r.unbounded).length > 1 ? `outside ${index}` : "outside";
}

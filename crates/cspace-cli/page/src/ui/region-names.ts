/** What free regions are called: by what they are, with the numbers that the command gives them. */

import type { ScenePair } from "../scene.js";

/** `outside`, `pocket 1`; of a pair on fixed axes, where nothing is outside, `region 1`. */
export function regionName({ class: kind, regions }: Pick<ScenePair, "class" | "regions">, index: number): string {
  if (kind === "fixed-axes") return `region ${index}`;
  if (!regions[index]?.unbounded) return `pocket ${index}`;
  return regions.filter((r) => r.unbounded).length > 1 ? `outside ${index}` : "outside";
}

/** Several at once: `outside, pockets 1, 2`. */
export function regionNames(of: Pick<ScenePair, "class" | "regions">, indices: readonly number[]): string {
  const kind = of.class === "fixed-axes" ? "region" : "pocket";
  const isNumbered = (index: number) => of.class === "fixed-axes" || !of.regions[index]?.unbounded;
  const numbered = indices.filter(isNumbered);
  const named = indices.filter((index) => !isNumbered(index)).map((index) => regionName(of, index));
  if (numbered.length > 0) named.push(`${kind}${numbered.length > 1 ? "s" : ""} ${numbered.join(", ")}`);
  return named.join(", ");
}

/** The pair that is shown first: that of the model's `show`, or one that has something to tell. */

import type { Scene, ScenePair } from "../scene.js";
import { boxOf } from "./outline.js";

/** The model's; otherwise the first of those that matter most: joints have the least to show. */
export function firstPair(scene: Scene): number {
  if (scene.show.pair !== null) return scene.show.pair;
  let best = 0;
  let most = -Infinity;
  scene.pairs.forEach((pair, i) => {
    const weight = weightOf(scene, pair);
    if (weight > most) [most, best] = [weight, i];
  });
  return best;
}

/** Cages before contacts, parts that are drawn beside each other before those that are not, and pairs that never meet last but joints. */
function weightOf(scene: Scene, pair: ScenePair): number {
  if (pair.class === "lower") return -2;
  if (pair.error !== null || neverMeets(pair)) return -1;
  const caged = pair.class !== "fixed-axes" && pair.regions.some((r) => !r.unbounded);
  return (caged ? 2 : 0) + (areNear(scene, pair) ? 1 : 0);
}

/** Whether a space that is known has no contacts: no patches, and no pieces of curves. */
function neverMeets({ space }: ScenePair): boolean {
  return space !== null && /"(patches|pieces)":\[\]/.test(space);
}

/** Whether the boxes of both parts, as they are drawn, have a point in common. */
function areNear({ parts }: Scene, { fixed, moving }: ScenePair): boolean {
  const [a, b] = [boxOf(parts[fixed]?.loops ?? []), boxOf(parts[moving]?.loops ?? [])];
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

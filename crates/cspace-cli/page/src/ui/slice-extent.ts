/** The size of a slice, from what the parts are. */

import { boxOf } from "./outline.js";
import type { State } from "./state.js";

/**
 * How wide slices are, about (model unit): at one orientation, contacts put the moving part no farther away than both parts are large. The
 * bounds of all orientations are as wide as that only if the part is drawn near its origin, about which it turns.
 */
export function sliceExtent({ scene, parts, pair: index }: Pick<State, "scene" | "parts" | "pair">): number {
  const pair = scene.pairs[index];
  const sizeOf = (part: number) => {
    const box = boxOf(parts[part]?.loops ?? []);
    return Math.hypot(box.x1 - box.x0, box.y1 - box.y0);
  };
  return pair ? sizeOf(pair.fixed) + sizeOf(pair.moving) || 1 : 1;
}

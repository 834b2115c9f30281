/** Opens the configuration space of a pair of the scene. */

import type { AxesSpace, LowerSpace, PlanarSpace, Scene } from "../scene.js";
import type { Kernel } from "./api.js";
import type { AxesSpaceData } from "./axes/data.js";
import { AxesPair } from "./axes/kernel.js";
import { LowerPair } from "./lower.js";
import { PlanarPair } from "./planar/kernel.js";

/** A kernel of any class; null as long as the scene has no space of the pair. */
export function openPair(scene: Scene, pairIndex: number): Kernel | null {
  const pair = scene.pairs[pairIndex];
  const space = pair?.space;
  if (!pair || !space) return null;
  const named = (part: number) => scene.parts[part]?.feature_names ?? {};
  const names = { fixed: named(pair.fixed), moving: named(pair.moving) };
  switch (space.format) {
    case "contact-space":
      return new PlanarPair(pair, space as PlanarSpace, names) as unknown as Kernel;
    case "fixed-axes-space":
      return new AxesPair(pair, space as AxesSpace as unknown as AxesSpaceData, names) as unknown as Kernel;
    case "lower-pair":
      return new LowerPair(pair, space as LowerSpace) as unknown as Kernel;
    default:
      return null;
  }
}

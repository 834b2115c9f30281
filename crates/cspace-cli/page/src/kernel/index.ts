/** Opens the configuration space of a pair of the scene. */

import { Pair } from "../../build/kernel/cspace.js";
import type { Scene } from "../scene.js";
import type { Kernel } from "./api.js";
import { Axes, Planar, Lower } from "./pairs.js";

/** A kernel of any class; null as long as the scene has no space of the pair. The kernel is loaded before. */
export function openPair(scene: Scene, pairIndex: number): Kernel | null {
  const of = scene.pairs[pairIndex];
  if (!of?.space) return null;
  const pair = new Pair(of.space, of.own ?? false);
  switch (pair.class) {
    case "fixed-axes":
      return new Axes(pair) as unknown as Kernel;
    case "lower":
      return new Lower(pair) as unknown as Kernel;
    default:
      return new Planar(pair) as unknown as Kernel;
  }
}

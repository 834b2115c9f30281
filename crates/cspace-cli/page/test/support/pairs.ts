/** The pairs of the models that come with the project. */

import type { Kernel } from "../../src/kernel/api.js";
import { openPair } from "../../src/kernel/index.js";
import type { Scene, ScenePair } from "../../src/scene.js";
import { models } from "./command.js";
import { sceneOf } from "./scene.js";

export interface ModelPair {
  /** The model's file. */
  model: string;
  scene: Scene;
  pair: ScenePair;
  kernel: Kernel;
  /** As `--pair` takes them. */
  names: string;
}

/** All that are not joined. */
export function* modelPairs(): Generator<ModelPair> {
  for (const model of models()) {
    const scene = sceneOf(model);
    for (const [index, pair] of scene.pairs.entries()) {
      const kernel = openPair(scene, index);
      if (!kernel || kernel.class === "lower") continue;
      yield { model, scene, pair, kernel, names: `${scene.parts[pair.fixed]!.name},${scene.parts[pair.moving]!.name}` };
    }
  }
}

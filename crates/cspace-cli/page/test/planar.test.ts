/** The page's answers about planar pairs are those of the command. */

import assert from "node:assert/strict";
import { test } from "node:test";
import type { PlanarKernel } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { binary, models, NO_COMMAND } from "./support/command.js";
import { compare } from "./support/compare.js";
import { anywhere, atContact, atCritical } from "./support/places.js";
import { random } from "./support/random.js";
import { sceneOf } from "./support/scene.js";

const RANDOM = 1000;
const NEAR = 200;

test("planar pairs are classified as by the command", { skip: binary() ? false : NO_COMMAND }, async (t) => {
  for (const model of models()) {
    const scene = sceneOf(model);
    for (const [index, pair] of scene.pairs.entries()) {
      const kernel = openPair(scene, index);
      if (kernel?.coordinates !== "planar" || pair.class === "lower") continue;
      const planar = kernel as unknown as PlanarKernel;
      const names = `${scene.parts[pair.fixed]!.name},${scene.parts[pair.moving]!.name}`;
      await t.test(`${model.split("/models/")[1]} ${names}`, (t) => {
        const next = random(1);
        const all = Array.from({ length: RANDOM }, () => anywhere(planar, next));
        all.push(...atContact(planar, NEAR, next));
        assert.equal(all.length, RANDOM + NEAR);
        all.push(...atCritical(planar, NEAR, next));
        const wrong = compare(t, { model, names, kernel: planar, header: "x,y,theta" }, all, (c) => [c.x, c.y, c.theta]);
        assert.equal(wrong, 0);
      });
    }
  }
});

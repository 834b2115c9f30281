/** A part that is dragged goes as far as the surface leads: it does not stick where a small motion aside frees it. */

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Configuration, Kernel, PlanarConfiguration } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { binary, MODELS, models, NO_COMMAND } from "./support/command.js";
import { random } from "./support/random.js";
import { sceneOf } from "./support/scene.js";
import { weightedOf, type Weighted } from "./support/weighted.js";

const skip = binary() ? false : NO_COMMAND;

test("a peg goes to the seat along both walls of its hole", { skip }, () => {
  const kernel = openPair(sceneOf(join(MODELS, "peg_hole.toml")), 0)!;
  for (const theta of [0, 0.001, -0.002, 0.003, 0.005]) {
    for (const x of [-0.1, -0.05, 0.03, 0.05, 0.1]) {
      let at: Configuration = { x, y: 18.5, theta };
      if (kernel.classify(at) !== "free") continue;
      for (let k = 1; k <= 30; k++) at = kernel.slide(at, { x, y: 18.5 - 0.7 * k, theta }).at;
      const { y } = at as PlanarConfiguration;
      assert.ok(Math.abs(y) < 1e-3, `from x = ${x}, θ = ${theta} the peg comes to ${JSON.stringify(at)}`);
    }
  }
});

const DRAGS = 12;
const STEPS = 15;
const DIRECTIONS = 200;
/** How far aside it is tried (share of the pair's size). What is left to go is known to a thousandth of the whole way. */
const ASIDE = [1e-2, 1e-3];
const KNOWN = 1e-3;
/** How much nearer to the goal that may lead, as a share: less is what curved surfaces do at a second look. */
const GAIN = 0.25;

test("where a dragged part stays, no straight motion leads nearer", { skip }, async (t) => {
  for (const model of models()) {
    const scene = sceneOf(model);
    for (const [index, pair] of scene.pairs.entries()) {
      const kernel = openPair(scene, index);
      if (!kernel || kernel.class === "lower") continue;
      const names = `${scene.parts[pair.fixed]!.name},${scene.parts[pair.moving]!.name}`;
      await t.test(`${model.split("/models/")[1]} ${names}`, (t) => {
        const weighted = weightedOf(pair, kernel);
        const next = random(11);
        let held = 0;
        for (let k = 0; k < DRAGS; k++) {
          let from = weighted.anywhere(next);
          while (kernel.classify(from) !== "free") from = weighted.anywhere(next);
          const goal = weighted.within(weighted.anywhere(next));
          const at = dragged(kernel, weighted, from, goal);
          if (kernel.classify(at) !== "contact") continue;
          held++;
          const free = nearer(kernel, weighted, at, goal, next);
          assert.equal(free, null, `from ${JSON.stringify(from)} to ${JSON.stringify(goal)} it sticks at ${JSON.stringify(at)}: ${free}`);
        }
        t.diagnostic(`${held} of ${DRAGS} held by contacts`);
      });
    }
  }
});

function dragged(kernel: Kernel, weighted: Weighted, from: Configuration, goal: Configuration): Configuration {
  let at = from;
  const g = weighted.vector(goal);
  for (let i = 1; i <= STEPS; i++) {
    const a = weighted.vector(at);
    at = kernel.slide(at, weighted.configuration(a.map((x, k) => x + (g[k]! - x) / (STEPS + 1 - i)))).at;
  }
  for (let i = 0; i < 8; i++) at = kernel.slide(at, goal).at;
  return at;
}

/** A free configuration that a straight motion leads to, nearer to the goal; null if none is found. */
function nearer(kernel: Kernel, weighted: Weighted, at: Configuration, goal: Configuration, next: () => number): string | null {
  const a = weighted.vector(at);
  const g = weighted.vector(goal);
  const distance = (v: number[]) => Math.hypot(...v.map((x, i) => x - g[i]!));
  const away = distance(a);
  for (const size of ASIDE) {
    if (size > away || size < 2 * KNOWN * away) continue;
    for (let k = 0; k < DIRECTIONS; k++) {
      const normal = () => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
      const d = weighted.moves.map((moves) => (moves ? normal() : 0));
      const long = Math.hypot(...d);
      const to = weighted.configuration(a.map((x, i) => x + (d[i]! / long) * size));
      if (away - distance(weighted.vector(to)) < GAIN * size) continue;
      const motion = kernel.advance(at, to);
      if (motion.stopped === null && kernel.classify(to) === "free") return `${JSON.stringify(to)} is free`;
    }
  }
  return null;
}

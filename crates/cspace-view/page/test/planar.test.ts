/** The page's answers about planar pairs are those of the command. */

import assert from "node:assert/strict";
import { test } from "node:test";
import type { PlanarConfiguration, PlanarKernel } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { binary, models, NO_COMMAND } from "./support/command.js";
import { compare } from "./support/compare.js";
import { random } from "./support/random.js";
import { sceneOf } from "./support/scene.js";

const RANDOM = 1000;
const NEAR = 200;

/** Configurations of the whole window, as far as contacts reach and a little farther. */
function anywhere(kernel: PlanarKernel, next: () => number): PlanarConfiguration {
  const { lo, hi } = kernel.bounds();
  const along = (a: number, b: number) => a - 0.1 * (b - a) + 1.2 * (b - a) * next();
  const { lo: first, hi: last, fullTurn } = kernel.window;
  const turns = fullTurn ? Math.floor(5 * next()) - 2 : 0;
  return {
    x: along(lo[0], hi[0]),
    y: along(lo[1], hi[1]),
    theta: first + (last - first) * next() + turns * 2 * Math.PI,
  };
}

/** A configuration of a contact patch, moved along its normal by 1e-6 of the size at most, or not at all. */
function atContact(kernel: PlanarKernel, size: number, next: () => number): PlanarConfiguration | null {
  const patch = Math.floor(next() * kernel.patchCount);
  const [lo, hi] = kernel.patch(patch).orientations!;
  const theta = lo + (hi - lo) * next();
  const curve = kernel.slice(theta, size * 1e-4).find((c) => c.patch === patch);
  if (!curve) return null;
  const n = curve.points.length / 2 - 1;
  const k = Math.floor(next() * (n + 1));
  const [x, y] = [curve.points[2 * k]!, curve.points[2 * k + 1]!];
  const touch = kernel.touching({ x, y, theta }, size * 1e-6)[0];
  if (!touch) return null;
  // From a millionth of the size down to below what counts as contact, on either side; and none.
  const by = size * [0, 1, -1][Math.floor(3 * next())]! * 10 ** (-6 - 8 * next());
  return { x: x + touch.normal[0] * by, y: y + touch.normal[1] * by, theta };
}

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
        const { lo, hi } = planar.bounds();
        const size = Math.hypot(hi[0] - lo[0], hi[1] - lo[1]);
        const all = Array.from({ length: RANDOM }, () => anywhere(planar, next));
        for (let k = 0, tries = 0; k < NEAR && tries < 50 * NEAR && planar.patchCount > 0; tries++) {
          const c = atContact(planar, size, next);
          if (c) {
            all.push(c);
            k++;
          }
        }
        const wrong = compare(t, { model, names, kernel: planar, header: "x,y,theta" }, all, (c) => [c.x, c.y, c.theta]);
        assert.equal(wrong, 0);
      });
    }
  }
});

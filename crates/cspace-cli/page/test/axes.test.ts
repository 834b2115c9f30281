/** The page's answers about pairs on fixed axes, and about lower pairs, are those of the command. */

import assert from "node:assert/strict";
import { test } from "node:test";
import type { AxesConfiguration, AxesKernel, AxisInfo, PlanarConfiguration } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { binary, models, NO_COMMAND } from "./support/command.js";
import { compare } from "./support/compare.js";
import { random } from "./support/random.js";
import { sceneOf } from "./support/scene.js";

const RANDOM = 1000;
const NEAR = 200;

function along(axis: AxisInfo, next: () => number): number {
  if (axis.kind === "still") return 0;
  const turns = axis.round ? (Math.floor(3 * next()) - 1) * 2 * Math.PI : 0;
  return axis.lo + (axis.hi - axis.lo) * next() + turns;
}

/** Points of contact curves, moved along u and v by a millionth and less, or not at all. */
function atContact(kernel: AxesKernel, count: number, next: () => number): AxesConfiguration[] {
  const curves = kernel.curves(1e-3);
  const found: AxesConfiguration[] = [];
  for (let tries = 0; found.length < count && tries < 50 * count && curves.length > 0; tries++) {
    const { points } = curves[Math.floor(next() * curves.length)]!;
    const k = Math.floor((next() * points.length) / 2);
    const by = [0, 1, -1][Math.floor(3 * next())]! * 10 ** (-6 - 8 * next());
    const moved = next() < 0.5;
    const size = (axis: AxisInfo) => (axis.kind === "length" ? axis.hi - axis.lo : 1);
    const u = kernel.u.kind === "still" ? 0 : points[2 * k]! + (moved ? by * size(kernel.u) : 0);
    const v = kernel.v.kind === "still" ? 0 : points[2 * k + 1]! + (moved ? 0 : by * size(kernel.v));
    if (kernel.classify({ u, v }) !== null) found.push({ u, v });
  }
  return found;
}

test("pairs on fixed axes are classified as by the command", { skip: binary() ? false : NO_COMMAND }, async (t) => {
  for (const model of models()) {
    const scene = sceneOf(model);
    for (const [index, pair] of scene.pairs.entries()) {
      const kernel = openPair(scene, index);
      if (kernel?.coordinates !== "axes") continue;
      const axes = kernel as unknown as AxesKernel;
      const names = `${scene.parts[pair.fixed]!.name},${scene.parts[pair.moving]!.name}`;
      await t.test(`${model.split("/models/")[1]} ${names}`, (t) => {
        const next = random(2);
        const all = Array.from({ length: RANDOM }, () => ({ u: along(axes.u, next), v: along(axes.v, next) }));
        all.push(...atContact(axes, NEAR, next));
        const wrong = compare(t, { model, names, kernel: axes, header: "u,v" }, all, (c) => [c.u, c.v]);
        assert.equal(wrong, 0);
      });
    }
  }
});

test("lower pairs are classified as by the command", { skip: binary() ? false : NO_COMMAND }, async (t) => {
  for (const model of models()) {
    const scene = sceneOf(model);
    for (const [index, pair] of scene.pairs.entries()) {
      const kernel = openPair(scene, index);
      if (kernel?.class !== "lower") continue;
      const names = `${scene.parts[pair.fixed]!.name},${scene.parts[pair.moving]!.name}`;
      await t.test(`${model.split("/models/")[1]} ${names}`, (t) => {
        const next = random(3);
        const all: PlanarConfiguration[] = Array.from({ length: 200 }, () => {
          const asked = { x: 40 * next() - 20, y: 40 * next() - 20, theta: 8 * next() - 4 };
          const on = kernel.advance(asked, asked).at as PlanarConfiguration;
          const by = [0, 0, 1, -1][Math.floor(4 * next())]! * 10 ** (-6 - 8 * next());
          return { x: on.x + by, y: on.y, theta: on.theta };
        });
        const wrong = compare(t, { model, names, kernel: kernel as never, header: "x,y,theta" }, all, (c) => [c.x, c.y, c.theta], ["class"]);
        assert.equal(wrong, 0);
      });
    }
  }
});

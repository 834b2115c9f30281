/** Pairs that are hard on numbers: exact fits, arcs almost straight, windows, and parts drawn far from their origins. */

import assert from "node:assert/strict";
import { test } from "node:test";
import type { AxesKernel, PlanarConfiguration, PlanarKernel } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { binary, NO_COMMAND } from "./support/command.js";
import { compare } from "./support/compare.js";
import { anywhere, atContact, atCritical } from "./support/places.js";
import { random } from "./support/random.js";
import { classified } from "./support/rows.js";
import { sceneOf, withModel } from "./support/scene.js";

function loop(points: number[][], by: [number, number] = [0, 0]): string {
  return `[${points.map(([x, y, b]) => `[${x! + by[0]}, ${y! + by[1]}, ${b ?? 0}]`).join(", ")}]`;
}

function model(parts: [string, string][], more = ""): string {
  return ["name = \"made up\"", ...parts.map(([name, loops]) => `[[part]]\nname = "${name}"\nloops = [${loops}]`), more].join("\n");
}

const rectangle = (w: number, h: number) => [[-w, -h], [w, -h], [w, h], [-w, h]];
const slot = (w: number) => [[-20, 10], [-20, -20], [20, -20], [20, 10], [w, 10], [w, -10], [-w, -10], [-w, 10]];

const CASES: Record<string, string> = {
  "a peg of the hole's size": model([["block", loop(slot(5))], ["peg", loop(rectangle(5, 8))]]),
  "a round peg of the hole's size": model([
    ["block", `${loop(rectangle(20, 20))}, ${loop([[-5, 0, 1], [5, 0, 1]])}`],
    ["peg", loop([[-5, 0, 1], [5, 0, 1]])],
  ]),
  "a peg with a millionth of play": model([["block", loop(slot(5))], ["peg", loop(rectangle(4.999999, 8))]]),
  "arcs almost straight": model([
    ["lens", loop([[-10, -1, 0.0008], [10, -1, 0.001], [10, 1, 0.0005], [-10, 1, -0.0012]])],
    ["dish", loop([[-6, -2, 0.0003], [6, -2, 0.3], [6, 2, -0.0007], [-6, 2, 0.2]])],
  ]),
  "parts drawn a million away": model([
    ["block", loop(slot(6), [1e6, -2e6])],
    ["peg", loop([[-5, -8], [5, -8, 0.3], [5, 8], [-5, 8, 0.1]], [-1.5e6, 1e6])],
  ]),
  "a window": model([["block", loop(slot(6))], ["peg", loop(rectangle(5, 8))]], '[[pair]]\nfixed = "block"\nmoving = "peg"\ntheta = ["-10deg", "25deg"]'),
  "a window beyond half a turn": model([["block", loop(slot(6))], ["peg", loop([[-5, -8], [5, -8, 0.3], [5, 8], [-5, 8, 0.1]])]], '[[pair]]\nfixed = "block"\nmoving = "peg"\ntheta = ["170deg", "260deg"]'),
};

const skip = binary() ? false : NO_COMMAND;

for (const [name, text] of Object.entries(CASES)) {
  test(`${name}: answers and motions are those of the command`, { skip }, (t) => {
    withModel(text, (path) => {
      const scene = sceneOf(path);
      const pair = scene.pairs[0]!;
      const kernel = openPair(scene, 0) as unknown as PlanarKernel;
      const names = `${scene.parts[pair.fixed]!.name},${scene.parts[pair.moving]!.name}`;
      const next = random(7);
      const all: PlanarConfiguration[] = Array.from({ length: 600 }, () => anywhere(kernel, next));
      // Where the command sees them: about the middle, all but aligned.
      for (let k = 0; k < 100; k++) {
        const [c] = atContact(kernel, 1, next);
        if (c) all.push(c);
        const small = 10 ** (-4 - 10 * next());
        if (!name.includes("million away") && !name.includes("beyond")) all.push({ x: (next() - 0.5) * small, y: (next() - 0.5) * 4, theta: (next() - 0.5) * small });
      }
      all.push(...atCritical(kernel, 100, next));
      const wrong = compare(t, { model: path, names, kernel, header: "x,y,theta" }, all, (c) => [c.x, c.y, c.theta]);
      const reached: PlanarConfiguration[] = [];
      for (let k = 0; k < 40; k++) {
        let at = all[Math.floor(next() * 600)]!;
        if (kernel.classify(at) !== "free") continue;
        const goal = anywhere(kernel, next);
        for (let i = 1; i <= 10; i++) {
          const part = 1 / (11 - i);
          const to = { x: at.x + part * (goal.x - at.x), y: at.y + part * (goal.y - at.y), theta: at.theta + part * (goal.theta - at.theta) };
          at = kernel.slide(at, to).at;
          reached.push(at);
        }
      }
      const told = classified(path, names, reached.map((c) => [c.x, c.y, c.theta]), "x,y,theta", ["class"]);
      const blocked = told.filter((c) => c.class === "blocked").length;
      t.diagnostic(`${reached.length} slides, ${blocked} blocked`);
      assert.equal(wrong, 0);
      assert.equal(blocked, 0);
      assert.ok(reached.length > 0);
    });
  });
}

test("features are called by the names of the model", { skip }, () => {
  const block = `${loop(slot(6))}]\nnames = { "line 5 of loop 0" = "floor" }\n#`;
  withModel(model([["block", block], ["peg", loop(rectangle(5, 8))]]), (path) => {
    const scene = sceneOf(path);
    const kernel = openPair(scene, 0) as unknown as PlanarKernel;
    const touch = kernel.touching({ x: 0, y: -2, theta: 0 }).map((x) => x.fixed);
    assert.ok(touch.includes("floor"), touch.join());
  });
});

test("slides along one line without limits, and a part that does not move", { skip }, (t) => {
  const motion = (type: string) => `motion = ${type}`;
  const text = [
    'name = "sliders"',
    `[[part]]\nname = "a"\nloops = [${loop(rectangle(3, 2))}]\n${motion('{ type = "prismatic", direction = [1, 0.5] }')}`,
    `[[part]]\nname = "b"\nloops = [${loop(rectangle(2, 3), [10, 4])}]\n${motion('{ type = "prismatic", direction = [1, 0.5] }')}`,
    `[[part]]\nname = "c"\nloops = [${loop(rectangle(2, 3), [-10, 1])}]\n${motion('{ type = "fixed" }')}`,
  ].join("\n");
  withModel(text, (path) => {
    const scene = sceneOf(path);
    let wrong = 0;
    scene.pairs.forEach((pair, i) => {
      const kernel = openPair(scene, i) as unknown as AxesKernel;
      const names = `${scene.parts[pair.fixed]!.name},${scene.parts[pair.moving]!.name}`;
      const next = random(8);
      const along = (still: boolean) => (still ? 0 : 40 * (next() - 0.5));
      const all = Array.from({ length: 300 }, () => ({ u: along(kernel.u.kind === "still"), v: along(kernel.v.kind === "still") }));
      const slid = all.filter((c) => kernel.classify(c) === "free").map((c, k) => kernel.slide(c, all[(k * 7) % all.length]!).at);
      wrong += compare(t, { model: path, names, kernel, header: "u,v" }, [...all, ...slid], (c) => [c.u, c.v]);
      assert.ok(slid.every((c) => kernel.classify(c) !== "blocked"));
    });
    assert.equal(wrong, 0);
  });
});

/** A part that is dragged goes as far as the surface leads: it does not stick where a small motion aside frees it. */

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Configuration, Kernel, PlanarConfiguration } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { binary, MODELS, NO_COMMAND, times } from "./support/command.js";
import { modelPairs } from "./support/pairs.js";
import { random } from "./support/random.js";
import { sceneOf, withModel } from "./support/scene.js";
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

const DRAGS = times(12, 4);
const STEPS = 15;
const DIRECTIONS = 200;
/** How far aside it is tried (share of the pair's size). What is left to go is known to a thousandth of the whole way. */
const ASIDE = [1e-2, 1e-3];
const KNOWN = 1e-3;
/** How much nearer to the goal that may lead, as a share: less is what curved surfaces do at a second look. */
const GAIN = 0.25;

test("where a dragged part stays, no straight motion leads nearer", { skip }, async (t) => {
  for (const { model, pair, kernel, names } of modelPairs()) {
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

/** Where parts stuck once: the model, where they are, and where they are dragged. */
const PLACES: [string, string, PlanarConfiguration, PlanarConfiguration][] = [
  [
    "contacts that are tangent part from there on",
    "paper/tibia_femur.toml",
    { x: 0, y: 0, theta: 0 },
    { x: -4.112733816545131, y: -120.23114144914875, theta: -3.0497707724275527 },
  ],
  [
    "a second contact is all but come to",
    "fixture_plate.toml",
    { x: 54.50849445161337, y: 52.60416873526535, theta: -2.896024027964216 },
    { x: 52.469827503252844, y: -97.78439262953671, theta: -2.896024027964216 },
  ],
  [
    "a second contact is all but come to, across the first",
    "paper/film_advance.toml",
    { x: 33.45325665448284, y: 9.042019657675096, theta: 0.8021779454187049 },
    { x: 26.02987124628295, y: 37.717730513952766, theta: 1.6997875565296994 },
  ],
  [
    "the lift off a curved surface is stopped from above",
    "paper/fixture.toml",
    { x: 0, y: 0, theta: 0 },
    { x: 134.97103415420895, y: 16.506326595579438, theta: -0.33983063183468154 },
  ],
  [
    "the lift off a curved surface is stopped from above",
    "paper/blocks.toml",
    { x: 0, y: 0, theta: 0 },
    { x: 49.43096752877977, y: 54.005445610993306, theta: -2.4243809460653147 },
  ],
  [
    "a surface that is all but tangent to another rises above it",
    "paper/geneva.toml",
    { x: -36.22342986751883, y: -42.71225125911961, theta: 0.8978422045852895 },
    { x: 18.33453787099279, y: -66.67310234693451, theta: 1.9611431510621253 },
  ],
];

test("a part leaves places where contacts all but meet", { skip }, async (t) => {
  for (const [why, model, from, goal] of PLACES) {
    await t.test(`${model}: ${why}`, () => {
      const scene = sceneOf(join(MODELS, model));
      const kernel = openPair(scene, 0)!;
      const weighted = weightedOf(scene.pairs[0]!, kernel);
      const away = (c: Configuration) => {
        const g = weighted.vector(goal);
        return Math.hypot(...weighted.vector(c).map((x, i) => x - g[i]!));
      };
      const { at } = kernel.slide(from, goal);
      assert.ok(away(from) - away(at) > 0.01, `it stays at ${JSON.stringify(at)}`);
    });
  }
});

test("a seated peg that is dragged up comes out, whichever way it drifts", { skip }, () => {
  const kernel = openPair(sceneOf(join(MODELS, "peg_hole.toml")), 0)!;
  for (const turns of [false, true]) {
    for (const drift of [-20, -3, -1, -0.3, -0.05, 0, 0.05, 0.3, 1, 3, 20]) {
      let at: PlanarConfiguration = { x: 0, y: 0, theta: 0 };
      for (let k = 1; k <= 20; k++) {
        at = kernel.slide(at, { x: (drift * k) / 20, y: 0.75 * k, theta: turns ? at.theta : 0 }).at as PlanarConfiguration;
        assert.ok(at.y > 0.75 * k - 1e-2, `drifting by ${drift} it is at ${JSON.stringify(at)} after ${k} moves`);
      }
    }
  }
});

/** A slot 2 wide and 6 deep, and a peg 1.8 wide: its end is the origin, and its centre is far from it. */
const SLOT = `
name = "slot"
unit = "mm"
[[part]]
name = "block"
loops = [[[-6, 0], [-1, 0], [-1, -6], [1, -6], [1, 0], [6, 0], [6, -10], [-6, -10]]]
[[part]]
name = "peg"
loops = [[[-0.9, 0], [0.9, 0], [0.9, 16], [-0.9, 16]]]
[[pair]]
fixed = "block"
moving = "peg"
theta = ["-20deg", "20deg"]
`;

test("a peg that is dragged into a slot comes to where it is dragged and not past it", { skip }, () => {
  const kernel = openPair(withModel(SLOT, sceneOf), 0)!;
  for (const follows of [false, true]) {
    for (const x of [-0.2, -0.05, 0, 0.05, 0.2]) {
      let at: PlanarConfiguration = { x: 0, y: 2, theta: 0.1 };
      const goal = (k: number) => ({ x: (x * k) / 20, y: 2 - (7.5 * k) / 20, theta: follows ? at.theta : 0 });
      for (let k = 1; k <= 20; k++) at = kernel.slide(at, goal(k)).at as PlanarConfiguration;
      for (let k = 0; k < 5; k++) at = kernel.slide(at, goal(20)).at as PlanarConfiguration;
      // Aslant it is nearest to the goal a little above: its end and its centre are not wanted at the same height.
      assert.ok(Math.abs(at.y + 5.5) < 5e-2, `dragged to x = ${x} it is at ${JSON.stringify(at)}`);
    }
  }
});

test("no motion leads on from where free space ends with the contacts' last orientation", { skip }, () => {
  const kernel = openPair(sceneOf(join(MODELS, "woodpecker.toml")), 0)!;
  const from = { x: -5.902403010793478e-10, y: -191.72610898199846, theta: -0.10090092466986937 };
  const to = { x: 14.458785622461338, y: -187.38461066126945, theta: -2.551010188177715 };
  const middle = { x: 0.5 * (from.x + to.x), y: 0.5 * (from.y + to.y), theta: 0.5 * (from.theta + to.theta) };
  assert.equal(kernel.classify(middle), "blocked");
  const { at, stopped } = kernel.advance(from, to);
  assert.notEqual(stopped, null);
  assert.ok(Math.abs((at as PlanarConfiguration).theta - from.theta) < 1e-6, JSON.stringify(at));
});

/** What the page says of configurations is what the command says, on the pairs of models that ship with the project. */

import assert from "node:assert/strict";
import { relative } from "node:path";
import { after, before, describe, it } from "node:test";
import type { Browser, Page } from "puppeteer-core";
import type { Scene, ScenePair, ScenePart } from "../../src/scene.js";
import { addressOf, colours, exported, launch, open, pictureOf, root, scratch, shown, skip } from "../../tools/harness.js";
import { run } from "../support/command.js";
import { random } from "../support/random.js";

const RANDOM = 1000;
const NEAR = 200;
/** How near to contact the near ones are (model unit or radians, as far as they go through a step of a bisection). */
const BESIDE = 1e-6;

type Numbers = number[];

describe("the page agrees with the command", { skip }, () => {
  const folder = scratch();
  let browser: Browser;
  before(async () => {
    browser = await launch(folder.path);
  });
  after(async () => {
    await browser?.close();
    folder.remove();
  });

  for (const model of shown()) {
    const name = relative(root, model);
    it(name, async (t) => {
      const { page, faults } = await open(browser, `${addressOf(exported(model, folder.path))}#view=space`);
      const scene = await page.evaluate(() => {
        const text = document.getElementById("scene")?.textContent ?? "null";
        return JSON.parse(text) as Scene;
      });
      for (const pair of scene.pairs.filter((p) => p.class !== "lower" && p.error === null)) {
        t.diagnostic(await agree(page, scene, pair, model));
        const pane = pair.class === "fixed-axes" ? "#plane" : "#space canvas";
        assert.ok(colours(await pictureOf(page, pane)) > (pair.class === "fixed-axes" ? 5 : 20), `${pane} is blank`);
      }
      assert.deepEqual(faults, []);
      await page.close();
    });
  }
});

/** Asks both of the same configurations. */
async function agree(page: Page, scene: Scene, pair: ScenePair, model: string): Promise<string> {
  const [fixed, moving] = [scene.parts[pair.fixed], scene.parts[pair.moving]];
  assert.ok(fixed !== undefined && moving !== undefined);
  const names: [string, string] = [fixed.name, moving.name];
  await page.evaluate(([f, m]) => window.cspace.select(f, m), names);
  assert.deepEqual(await page.evaluate(() => window.cspace.pair()), names);

  const axes = pair.class === "fixed-axes";
  const next = random(names.join().length + scene.parts.length);
  const draw = axes ? axesWithin(fixed, moving, next) : planarWithin(pair, fixed, moving, next);
  const asked: Numbers[] = Array.from({ length: RANDOM }, draw);
  asked.push(...(await besideContact(page, asked, axes)));

  const said = await classified(page, asked, axes);
  const rows = asked.map((c) => c.map((x) => String(x)).join(",")).join("\n");
  const header = axes ? "u,v" : "x,y,theta";
  const told = run(["classify", model, "--pair", names.join(",")], `${header}\n${rows}\n`)
    .trim()
    .split("\n")
    .slice(1)
    .map((row) => row.split(",").at(-1) ?? "");
  assert.equal(told.length, said.length);
  const wrong = asked.map((c, i) => ({ c, said: said[i], told: told[i] })).filter((row) => row.said !== row.told);
  assert.deepEqual(wrong.slice(0, 5), [], `${wrong.length} of ${asked.length} configurations of ${names.join()}`);
  const count = (what: string): string => `${told.filter((is) => is === what).length} ${what}`;
  return `${names.join()}: ${["free", "blocked", "contact"].map(count).join(", ")}`;
}

/** What the page says of each. */
function classified(page: Page, asked: Numbers[], axes: boolean): Promise<string[]> {
  return page.evaluate(
    (all, onAxes) =>
      all.map(([a = 0, b = 0, c = 0]) =>
        window.cspace.classify(onAxes ? { u: a, v: b } : { x: a, y: b, theta: c }),
      ),
    asked,
    axes,
  );
}

/** Configurations within {@link BESIDE} of contact: the way between one that is free and one that is blocked is halved. */
function besideContact(page: Page, among: Numbers[], axes: boolean): Promise<Numbers[]> {
  return page.evaluate(
    (all, onAxes, most, beside) => {
      const classify = ([a = 0, b = 0, c = 0]: number[]): string =>
        window.cspace.classify(onAxes ? { u: a, v: b } : { x: a, y: b, theta: c });
      const free = all.filter((c) => classify(c) === "free");
      const blocked = all.filter((c) => classify(c) === "blocked");
      const found: number[][] = [];
      for (let k = 0; k < most && free.length > 0 && blocked.length > 0; k++) {
        let lo = free[k % free.length] ?? [];
        let hi = blocked[(k * 7) % blocked.length] ?? [];
        const between = (s: number): number[] => lo.map((x, i) => x + s * ((hi[i] ?? 0) - x));
        // Some end all but on the contact, others a little beside it.
        // Nearer than that the last bits of sines decide, which are the browser's own.
        const enough = k % 2 === 0 ? beside : beside * 1e-4;
        while (Math.hypot(...lo.map((x, i) => x - (hi[i] ?? 0))) > enough) {
          const middle = between(0.5);
          if (middle.every((x, i) => x === lo[i] || x === hi[i])) {
            break;
          }
          if (classify(middle) === "blocked") {
            hi = middle;
          } else {
            lo = middle;
          }
        }
        found.push(k % 4 < 2 ? lo : hi);
      }
      return found;
    },
    among,
    axes,
    NEAR,
    BESIDE,
  );
}

/** Of a pair in the plane: positions at which the parts' boxes may meet, and some farther away. */
function planarWithin(pair: ScenePair, fixed: ScenePart, moving: ScenePart, next: () => number): () => Numbers {
  const { window } = JSON.parse(pair.space!) as { window: { lo: number; hi: number } };
  const [a, b] = [circle(fixed), circle(moving)];
  const reach = 1.1 * (a.radius + b.radius);
  return () => {
    const theta = window.lo + next() * (window.hi - window.lo);
    const [cos, sin] = [Math.cos(theta), Math.sin(theta)];
    const x = a.x + (2 * next() - 1) * reach - (cos * b.x - sin * b.y);
    const y = a.y + (2 * next() - 1) * reach - (sin * b.x + cos * b.y);
    return [x, y, theta];
  };
}

/** Of a pair with fixed axes: motions within their ranges, or a turn, or as far as the parts are large. */
function axesWithin(fixed: ScenePart, moving: ScenePart, next: () => number): () => Numbers {
  const reach = circle(fixed).radius + circle(moving).radius;
  const range = ({ motion }: ScenePart): [number, number] => {
    switch (motion.type) {
      case "revolute":
        return motion.range ?? [-Math.PI, Math.PI];
      case "prismatic":
        return motion.range ?? [-reach, reach];
      default:
        return [0, 0];
    }
  };
  const ranges = [range(fixed), range(moving)];
  return () => ranges.map(([lo, hi]) => lo + next() * (hi - lo));
}

/** A circle around a part. */
function circle(part: ScenePart): { x: number; y: number; radius: number } {
  const all = part.loops.flat();
  const x = all.reduce((sum, v) => sum + v.x, 0) / all.length;
  const y = all.reduce((sum, v) => sum + v.y, 0) / all.length;
  return { x, y, radius: Math.max(...all.map((v) => Math.hypot(v.x - x, v.y - y))) };
}

/** What the page says is nearest, and what touches where a part has slid to, is what `cspace play` says there. */

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Configuration, Kernel, Touch } from "../src/kernel/api.js";
import { binary, NO_COMMAND, run, times } from "./support/command.js";
import { modelPairs } from "./support/pairs.js";
import { random } from "./support/random.js";
import { inFolder } from "./support/scene.js";
import { weightedOf, type Weighted } from "./support/weighted.js";

const skip = binary() ? false : NO_COMMAND;

/** What `cspace play` prints. */
interface Answer {
  clearance: number;
  near: { features: [string, string]; distance: number }[];
}

interface Subject {
  title: string;
  kernel: Kernel;
  weighted: Weighted;
  /** What counts as contact where the page says what touches (model unit). */
  contact: number;
  answer(c: Configuration, within: number): Answer;
}

/** All pairs that are not joined; the command reads the saved space, so that it is not computed for every question. */
function eachPair(use: (s: Subject) => void): void {
  for (const { model, pair, kernel, names } of modelPairs()) {
    inFolder((folder) => {
      const space = join(folder, "space.json");
      run(["export", model, "--pair", names, "-o", space, "-q"]);
      const answer = (c: Configuration, within: number): Answer => {
        const at = "u" in c ? [c.u, c.v] : [c.x, c.y, c.theta];
        const out = run(["play", space, `--at=${at.join(",")}`, "--touch", String(within), "--json"]);
        return (JSON.parse(out) as { pairs: [Answer] }).pairs[0];
      };
      const contact = Math.max(pair.contact_distance, pair.resolution);
      use({ title: `${model.split("/models/")[1]} ${names}`, kernel, weighted: weightedOf(pair, kernel), contact, answer });
    });
  }
}

function freeOne({ kernel, weighted }: Subject, next: () => number): Configuration {
  for (;;) {
    const c = weighted.anywhere(next);
    if (kernel.classify(c) === "free") return c;
  }
}

/** Parts that are apart in all of so many configurations never meet. */
const TRIED = 400;

const text = (t: Touch) => `${t.fixed}|${t.moving}`;

test("the nearest features are those that cspace play lists first, and as far apart as the parts", { skip }, async (t) => {
  const all: Promise<void>[] = [];
  eachPair((s) => {
    const next = random(8);
    const wrong: string[] = [];
    for (let k = 0; k < times(5, 2); k++) {
      const c = freeOne(s, next);
      const mine = s.kernel.nearest(c)!;
      const known = 1e-9 * (mine.distance + 1);
      const { clearance, near } = s.answer(c, mine.distance + known);
      const same = Math.abs(mine.distance - clearance) <= known && near.some((x) => x.features.join("|") === text(mine));
      if (!same) wrong.push(`${JSON.stringify(c)}: ${JSON.stringify(mine)}, not ${clearance} and ${JSON.stringify(near)}`);
    }
    all.push(t.test(s.title, () => assert.deepEqual(wrong, [])));
  });
  await Promise.all(all);
});

test("where a part has slid to, what touches is what cspace play says", { skip }, async (t) => {
  const all: Promise<void>[] = [];
  eachPair((s) => {
    const next = random(9);
    const wrong: string[] = [];
    let [asked, several] = [0, 0];
    for (let k = 0; k < 40 && asked < times(6, 2); k++) {
      const from = freeOne(s, next);
      const goal = s.weighted.within(s.weighted.anywhere(next));
      let at = from;
      for (let i = 0; i < 4; i++) at = s.kernel.slide(at, goal).at;
      if (s.kernel.classify(at) !== "contact") continue;
      asked++;
      const mine = s.kernel.touching(at, s.contact);
      const told = s.answer(at, s.contact).near;
      if (told.length > 1) several++;
      const [a, b] = [mine.map(text).sort(), told.map((x) => x.features.join("|")).sort()];
      if (a.join(";") !== b.join(";") || a.length === 0) wrong.push(`${JSON.stringify(at)}: ${a.join("; ")}, not ${b.join("; ")}`);
    }
    // Of parts that never meet there is nothing to ask.
    const meets = Array.from({ length: TRIED }).some(() => s.kernel.classify(s.weighted.anywhere(next)) !== "free");
    all.push(
      t.test(s.title, (t) => {
        t.diagnostic(`${asked} asked, ${several} with several contacts`);
        assert.ok(asked > 0 || !meets);
        assert.deepEqual(wrong, []);
      }),
    );
  });
  await Promise.all(all);
});

/** Motions up to contact and along it: against `cspace play --by`, and never into blocked space. */

import assert from "node:assert/strict";
import { test, type TestContext } from "node:test";
import type { AxesConfiguration, AxesKernel, Configuration, Kernel, PlanarConfiguration, PlanarKernel } from "../src/kernel/api.js";
import { binary, NO_COMMAND, run, times } from "./support/command.js";
import { modelPairs } from "./support/pairs.js";
import { random } from "./support/random.js";
import { classified } from "./support/rows.js";

interface Pair {
  model: string;
  names: string;
  kernel: Kernel;
  header: string;
  numbers(c: Configuration): number[];
  anywhere(next: () => number): Configuration;
}

function* pairs(): Generator<Pair> {
  for (const { model, kernel, names } of modelPairs()) {
    if (kernel.coordinates === "axes") {
      const { u, v } = kernel as unknown as AxesKernel;
      const along = (a: typeof u, next: () => number) => (a.kind === "still" ? 0 : a.lo + (a.hi - a.lo) * next());
      yield {
        model,
        names,
        kernel,
        header: "u,v",
        numbers: (c) => [(c as AxesConfiguration).u, (c as AxesConfiguration).v],
        anywhere: (next) => ({ u: along(u, next), v: along(v, next) }),
      };
    } else {
      const { window, bounds } = kernel as unknown as PlanarKernel;
      const { lo, hi } = bounds.call(kernel);
      yield {
        model,
        names,
        kernel,
        header: "x,y,theta",
        numbers: (c) => {
          const { x, y, theta } = c as PlanarConfiguration;
          return [x, y, theta];
        },
        anywhere: (next) => ({
          x: lo[0] + (hi[0] - lo[0]) * (1.2 * next() - 0.1),
          y: lo[1] + (hi[1] - lo[1]) * (1.2 * next() - 0.1),
          theta: window.lo + (window.hi - window.lo) * next(),
        }),
      };
    }
  }
}

function free(pair: Pair, next: () => number): Configuration {
  for (let k = 0; k < 10_000; k++) {
    const c = pair.anywhere(next);
    if (pair.kernel.classify(c) === "free") return c;
  }
  throw new Error(`no free configuration of ${pair.model} ${pair.names} is found`);
}

function between(pair: Pair, a: Configuration, b: Configuration, s: number): Configuration {
  const [p, q] = [pair.numbers(a), pair.numbers(b)];
  const [x, y, z] = p.map((t, i) => t + s * (q[i]! - t));
  return pair.header === "u,v" ? { u: x!, v: y! } : { x: x!, y: y!, theta: z! };
}

/** The share of the way from one configuration to another at which a third is. */
function share(pair: Pair, from: Configuration, to: Configuration, at: Configuration): number {
  const [p, q, r] = [pair.numbers(from), pair.numbers(to), pair.numbers(at)];
  const whole = p.reduce((sum, t, i) => sum + (q[i]! - t) ** 2, 0);
  return whole === 0 ? 1 : p.reduce((sum, t, i) => sum + (q[i]! - t) * (r[i]! - t), 0) / whole;
}

const skip = binary() ? false : NO_COMMAND;

test("the first contact is that of cspace play --by", { skip }, async (t) => {
  for (const pair of pairs()) {
    // Each question computes the space again.
    if (/gears|film|geneva|escape|chain|rack/.test(pair.model)) continue;
    await t.test(`${pair.model.split("/models/")[1]} ${pair.names}`, () => {
      const next = random(4);
      for (let k = 0; k < times(8, 3); k++) {
        const from = free(pair, next);
        const to = pair.anywhere(next);
        const by = pair.numbers(to).map((x, i) => x - pair.numbers(from)[i]!);
        const args = ["play", pair.model, "--pair", pair.names, `--at=${pair.numbers(from).join(",")}`, `--by=${by.join(",")}`];
        const told = (JSON.parse(run([...args, "--json"])) as { pairs: [{ motion: { result: string; fraction: number } }] }).pairs[0].motion;
        const { at, stopped } = pair.kernel.advance(from, to);
        const mine = share(pair, from, to, at);
        const what = `${JSON.stringify(from)} to ${JSON.stringify(to)}: ${JSON.stringify(told)}, not ${mine}`;
        assert.equal(stopped !== null, told.result === "contact", what);
        assert.ok(Math.abs(mine - (told.result === "contact" ? told.fraction : 1)) < 1e-7, what);
      }
    });
  }
});

function report(t: TestContext, taken: number[], counts: string): void {
  taken.sort((a, b) => a - b);
  const at = (q: number) => taken[Math.floor(q * (taken.length - 1))]!.toFixed(2);
  t.diagnostic(`${counts}; ms: median ${at(0.5)}, 95 % ${at(0.95)}, most ${at(1)}`);
}

test("motions never lead through what is blocked", { skip }, async (t) => {
  for (const pair of pairs()) {
    await t.test(`${pair.model.split("/models/")[1]} ${pair.names}`, (t) => {
      const next = random(5);
      const taken: number[] = [];
      let stops = 0;
      const count = times(60, 30);
      for (let k = 0; k < count; k++) {
        const from = free(pair, next);
        const to = between(pair, from, pair.anywhere(next), k % 2 ? 1 : 0.1);
        const start = performance.now();
        const { at, stopped } = pair.kernel.advance(from, to);
        taken.push(performance.now() - start);
        if (stopped !== null) stops++;
        else assert.deepEqual(at, to);
        for (let i = 0; i <= 40; i++) {
          const c = between(pair, from, at, i / 40);
          assert.notEqual(pair.kernel.classify(c), "blocked", `${JSON.stringify(from)} to ${JSON.stringify(to)} at ${JSON.stringify(c)}`);
        }
        if (stopped !== null) assert.equal(pair.kernel.classify(at), "contact");
      }
      report(t, taken, `${stops} of ${count} stopped`);
    });
  }
});

test("a part that slides at contact is never blocked, and comes nearer to where it is dragged", { skip }, async (t) => {
  for (const pair of pairs()) {
    await t.test(`${pair.model.split("/models/")[1]} ${pair.names}`, (t) => {
      const next = random(6);
      const taken: number[] = [];
      const all: Configuration[] = [];
      let slid = 0;
      for (let k = 0; k < times(12, 5); k++) {
        let at = free(pair, next);
        const goal = pair.anywhere(next);
        for (let i = 1; i <= 15; i++) {
          const to = between(pair, at, goal, 1 / (16 - i));
          const start = performance.now();
          const stopped = pair.kernel.advance(at, to).at;
          const middle = performance.now();
          const found = pair.kernel.slide(at, to).at;
          taken.push(performance.now() - middle);
          if (share(pair, at, to, found) > share(pair, at, to, stopped) + 1e-6) slid++;
          assert.ok(Number.isFinite(start) && pair.numbers(found).every(Number.isFinite));
          at = found;
          all.push(at);
        }
      }
      const told = classified(pair.model, pair.names, all.map(pair.numbers), pair.header, ["class"]);
      const blocked = told.filter((c) => c.class === "blocked").length;
      const touching = told.filter((c) => c.class === "contact").length;
      report(t, taken, `${touching} of ${all.length} in contact, ${slid} farther than straight`);
      assert.equal(blocked, 0);
    });
  }
});

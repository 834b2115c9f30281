/** Distances of points, lines and arcs, against many points of both. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import type { Place } from "../src/scene.js";
import { distanceOf } from "../src/ui/distance.js";
import { middle } from "../src/ui/measure.js";
import { random } from "./support/random.js";

interface Edge {
  from: Place;
  to: Place;
  bulge: number;
}

/** So many points of an edge. */
const POINTS = 600;

/** A point of an edge: of an arc, on the circle that its ends and its turn give. */
function along({ from, to, bulge }: Edge, share: number): Place {
  if (bulge === 0) return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
  // The chord seen from `from` turns by half of the sweep, and shortens as the sine of what is left.
  const half = 2 * Math.atan(bulge);
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const scale = Math.sin(share * half) / Math.sin(half);
  const turn = -(1 - share) * half;
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return { x: from.x + scale * (c * dx - s * dy), y: from.y + scale * (s * dx + c * dy) };
}

function byPoints(a: Edge, b: Edge): { least: number; step: number } {
  let least = Infinity;
  const of = (e: Edge) => Array.from({ length: POINTS + 1 }, (_, i) => along(e, i / POINTS));
  const [p, q] = [of(a), of(b)];
  for (const x of p) for (const y of q) least = Math.min(least, Math.hypot(x.x - y.x, x.y - y.y));
  const step = Math.max(...[p, q].map((all) => Math.hypot(all[1]!.x - all[0]!.x, all[1]!.y - all[0]!.y)));
  return { least, step };
}

describe("the label of an edge", () => {
  it("stands in the middle of the edge, which of an arc is on it", () => {
    for (const bulge of [0, 1, -0.5, 3]) {
      const edge = { from: { x: 1, y: 2 }, to: { x: 4, y: -2 }, bulge };
      const [at, on] = [middle(edge), along(edge, 0.5)];
      assert.ok(Math.hypot(at.x - on.x, at.y - on.y) < 1e-12, `${bulge}: ${JSON.stringify({ at, on })}`);
    }
  });
});

describe("distances", () => {
  it("are the least of all pairs of points", () => {
    const next = random(7);
    for (let k = 0; k < 60; k += 1) {
      const edge = (): Edge => ({
        from: { x: 10 * next(), y: 10 * next() },
        to: { x: 10 * next(), y: 10 * next() },
        bulge: next() < 0.4 ? 0 : 3 * next() - 1.5,
      });
      const [a, b] = [edge(), edge()];
      const { length, from, to } = distanceOf({ edge: a }, { edge: b });
      const { least, step } = byPoints(a, b);
      assert.ok(length <= least + 1e-9 && length >= least - 2 * step, `${k}: ${length}, by points ${least}`);
      assert.ok(Math.abs(Math.hypot(to.x - from.x, to.y - from.y) - length) < 1e-12);
    }
  });
  it("of a shaft in its bore are the least gap", () => {
    const circle = (x: number, r: number): Edge => ({ from: { x: x - r, y: 0 }, to: { x: x + r, y: 0 }, bulge: -1 });
    const { length } = distanceOf({ edge: circle(0.5, 4) }, { edge: circle(0, 5) });
    assert.ok(Math.abs(length - 0.5) < 1e-12, `${length}`);
  });
  it("of points are as usual", () => {
    assert.equal(distanceOf({ point: { x: 0, y: 0 } }, { point: { x: 3, y: 4 } }).length, 5);
    assert.equal(distanceOf({ point: { x: 0, y: 2 } }, { edge: { from: { x: -1, y: 0 }, to: { x: 1, y: 0 }, bulge: 0 } }).length, 2);
  });
});

/** What is told of regions when a space has been computed again, and loops strung together from curves. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import type { Configuration } from "../src/kernel/api.js";
import { loopsOf } from "../src/ui/curves.js";
import { regionChanges } from "../src/ui/region-changes.js";

/** Regions that are intervals of x. */
const along = (...intervals: [number, number][]) => ({
  class: "general" as const,
  regions: intervals.map(([lo, hi]) => ({ unbounded: false, sample: [(lo + hi) / 2, 0, 0], ranges: null })),
  kernel: {
    region: (c: Configuration) => {
      const found = intervals.findIndex(([lo, hi]) => "x" in c && c.x > lo && c.x < hi);
      return found < 0 ? null : found;
    },
  },
});

describe("changes of regions", () => {
  it("tell what closed and opened", () => {
    assert.equal(regionChanges(along([0, 1], [2, 3]), along([0, 1])), "pocket 1 closed: 2 regions before, 1 region now");
    assert.equal(regionChanges(along([0, 1]), along([5, 6], [0, 1], [7, 8])), "pockets 0, 2 opened: 1 region before, 3 regions now");
  });
  it("are none where a region only moved or was numbered anew", () => {
    assert.equal(regionChanges(along([0, 1], [2, 3]), along([2.2, 3.2], [0.2, 1.2])), "");
    // The old sample is no longer inside, but the new one was before.
    assert.equal(regionChanges(along([0, 1]), along([0.6, 0.9])), "");
  });
  it("tell what was joined and divided", () => {
    assert.match(regionChanges(along([0, 1], [2, 3]), along([0, 3])), /joined/);
    assert.match(regionChanges(along([0, 10]), along([0, 4.5], [4.6, 10])), /divided/);
  });
});

describe("loops", () => {
  it("are strung together whatever the order, and apart where ends are apart", () => {
    const square = [
      [1, 1, 0, 1],
      [0, 0, 1, 0],
      [0, 1, 0, 0],
      [1, 0, 1, 1],
    ];
    assert.deepEqual(loopsOf(square, 1e-6).map((l) => l.length), [16]);
    const apart = square.map((c) => c.map((x) => x + 0));
    apart.push([5, 5, 6, 5, 5, 6], [5, 6, 5, 5]);
    assert.deepEqual(loopsOf(apart, 1e-6).map((l) => l.length).sort((a, b) => a - b), [10, 16]);
    assert.equal(loopsOf([[0, 0, 1, 0], [1.1, 0, 0, 0]], 1e-3).length, 2);
  });
});

/** What of a stack is at one height. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import type { ScenePart } from "../src/scene.js";
import { intervalAt, intervalsOf, loopsAt, partAt, touchesAt } from "../src/ui/heights.js";

const square = (size: number) => [[0, 0], [size, 0], [size, size], [0, size]].map(([x = 0, y = 0]) => ({ x, y, bulge: 0 }));
const part = (name: string, loops: ScenePart["loops"], layers: ScenePart["layers"]): ScenePart => ({ name, loops, layers, feature_names: {}, motion: { type: "planar" } });

/** A wheel and a pinion with one bore, which both have as a loop. */
const arbor = part("arbor", [square(8), square(1), square(4), square(1)], [
  { z: [0, 2], loops: [0, 1] },
  { z: [2, 5], loops: [2, 3] },
]);
const pawl = part("pawl", [square(3)], [{ z: [1, 2 + 1e-12], loops: [0] }]);
const post = part("post", [square(2)], [{ z: null, loops: [0] }]);

describe("heights", () => {
  it("are cut wherever a layer begins or ends, and not where they are rounded", () => {
    assert.deepEqual(intervalsOf([arbor, pawl, post]), [[0, 1], [1, 2], [2, 5]]);
    assert.deepEqual(intervalsOf([post]), []);
    assert.deepEqual(intervalsOf([]), []);
  });

  it("are chosen by any height within, and by none beyond the stack", () => {
    const parts = [arbor, pawl, post];
    assert.deepEqual([0, 0.5, 1, 2, 5].map((z) => intervalAt(parts, z)), [[0, 1], [0, 1], [1, 2], [2, 5], [2, 5]]);
    assert.deepEqual([-1, 5.1, null].map((z) => intervalAt(parts, z)), [null, null, null]);
  });

  it("have the loops of the layers that are there", () => {
    assert.deepEqual(loopsAt(arbor, [2, 5]), [2, 3]);
    assert.deepEqual(loopsAt(arbor, null), [0, 1, 2, 3]);
    assert.deepEqual(loopsAt(pawl, [2, 5]), []);
    assert.equal(partAt(post, [2, 5]), post);
    assert.deepEqual(partAt(arbor, [0, 1]).loops, [square(8), square(1)]);
  });

  it("have the features of a bore through several layers, by the number of the first", () => {
    assert.deepEqual([0, 1, 2].map((loop) => touchesAt(arbor, loop, [2, 5])), [false, true, true]);
    assert.deepEqual([0, 1, 2].map((loop) => touchesAt(arbor, loop, null)), [true, true, true]);
  });
});

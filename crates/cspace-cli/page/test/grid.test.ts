/** Grids have few lines with numbers that differ, however far they are zoomed. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { gridLines, heldScale, lineText } from "../src/ui/grid.js";
import { angleStep, degrees, lengthStep } from "../src/ui/numbers.js";

describe("grid lines", () => {
  it("are the multiples of the step between two values", () => {
    assert.deepEqual(gridLines(-0.9, 2.1, 1).map((l) => l.value), [0, 1, 2]);
    assert.deepEqual(gridLines(10, 15, 2.5), [{ index: 4, value: 10 }, { index: 5, value: 12.5 }, { index: 6, value: 15 }]);
    assert.deepEqual(gridLines(0.1, 0.2, 1), []);
  });

  it("are few, whatever is asked", () => {
    for (const [lo, hi, step] of [[1e6, 1e6 + 1e-9, 1e-12], [0, 1e9, 1], [1e16, 1e16 + 2, 1e-3], [-1e300, 1e300, 1e-300], [NaN, 1, 1], [0, Infinity, 1], [0, 1, 0]] as const) {
      assert.ok(gridLines(lo, hi, step).length <= 1000, `${lo} to ${hi} by ${step}`);
    }
    // Of many turns, too.
    for (const wide of [1, 100, 1e6, 1e12]) assert.ok(gridLines(0, wide, angleStep(wide / 20)).length <= 21);
  });

  it("have numbers that differ, and are what they say", () => {
    for (const at of [0, 1, -3, 1e3, 1e6, -1e6, 123456789]) {
      for (const width of [1e-4, 0.03, 2, 500, 1e7]) {
        const step = lengthStep(width / 10);
        const lines = gridLines(at, at + width, step);
        const texts = lines.map((l) => lineText(l.value, step));
        assert.equal(new Set(texts).size, lines.length, `${at}, ${width}: ${texts}`);
        lines.forEach((l, i) => assert.ok(Math.abs(Number(texts[i]!.replaceAll("−", "-")) - l.value) <= 1e-3 * step, `${texts[i]} for ${l.value}`));
      }
    }
    assert.equal(lineText(1000000.5, 0.5), "1000000.5");
    assert.equal(lineText(0.30000000000000004, 0.1), "0.3");
  });
});

describe("zooming", () => {
  it("ends where pixels are finer than coordinates", () => {
    const zoomed = (center: number, factor: number) => {
      let scale = 10;
      for (let i = 0; i < 1000; i += 1) scale = heldScale(scale * factor, 100, center);
      return 1 / scale;
    };
    for (const center of [0, 50, 1e6, 1e12]) {
      const pixel = zoomed(center, 1.2);
      assert.ok(pixel >= 1e-7 * (1 - 1e-12) && center + pixel !== center, `${center}: ${pixel}`);
    }
    assert.ok(Math.abs(zoomed(0, 1 / 1.2) / 1e8 - 1) < 1e-9);
  });

  it("is free in between", () => assert.equal(heldScale(3, 100, 1e6), 3));
});

describe("angles", () => {
  it("that are rounding are none", () => {
    assert.equal(degrees(3.7e-14), "0°");
    assert.equal(degrees(-1e-13), "0°");
    assert.equal(degrees(Math.PI / 180000), "0.001°");
  });
});

/** Numbers as people read them. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { degrees, length, short, within } from "../src/ui/numbers.js";

describe("numbers", () => {
  it("have minus signs, and no more decimals than six digits of what they are seen in", () => {
    assert.equal(short(-5), "−5");
    assert.equal(short(-1.5e-7), "−1.50e−7");
    for (const [value, span, text] of [
      [7.42e-17, 40, "0 mm"],
      [-7.92e-15, 40, "0 mm"],
      [-0.0005557, 24, "−0.0006 mm"],
      [1000000.123456, 40, "1000000 mm"],
      [12.345678, 40, "12.3457 mm"],
      [0.00012345678, 0.0004, "0.000123457 mm"],
    ] as const) {
      assert.equal(length(within(value, span), "mm"), text);
    }
    assert.equal(within(-0.0005557, 24, 4), 0);
    assert.equal(degrees((-8.93e-7 * Math.PI) / 180, 6, 2 * Math.PI), "0°");
    assert.equal(degrees((-0.370815 * Math.PI) / 180, 4, (0.75 * Math.PI) / 180), "−0.3708°");
    assert.equal(degrees((12.994617 * Math.PI) / 180, 4, (13 * Math.PI) / 180), "12.99°");
  });
});

/** Regions are told apart by their colours. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { TOUCHING, channels, regionColour } from "../src/ui/colours.js";

test("eighteen regions have colours of their own", () => {
  const all = [TOUCHING, ...Array.from({ length: 18 }, (_, i) => regionColour(i))];
  for (const colour of all) assert.match(colour, /^#[0-9a-f]{6}$/);
  for (let i = 0; i < all.length; i += 1) {
    for (let j = 0; j < i; j += 1) {
      const [a, b] = [channels(all[i]!), channels(all[j]!)];
      const apart = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      assert.ok(apart > 24, `${all[i]} of ${i} and ${all[j]} of ${j}: ${apart}`);
    }
  }
});

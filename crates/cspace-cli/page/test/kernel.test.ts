/** The kernel's formulas stand in the kernel: the page only draws and listens. */

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";

/** What draws parts, places them where they are, and edits their outlines. */
const DRAWING = new Set(["edit-shape.ts", "label-place.ts", "mechanism.ts", "outline.ts", "parts-view.ts", "placement.ts", "space-view.ts"]);

test("no kernel formula is in the page", () => {
  const found: string[] = [];
  for (const folder of ["src", "src/ui", "src/kernel", "src/drawing"]) {
    for (const name of readdirSync(resolve(process.cwd(), folder)).filter((n) => n.endsWith(".ts") && !DRAWING.has(n))) {
      const text = readFileSync(join(resolve(process.cwd(), folder), name), "utf8");
      if (/Math\.(sin|cos|tan|asin|acos|atan2?)\b/.test(text)) found.push(name);
    }
  }
  assert.deepEqual(found, []);
});

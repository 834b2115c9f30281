/** All parts of a mechanism dragged by hand: what is drawn flush touches, and does not overlap. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Hand } from "../build/kernel/cspace.js";
import { binary, MODELS, NO_COMMAND } from "./support/command.js";
import { sceneOf, withModel } from "./support/scene.js";

const [BLOCK, LID, BOLT] = [1, 2, 3];

test("a bolt that fills its keeper holds block and lid until it is drawn out", { skip: binary() ? false : NO_COMMAND }, () => {
  // Without what draws the bolt and the lid.
  const [parts = ""] = readFileSync(join(MODELS, "latch_box.toml"), "utf8").split("[[spring]]");
  const source = withModel(parts.replace(/^gravity = .*$/m, ""), (path) => sceneOf(path).source);
  const hand = new Hand(JSON.stringify(source), JSON.stringify({ set: [], parts: [] }));
  const drawn = hand.setState(new Float64Array(9));
  assert.deepEqual(drawn.overlapping, []);
  assert.match(drawn.gaps.join(), /^gap \S+ mm: the parts fit exactly, and bolt is smaller by it all around$/);
  const drag = (part: number, of: [number, number], to: [number, number]) => hand.drag(part, Float64Array.from(of), Float64Array.from(to));
  for (const up of [0.5, 3, 60]) {
    const { parts, reached, stopped, overlapping } = drag(BLOCK, [40, 10], [40, 10 + up]);
    assert.ok(!reached && stopped.length > 0, `${stopped}`);
    assert.deepEqual(overlapping, []);
    const [x = 0, y = 0, theta = 0] = parts[BLOCK] ?? [];
    assert.ok(Math.abs(x) < 0.1 && Math.abs(y) < 0.01 && Math.abs(theta) < 0.001, `${parts[BLOCK]}`);
    assert.ok(Math.abs(parts[BOLT]?.[0] ?? 9) < 0.01, `${parts[BOLT]}`);
  }
  const calls = (part: number, of: [number, number], to: [number, number]) => Array.from({ length: 20 }, () => drag(part, of, to)).at(-1);
  assert.ok((calls(BOLT, [96, 43], [126, 43])?.parts[BOLT]?.[0] ?? 0) > 29);
  assert.ok((calls(LID, [76, 37], [76, 47])?.parts[LID]?.[2] ?? 0) > 0.1);
  hand.free();
});

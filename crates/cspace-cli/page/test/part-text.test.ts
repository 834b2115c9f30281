/** Parts are added to a model, renamed and removed in its text: the kernel reads what comes out, and all else stays as it is written. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Model } from "../build/kernel/cspace.js";
import type { Scene } from "../src/scene.js";
import { boxOf } from "../src/ui/outline.js";
import { SHAPES, withName, withPart, withoutPart, wrongPart, type NewPart, type Shape } from "../src/ui/part-text.js";
import { MODELS, models } from "./support/command.js";

const BLANK = 'name = "new model"\nunit = "mm"\n';

const sceneOf = (text: string): Scene => JSON.parse(Model.read(text, "model.toml").scene()) as Scene;
const part = (more: Partial<NewPart> = {}): NewPart => ({ name: "part 1", shape: "rectangle", sizes: [20, 10], at: { x: 0, y: 0 }, motion: { type: "planar" }, ...more });

/** Sizes of each shape, and the box that they give it about its origin. */
const BOXES: Record<Shape, { sizes: number[]; box: number[] }> = {
  rectangle: { sizes: [20, 10], box: [-10, -5, 10, 5] },
  circle: { sizes: [4], box: [-4, -4, 4, 4] },
  slot: { sizes: [20, 6], box: [-13, -3, 13, 3] },
  polygon: { sizes: [4, 8], box: [-8, -8, 8, 8] },
};

for (const shape of Object.keys(SHAPES) as Shape[]) {
  test(`a ${shape} has its dimensions as parameters, and is where it was put`, () => {
    const { sizes, box } = BOXES[shape];
    const text = withPart(BLANK, part({ shape, sizes, at: { x: 7, y: -3 } }));
    assert.ok(text.startsWith(BLANK));
    const scene = sceneOf(text);
    assert.deepEqual(scene.parts.map((p) => p.name), ["part 1"]);
    const { x0, y0, x1, y1 } = boxOf(scene.parts[0]!.loops);
    [x0 - 7, y0 + 3, x1 - 7, y1 + 3].forEach((x, i) => assert.ok(Math.abs(x - box[i]!) < 1e-12, `${x}, ${box[i]}`));
    const named = Object.keys(SHAPES[shape].sizes).map((what, i): [string, number] => [`${what}_1`, sizes[i]!]);
    assert.deepEqual(new Map(scene.design?.parameters.map((p) => [p.name, p.value])), new Map(named.sort()));
    // A second one has parameters of its own.
    const twice = sceneOf(withPart(text, part({ name: "part 2", shape, sizes, at: { x: 50, y: 0 } })));
    assert.equal(twice.design?.parameters.length, 2 * sizes.length);
    assert.equal(twice.pairs.length, 1);
  });
}

test("docs/page.md shows what comes out", () => {
  const text = withPart("", part({ sizes: [30, 20], motion: { type: "fixed" } }));
  assert.ok(readFileSync(join(MODELS, "../docs/page.md"), "utf8").includes(`\`\`\`toml${text}\`\`\``), text);
});

test("motions are those that were chosen", () => {
  const motions: NewPart["motion"][] = [
    { type: "fixed" },
    { type: "planar" },
    { type: "revolute", center: { x: 1, y: 2 }, range: null },
    { type: "prismatic", direction: { x: 0, y: 1 }, range: null },
  ];
  const text = motions.reduce((all, motion, i) => withPart(all, part({ name: `${motion.type} "${i}"`, at: { x: 30 * i, y: 0 }, motion })), BLANK);
  assert.deepEqual(sceneOf(text).parts.map((p) => p.motion), motions);
});

for (const file of models()) {
  test(`${file.slice(MODELS.length + 1)} gets a part, which is renamed and removed`, () => {
    const text = readFileSync(file, "utf8");
    const before = sceneOf(text);
    const names = before.parts.map((p) => p.name);
    const added = withPart(text, part({ name: "new one", at: { x: 1e4, y: 0 } }));
    assert.deepEqual(sceneOf(added).parts.map((p) => p.name), [...names, "new one"]);
    assert.deepEqual(added.split("\n").filter((line) => line.includes("#")).filter((line) => !/_\d+ = /.test(line)), text.split("\n").filter((line) => line.includes("#")));
    const gone = withoutPart(added, "new one");
    // A requirement names the pair once there are others.
    const said = (of: string) => of.split("\n").filter((line) => !/^$|^\[parameter\]|^pair = /.test(line));
    assert.deepEqual(said(gone), said(text));
    assert.deepEqual(sceneOf(gone).parts, before.parts);
    // Each of its parts gets another name, by which all else still finds it.
    names.forEach((name, i) => {
      const scene = sceneOf(withName(text, name, 'x "1"'));
      assert.deepEqual(scene.parts.map((p) => p.name), names.map((n, k) => (k === i ? 'x "1"' : n)));
      assert.deepEqual([scene.pairs.length, scene.joints, scene.show], [before.pairs.length, before.joints, before.show]);
      if (names.length > 1) assert.deepEqual(sceneOf(withoutPart(text, name)).parts.map((p) => p.name), names.filter((n) => n !== name));
    });
  });
}

test("what is wrong is told in words", () => {
  const names = ["part 1"];
  assert.equal(wrongPart(part({ name: "other" }), names), null);
  assert.equal(wrongPart(part({ name: " part 1 " }), names), "There is a part with the name part 1: choose another.");
  assert.equal(wrongPart(part({ name: " " }), names), "Give the part a name.");
  for (const size of [0, -1, NaN, 1e13]) assert.equal(wrongPart(part({ sizes: [20, size] }), []), "height: type a number greater than 0.");
  assert.equal(wrongPart(part({ shape: "polygon", sizes: [2.5, 4] }), []), "sides: type a whole number from 3 to 1000.");
  assert.equal(wrongPart(part({ at: { x: NaN, y: 0 } }), []), "Type a number for x and for y.");
  assert.match(wrongPart(part({ motion: { type: "prismatic", direction: { x: 0, y: 0 }, range: null } }), []) ?? "", /direction/);
});

test("what only a removed part used goes with it", () => {
  const text = withPart(withPart(BLANK, part()), part({ name: "part 2", shape: "circle", sizes: [4], at: { x: 40, y: 0 } }));
  const left = withoutPart(text, "part 1");
  assert.deepEqual(sceneOf(left).design?.parameters.map((p) => p.name), ["radius_1"]);
});

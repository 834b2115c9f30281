/** What is in an address is what was shown. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import type { Scene } from "../src/scene.js";
import { readAddress, writeAddress } from "../src/ui/address.js";
import type { State } from "../src/ui/state.js";

const part = (name: string) => ({ name, loops: [], layers: [], feature_names: {}, motion: { type: "planar" as const } });
const pair = (fixed: number, moving: number) => ({ fixed, moving, class: "general" as const }) as Scene["pairs"][number];
const HOSTILE = `a&b=c#d%20"<img>`;

const scene = {
  format: "cspace-scene",
  version: 1,
  name: "",
  unit: null,
  parts: [part("block"), part(HOSTILE), part("peg")],
  joints: [],
  pairs: [pair(0, 2), pair(1, 2)],
  show: { pair: null, question: null, view: null },
  records: [],
  design: null,
  source: null,
} satisfies Scene;

const state = (changes: Partial<State>): State =>
  ({
    scene,
    parts: scene.parts,
    pair: 0,
    configuration: { x: 0, y: 0, theta: 0 },
    theme: "auto",
    stop: true,
    colouring: "region",
    cut: false,
    height: null,
    view: "parts",
    hidden: new Set(),
    ...changes,
  }) as State;

describe("addresses", () => {
  it("keep every digit of a configuration", () => {
    const configuration = { x: 0.1 + 0.2, y: -1e-300, theta: Math.PI };
    assert.deepEqual(readAddress(writeAddress(state({ configuration }), null), scene).configuration, configuration);
    const axes = { u: 1 / 3, v: -2e11 };
    assert.deepEqual(readAddress(writeAddress(state({ configuration: axes }), null), scene).configuration, axes);
  });

  it("name pairs by their parts, whatever these are called", () => {
    const text = writeAddress(state({ pair: 1 }), null);
    assert.equal(readAddress(text, scene).pair, 1);
    assert.ok(!text.slice(1).includes("#") && !text.includes("<"));
  });

  it("say what is large where it is not what the model says", () => {
    assert.equal(readAddress(writeAddress(state({ view: "space" }), null), scene).view, "space");
    const shown = { ...scene, show: { ...scene.show, view: "slice" as const } };
    const text = (view: State["view"]) => writeAddress(state({ scene: shown, view }), null);
    assert.equal(readAddress(text("parts"), shown).view, "parts");
    assert.ok(!text("slice").includes("view") && !writeAddress(state({}), null).includes("view"));
    assert.equal(readAddress("#view=plane", scene).view, undefined);
  });

  it("keep switches, and leave out what is as always", () => {
    const text = writeAddress(state({ theme: "dark", stop: false, colouring: "kind", cut: true, height: 2.5, hidden: new Set([2, 5]) }), [0.5, 1, 3, 0, 0, 0.25]);
    const { theme, stop, colouring, cut, height, hidden, camera } = readAddress(text, scene);
    assert.deepEqual({ theme, stop, colouring, cut, height, hidden, camera }, { theme: "dark", stop: false, colouring: "kind", cut: true, height: 2.5, hidden: [2, 5], camera: [0.5, 1, 3, 0, 0, 0.25] });
    for (const key of ["theme", "stop", "colours", "cut", "height", "hidden", "camera"]) assert.ok(!writeAddress(state({}), null).includes(key));
  });

  it("hold the file and what is changed of it, and are of no other", () => {
    const source = { model: "", pairs: [], general: false, design: { text: "mouth = 6", file: HOSTILE, set: [] } };
    const of = { ...scene, source };
    const edits = { set: [{ name: "mouth", value: "9.5" }, { name: "é", value: "a = b" }], parts: [{ index: 1, loops: [[{ x: 0.1, y: 0, bulge: 0 }]], motion: { type: "planar" as const }, offset: 0.25 }] };
    const text = writeAddress(state({ scene: of }), null, edits);
    assert.deepEqual(readAddress(text, of).edits, edits);
    assert.equal(readAddress(text, of).warning, undefined);
    assert.equal(readAddress(writeAddress(state({ scene: of }), null), of).edits, undefined);
    const later = { ...of, source: { ...source, design: { ...source.design, text: "mouth = 7" } } };
    assert.deepEqual(readAddress(text, later).edits, edits);
    assert.match(readAddress(text, later).warning ?? "", /has changed since/);
    assert.deepEqual(Object.keys(readAddress(text, scene)), ["warning"]);
    assert.deepEqual(readAddress("#set=&set=x&set==1&parts={}&parts=no", scene), {});
  });

  it("leave out what they do not understand", () => {
    const read = readAddress("#fixed=nobody&moving=peg&x=1&y=two&theta=3&theme=pink&stop=maybe&colours=&camera=1,2&hidden=-1,x&height=high&u=Infinity&v=0", scene);
    assert.deepEqual(read, {});
    for (const far of ["#x=1e300&y=1e300&theta=1e300", "#u=0&v=-1e13", "#camera=1e300,1,1e300,1e308,0,0", "#camera=0,1,0,0,0,0", "#camera=0,1,-2,0,0,0", "#x=1e999&y=0&theta=0"]) {
      assert.deepEqual(readAddress(far, scene), {}, far);
    }
  });
});

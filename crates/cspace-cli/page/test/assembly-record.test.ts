/** Assemblies are played step by step; what has left as a group is taken apart where it has gone. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { RecordError } from "../src/ui/record-json.js";
import { stateAt } from "../src/ui/playable.js";
import { readRecord } from "../src/ui/records.js";

const origin = { x: 0, y: 0, theta: 0 };

/** A door opens, lid and knob leave as one and turn, then the knob leaves the lid. */
const assembly = {
  verdict: "apart",
  steps: [
    { kind: "moves", moving: ["door"], staying: ["box", "lid", "knob"], path: [{ u: 0, v: 0 }, { u: 0, v: 1.5 }], words: ["turns +85.9° about (0, 4)"] },
    {
      kind: "leaves",
      moving: ["lid", "knob"],
      staying: ["box", "door"],
      path: [origin, { x: 0, y: 3, theta: 0 }, { x: 0, y: 3, theta: Math.PI / 2 }],
      about: [0, 0],
      words: ["up 3", "turn 90° counter-clockwise"],
      onward: [0, 5],
    },
    { kind: "leaves", moving: ["knob"], staying: ["lid"], path: [origin, { x: 2, y: 0, theta: 0 }], about: [0, 0], words: ["right 2"], onward: [1, 0] },
  ],
  tree: { parts: ["box", "door", "lid", "knob"], out: [], left: ["box", "door"] },
};

function near(value: unknown, expected: { x: number; y: number; theta: number }): void {
  const at = value as typeof expected;
  for (const key of ["x", "y", "theta"] as const) assert.ok(Math.abs(at[key] - expected[key]) < 1e-12, JSON.stringify({ at, expected }));
}

describe("assemblies", () => {
  const record = readRecord("a.json", assembly);
  assert.ok(record.kind === "simulation");
  const at = (t: number) => stateAt(record, t)?.parts ?? new Map();
  const begins = (text: string) => record.ticks.find((tick) => tick.text.startsWith(text))?.t ?? NaN;

  it("begin as drawn and have the words of their legs as ticks", () => {
    assert.deepEqual([...at(0)], [["box", origin], ["door", 0], ["lid", origin], ["knob", origin]]);
    assert.deepEqual(record.ticks.map((tick) => tick.text), [
      "1. door makes room: turns +85.9° about (0, 4)",
      "2. lid, knob out: up 3",
      "2. lid, knob out: turn 90° counter-clockwise",
      "2. lid, knob are out",
      "3. knob out: right 2",
      "3. knob is out",
    ]);
    assert.equal(record.summary, "apart, 3 steps");
  });

  it("leave what has moved aside or has left where it has come to", () => {
    assert.equal(at(begins("2.")).get("door"), 1.5);
    near(at(begins("2. lid, knob are out")).get("knob"), { x: 0, y: 3, theta: Math.PI / 2 });
    near(at(begins("3.")).get("lid"), { x: 0, y: 8, theta: Math.PI / 2 });
    const end = at(record.duration);
    assert.equal(end.get("door"), 1.5);
    near(end.get("box"), origin);
    near(end.get("lid"), { x: 0, y: 8, theta: Math.PI / 2 });
    // To the right in the frame of the lid is up.
    near(end.get("knob"), { x: 0, y: 11, theta: Math.PI / 2 });
  });

  it("are refused with the place of what is wrong", () => {
    const wrong = (changed: object) => () => readRecord("a.json", { ...assembly, ...changed });
    assert.throws(wrong({ verdict: "locked", steps: [] }), (e) => e instanceof RecordError && /no step to play.*locked/.test(e.message));
    assert.throws(wrong({ steps: [{ ...assembly.steps[0], moving: ["bolt"] }] }), /steps\[0\].*bolt/);
    assert.throws(wrong({ steps: [{ ...assembly.steps[1], path: [origin, { x: 0, y: "3", theta: 0 }] }] }), /steps\[0\]\.path\[1\]\.y/);
    assert.throws(wrong({ tree: null }), /tree\.parts/);
  });
});

/** Records are read as the commands print them, and refused with a reason. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { pathAt, stateAt } from "../src/ui/playable.js";
import { RecordError } from "../src/ui/record-json.js";
import { readRecord, readRecordText } from "../src/ui/records.js";

const path = [
  { x: 0, y: 0, theta: 0 },
  { x: 3, y: 4, theta: 0 },
  { x: 3, y: 4, theta: 15 },
];

const simulation = {
  status: "jammed",
  reason: "a and b",
  parts: ["wheel", "pawl"],
  samples: [
    { t: 0, wheel: 0, pawl: [0, 0, 0] },
    { t: 1, wheel: 2, pawl: [1, -2, 8] },
    { t: 3, wheel: 3, pawl: [1, -2, 8] },
  ],
  events: [{ t: 0.5, kind: "touch", fixed: "wheel", moving: "pawl", features: ["line 0 of loop 0", "vertex 1 of loop 0"], at: [0, 0] }],
};

describe("planned paths", () => {
  it("are played at an even pace along their legs", () => {
    const record = readRecord("p", { verdict: "path", path, clearance: 0.25 });
    assert.ok(record.kind === "plan");
    // The legs are 5 and 15 long: the corner is after a quarter of the time.
    assert.deepEqual(pathAt(record, record.duration / 4), path[1]);
    assert.deepEqual(pathAt(record, record.duration / 8), { x: 1.5, y: 2, theta: 0 });
    assert.deepEqual(pathAt(record, record.duration), path[2]);
    assert.deepEqual(record.ticks.map((t) => t.text), ["start", "corner 1", "goal"]);
    assert.match(record.summary, /0\.2500/);
  });

  it("may be in (u, v), or lists of numbers", () => {
    const record = readRecord("p", { verdict: "path", path: [[0, 1], { u: 2, v: 3 }] });
    assert.ok(record.kind === "plan");
    assert.deepEqual(pathAt(record, record.duration / 2), { u: 1, v: 2 });
  });

  it("that are none are refused with the verdict", () => {
    assert.throws(() => readRecord("p.json", { verdict: "no-path", path: [] }), (e) => e instanceof RecordError && /p\.json.*no-path/.test(e.message));
    assert.throws(() => readRecord("p", { verdict: "path", path: [path[0], { u: 0, v: 0 }] }), RecordError);
    assert.throws(() => readRecord("p", { verdict: "path", path: [{ x: 0, y: null, theta: 0 }] }), /path\[0\]\.y/);
  });
});

describe("simulations", () => {
  it("stand at a known state between samples", () => {
    const record = readRecord("s", simulation);
    assert.ok(record.kind === "simulation");
    assert.equal(record.duration, 3);
    const parts = (t: number) => [...(stateAt(record, t)?.parts ?? [])];
    assert.deepEqual(parts(0.25), [["wheel", 0], ["pawl", { x: 0, y: 0, theta: 0 }]]);
    assert.deepEqual(parts(2), [["wheel", 2], ["pawl", { x: 1, y: -2, theta: 8 }]]);
    assert.deepEqual(parts(99), [["wheel", 3], ["pawl", { x: 1, y: -2, theta: 8 }]]);
    assert.equal(record.summary, "jammed: a and b");
  });

  it("show what happens at once", () => {
    const way = [0, 1, 2, 3, 4].map((x) => [1, x, x, 0, 0]);
    const states = [[0, 0, 0, 0, 0], ...way, [3, 4, 4, 0, 0]];
    const record = readRecord("s", { ...simulation, states, events: [{ t: 1, kind: "snap", part: "pawl" }, { t: 2, kind: "rest" }] });
    assert.ok(record.kind === "simulation");
    assert.ok(Math.abs(record.duration - 3.4) < 1e-12);
    assert.deepEqual(record.ticks.map((t) => t.t), [1, 2.4]);
    for (const [played, time, wheel] of [[0.9, 0, 0], [1, 1, 0], [1.25, 1, 2], [1.45, 1, 4], [3.4, 3, 4]] as const) {
      const state = stateAt(record, played);
      assert.equal(state?.time, time);
      assert.equal(state?.parts.get("wheel"), wheel);
    }
    assert.throws(() => readRecord("s", { ...simulation, states: [[0, 0, 0]] }), /states\[0\]\[3\]/);
  });

  it("have their events as ticks", () => {
    assert.deepEqual(readRecord("s", simulation).ticks, [{ t: 0.5, text: "touch: wheel, line 0 of loop 0 and pawl, vertex 1 of loop 0" }]);
  });

  it("are refused with the place of what is wrong", () => {
    const wrong = { ...simulation, samples: [{ t: 0, wheel: "0", pawl: [0, 0, 0] }] };
    assert.throws(() => readRecord("s", wrong), /samples\[0\]\.wheel/);
    assert.throws(() => readRecord("s", { ...simulation, samples: [] }), /no samples/);
    assert.throws(() => readRecord("s", { ...simulation, samples: [simulation.samples[1], simulation.samples[0]] }), /ascend/);
    assert.throws(() => readRecord("s", { ...simulation, samples: [{ t: 0, wheel: 0, pawl: [0, 0] }] }), /samples\[0\]\.pawl/);
  });
});

describe("numbers that cannot be shown", () => {
  it("are refused with their place", () => {
    for (const big of [1e308, -1e13, Infinity]) {
      assert.throws(() => readRecord("p", { verdict: "path", path: [path[0], { x: 0, y: big, theta: 0 }] }), /path\[1\]\.y.*beyond/);
      assert.throws(() => readRecord("s", { ...simulation, samples: [{ t: 0, wheel: big, pawl: [0, 0, 0] }] }), /samples\[0\]\.wheel.*beyond/);
      assert.throws(() => readRecord("s", { ...simulation, events: [{ t: big, kind: "touch" }] }), RecordError);
    }
    // As a file has it: JSON makes it infinite.
    assert.throws(() => readRecordText("f.json", '{"verdict": "path", "path": [[1e999, 0]]}'), RecordError);
  });
});

describe("other files", () => {
  it("are refused", () => {
    for (const text of ["", "[1]", "null", "{}", "3", '{"samples": 3}', '{"verdict": "path"}']) assert.throws(() => readRecordText("f.json", text), RecordError);
  });
});

it("a leg moves the point straight that it is about", () => {
  const path = [
    { x: 0, y: 0, theta: 0 },
    { x: 20, y: 0, theta: Math.PI },
  ];
  const record = readRecord("way", { verdict: "path", path, about: [10, 0], words: ["turn 180° counter-clockwise"], clearance: 1 });
  assert.ok(record.kind === "plan");
  assert.equal(record.ticks[0]?.text, "turn 180° counter-clockwise");
  // The point (10, 0) stays where it is.
  const half = pathAt(record, record.duration / 2);
  assert.ok(half && "x" in half);
  assert.ok(Math.hypot(half.x - 10, half.y + 10) < 1e-12, JSON.stringify(half));
});

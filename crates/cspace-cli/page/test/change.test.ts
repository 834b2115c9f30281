/** What a change makes: ranges of sliders, exact marks, words from the file; and time as it is drawn. */

import assert from "node:assert/strict";
import { describe, it, mock } from "node:test";
import { Model } from "../build/kernel/cspace.js";
import { commentOf } from "../src/ui/file-comments.js";
import { gridStep, snapped } from "../src/ui/grid.js";
import { lensCorner } from "../src/ui/lens.js";
import { Pace } from "../src/ui/pace.js";
import { stretches, timeAt, timeNumbers } from "../src/ui/playable.js";
import { widened } from "../src/ui/ranges.js";
import { csvOf, seriesOf } from "../src/ui/record-series.js";
import { readRecord } from "../src/ui/records.js";
import { goalsOf, joined, regionMarks, requirementMarks } from "../src/ui/thresholds.js";
import type { CheckRow, RegionChange } from "../src/ui/workshop.js";
import { NO_COMMAND, binary, run } from "./support/command.js";

const row = (more: Partial<CheckRow>): CheckRow => ({ name: "gap", measure: "play", dimension: "length", value: 1, met: true, margin: 0, ...more });

describe("the range of a slider", () => {
  it("grows by halves of its width until a value is within", () => {
    assert.deepEqual(widened([4, 8], 6, false), [4, 8]);
    assert.deepEqual(widened([4, 8], 8, false), [4, 10]);
    // By 2, then by 3.
    assert.deepEqual(widened([4, 8], 12, false), [4, 13]);
    assert.deepEqual(widened([4, 8], 4, false), [2, 8]);
    const [lo, hi] = widened([4, 8], -1e12, false);
    assert.ok(lo < -1e12 && hi === 8);
  });
  it("is of whole numbers, 1 or more, of a count", () => {
    assert.deepEqual(widened([3, 8], 8, true), [3, 11]);
    assert.deepEqual(widened([3, 8], 1, true), [1, 8]);
    assert.deepEqual(widened([1, 8], -4, true), [1, 8]);
  });
});

describe("marks of a parameter", () => {
  it("are the ends of where all goals are met", () => {
    const limits = row({ limits: [2, 5] });
    assert.deepEqual(goalsOf(limits).map((g) => [g.relation, g.value]), [["at-least", 2], ["at-most", 5]]);
    const marks = requirementMarks(limits, [0, 10], [[[1, 4], [6, 10]], [[0, 3], [5, 8]]]);
    assert.deepEqual(marks.map((m) => [m.at, m.text]), [[1, "gap is met"], [3, "gap is not met"], [6, "gap is met"], [8, "gap is not met"]]);
    assert.deepEqual(requirementMarks(limits, [0, 10], [[], [[0, 10]]]), []);
    assert.deepEqual(goalsOf(row({})), []);
  });
  it("say what becomes of a part that is caged, also where it must not be", () => {
    const held = row({ measure: "caged", value: true, pair: ["catch", "bolt"] });
    assert.deepEqual(requirementMarks(held, [0, 10], [[[0, 4]]]), [{ at: 4, text: "bolt comes out" }]);
    assert.deepEqual(requirementMarks({ ...held, equals: false }, [0, 10], [[[0, 4]]]), [{ at: 4, text: "bolt is held" }]);
  });
  it("are told once where they are of one place", () => {
    const regions: RegionChange[] = [{ at: 4.0000001, below: [2, 1], above: [1, 0] }, { at: 2, below: null, above: [2, 1] }];
    const all = joined([{ at: 4, text: "bolt comes out" }, ...regionMarks(regions)], [0, 10]);
    assert.deepEqual(all, [{ at: 2, text: "2 free regions, 1 caged" }, { at: 4, text: "bolt comes out; 1 free region, none caged" }]);
  });
  it("are where the command solves them", { skip: binary() ? false : NO_COMMAND }, () => {
    const model = Model.read(run(["new", "latch"]), "latch.toml");
    const edits = JSON.stringify({ set: [], parts: [] });
    const goal = (value: boolean) => JSON.stringify({ vary: [{ parameter: "mouth", lo: 6, hi: 10 }], so_that: { requirement: "held", relation: "equal", value } });
    const out = JSON.parse(model.solve(edits, goal(false))) as { ranges: [number, number][] };
    // Rounding in another engine is less than the twelfth digit.
    assert.ok(Math.abs((out.ranges[0]?.[0] ?? 0) - 9.14601435238) < 1e-10, JSON.stringify(out));
    const changes = JSON.parse(model.regionChanges(0, edits, "mouth", 6, 10)) as RegionChange[];
    assert.deepEqual(changes.map(({ below, above }) => [below, above]), [[[2, 1], [1, 0]]]);
    // To 1e-9 of the range.
    assert.ok(Math.abs((changes[0]?.at ?? 0) - (out.ranges[0]?.[0] ?? 0)) <= 4e-9, JSON.stringify(changes));
    assert.throws(() => model.solve(edits, "{}"), /missing field/);
    model.free();
  });
});

describe("comments of parameters", () => {
  const text = 'name = "x" # no parameter\n[parameter]\nhead = 10 # its # diameter \nplay = { value = 1, tolerance = "h#7" } # of the head\ntext = "a#b"\n"odd name" = 2 # quoted\n\n[[part]]\nlip = 3 # of a part\n';
  it("are those on their lines", () => {
    assert.deepEqual(["head", "play", "text", "odd name", "lip", "name", "none"].map((name) => commentOf(text, name)), ["its # diameter", "of the head", "", "quoted", "", "", ""]);
  });
});

describe("time", () => {
  const at = (t: number, wheel: number, force?: number) => ({ t, wheel, forces: { drives: force === undefined ? [] : [{ part: "wheel", force, power: 0 }] } });
  // Six states of one time are played in 0.4 s.
  const samples = [at(0, 0, 1), at(1, Math.PI, 2), ...Array.from({ length: 6 }, (_, i) => at(1, Math.PI + (i + 1) / 10)), at(2, 5, 4)];
  const record = readRecord("run", { parts: ["wheel"], samples, events: [], status: "done", units: { force: "mN" } });
  const near = (a: number, b: number) => assert.ok(Math.abs(a - b) < 1e-12, `${a} and ${b}`);
  it("stands while what happens at once is played, which is shaded", () => {
    assert.equal(record.duration, 2.4);
    const [[from, to] = [NaN, NaN], ...others] = stretches(record);
    assert.ok(from === 1 && others.length === 0);
    near(to, 1.4);
    near(timeAt(record, 0.25), 0.25);
    near(timeAt(record, 1.2), 1);
    near(timeAt(record, 1.9), 1.5);
    const numbers = timeNumbers(record);
    assert.deepEqual(numbers.map((n) => n.text), ["0", "0.5", "1", "1.5", "2"]);
    [0, 0.5, 1, 1.9, 2.4].forEach((t, i) => near(numbers[i]?.t ?? NaN, t));
  });
  it("has the drives' torques, and a table of all", () => {
    const wheel = { name: "wheel", loops: [], layers: [], feature_names: {}, motion: { type: "revolute" as const, center: { x: 0, y: 0 }, range: null } };
    const series = seriesOf(record, [wheel], { fixed: "", moving: "" }, "mm");
    assert.deepEqual(series.map((s) => [s.name, s.unit, s.hi]), [["wheel", undefined, 5], ["wheel torque", "mN·mm", 4]]);
    const lines = csvOf(record, series, "mm").trimEnd().split("\r\n");
    assert.equal(lines.length, 1 + samples.length);
    assert.equal(lines[0], 'time (s),"wheel (deg)","wheel torque (mN·mm)"');
    assert.equal(lines[1], "0,0,1");
    assert.equal(lines[2], "1,180,2");
    assert.equal(lines.at(-1)?.split(",")[0], "2");
  });
  it("is none of a planned path", () => {
    const path = readRecord("p", { verdict: "path", path: [[0, 1], [2, 3]] });
    assert.deepEqual([timeNumbers(path), stretches(path)], [[], []]);
    assert.match(csvOf(path, seriesOf(path, [], { fixed: "a", moving: "b" }), null), /^share of the way,"a","b"\r\n0,0,1\r\n1,2,3\r\n$/);
  });
});

describe("frames of the 3-D view", () => {
  /** A card that has finished what it was sent, after so long (ms). */
  const after = (took: number) => {
    const gl = { fenceSync: () => ({}), flush: () => {}, getSyncParameter: () => 1, deleteSync: () => {}, SIGNALED: 1, SYNC_STATUS: 0, SYNC_GPU_COMMANDS_COMPLETE: 0 };
    const pace = new Pace(gl as unknown as WebGL2RenderingContext);
    let now = 0;
    const clock = mock.method(performance, "now", () => now);
    pace.sent();
    now = took;
    const busy = pace.isBusy();
    clock.mock.restore();
    assert.equal(busy, false);
    return [pace.next(false, false), pace.next(true, false), pace.next(true, true)];
  };
  it("are coarse while something is dragged, or none where also these are slow", () => {
    assert.deepEqual(after(1), ["fine", "fine", "coarse"]);
    assert.deepEqual(after(36), ["fine", "coarse", "coarse"]);
    assert.deepEqual(after(60), ["fine", "coarse", "none"]);
  });
});

describe("the hand", () => {
  it("goes in steps that people count in, finer when zoomed in", () => {
    const [far, near] = [gridStep({ pixel: { x: 0.1, y: 0.1 } }), gridStep({ pixel: { x: 0.01, y: 0.01 } })];
    assert.ok(far === 0.5 && near === 0.05, `${far} ${near}`);
    assert.deepEqual(snapped({ x: 4.36486338, y: -0.01 }, 0.1), { x: 4.4, y: 0 });
  });
  it("is not under the lens, which stays where it is as long as it can", () => {
    const size = { width: 600, height: 400 };
    const free = lensCorner({ x: 100, y: 300 }, 150, size, 0);
    assert.deepEqual(free, { corner: 0, at: { x: 440, y: 10 } });
    for (const was of [0, 1, 2, 3]) {
      for (let x = 0; x <= 600; x += 20) {
        for (let y = 0; y <= 400; y += 20) {
          const { at } = lensCorner({ x, y }, 150, size, was);
          assert.ok(x < at.x || x > at.x + 150 || y < at.y || y > at.y + 150, `${x}, ${y} under ${JSON.stringify(at)}`);
        }
      }
    }
    // A narrow view, as on a phone: 0.4 of it.
    const small = { width: 180, height: 180 };
    const { at } = lensCorner({ x: 90, y: 90 }, 72, small, 0);
    assert.ok(at.x >= 90 || at.x + 72 <= 90);
  });
});

/** What is told in words and drawn beside the views, from made-up answers of a kernel and made-up records. */

import assert from "node:assert/strict";
import { join } from "node:path";
import { describe, it } from "node:test";
import type { Kernel, PlanarConfiguration, PlanarKernel } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import type { Scene, ScenePair, SceneRange } from "../src/scene.js";
import { firstPair } from "../src/ui/first-pair.js";
import { labelPlace } from "../src/ui/label-place.js";
import { lensBox } from "../src/ui/lens.js";
import { graphOf, seriesOf, valueAt } from "../src/ui/record-series.js";
import { readRecord } from "../src/ui/records.js";
import { regionName, regionNames } from "../src/ui/region-names.js";
import { stepTo } from "../src/ui/step-band.js";
import { rimOf } from "../src/ui/surface-rim.js";
import { details, headline, standing } from "../src/ui/verdict.js";
import type { Told } from "../src/ui/verdict.js";
import { MODELS, NO_COMMAND, binary, run } from "./support/command.js";
import { sceneOf, withModel } from "./support/scene.js";

const regions = [true, false].map((unbounded) => ({ unbounded, sample: [0, 0, 0], ranges: null }));

function told(classification: Told["where"]["classification"], region: number | null, patches: number[] = []): Told {
  const kernel = { patch: () => ({ region: 1 }) } as unknown as Kernel;
  return { pair: { class: "general", regions, resolution: 1e-9 }, kernel, where: { classification, fits: false, region, touching: [], nearest: null, patches }, fixed: "lock", moving: "bolt", axes: null, pushes: null, cage: [], others: false, whole: false, displaced: false, unit: "mm" };
}

describe("regions", () => {
  it("are called by what they are", () => {
    assert.deepEqual([0, 1].map((i) => regionName({ class: "general", regions }, i)), ["outside", "pocket 1"]);
    assert.equal(regionName({ class: "fixed-axes", regions }, 1), "region 1");
    assert.equal(regionNames({ class: "general", regions: [...regions, ...regions.slice(1)] }, [0, 1, 2]), "outside, pockets 1, 2");
    assert.equal(regionNames({ class: "fixed-axes", regions }, [0, 1]), "regions 0, 1");
  });
});

describe("the verdict", () => {
  it("is whether the part can leave", () => {
    assert.equal(headline(told("free", 1)), "bolt cannot leave: caged by lock.");
    assert.equal(headline(told("free", 0)), "bolt can leave.");
    assert.equal(headline(told("contact", null, [3])), "bolt cannot leave: caged by lock.");
    assert.equal(headline({ ...told("free", 1), cage: ["left lip", "right lip"] }), "bolt cannot leave: caged by left lip and right lip of lock.");
    assert.equal(headline({ ...told("contact", 0), others: true }), "bolt can leave, the other parts left aside: it touches lock, and is not caged.");
    const blocked = told("blocked", null);
    const fits = { ...blocked, where: { ...blocked.where, fits: true } };
    assert.match(headline(blocked), /overlap/);
    assert.equal(headline(fits), "bolt fits lock without play.");
    const all = [told("free", 1), told("contact", null, [3]), told("free", 0), blocked, fits, told(null, null)];
    assert.deepEqual(all.map(standing), ["caged", "caged", "leaves", "overlap", null, null]);
  });
  it("says where parts on axes can go", () => {
    const on = (u: SceneRange, v: SceneRange): Told => ({
      ...told("contact", 0),
      pair: { class: "fixed-axes", regions: [{ unbounded: false, sample: [0, 0], ranges: [u, v] }], resolution: 1e-9 },
      axes: [{ kind: "angle", lo: 0, hi: 9, round: false }, { kind: "length", lo: -1, hi: 2.5, round: false }],
      others: true,
    });
    const range = (lo: number, hi: number, around = false, open: [boolean, boolean] = [false, false]) => ({ lo, hi, open, around });
    assert.equal(headline(on(range(0, 1, true), range(0, 1, true))), "lock and bolt turn together for ever.");
    assert.equal(headline(on(range(0, Math.PI / 6), range(-1, 2.5))), "lock turns by 30°, bolt slides by 3.5 mm (its own limits).");
    assert.equal(headline(on(range(0, 1, true), range(0, 1, false, [false, true]))), "lock turns for ever, bolt slides without limit one way.");
    assert.deepEqual(details(on(range(0, 1), range(0, 1)), []), ["They touch.", "Only these two parts count here: the others are left out."]);
  });
  it("has the play of a cage, to three digits", () => {
    const way = (coordinate: "x" | "y" | "theta", width: number) => ({ coordinate, kind: coordinate === "theta" ? ("angle" as const) : ("length" as const), back: width / 4, forth: (3 * width) / 4 });
    assert.deepEqual(details(told("free", 1), [way("x", 0.123456), way("y", Infinity), way("theta", Math.PI / 180)]), ["Play from here: 0.123 mm along x, any length along y; without shifting it turns by 1°."]);
    assert.deepEqual(details(told("blocked", null), []), []);
  });
});

describe("the lens", () => {
  const room = (across: number, up: number) => ({ across: { back: 0, forth: across }, up: { back: up / 2, forth: up / 2 } });
  const pixel = { x: 1, y: 1 };
  it("is there where room is less than the mark covers, and shows all of it", () => {
    const box = lensBox({ x: 5, y: 7 }, room(4, 2), pixel, 150)!;
    assert.ok(box.x0 < 5 && box.x1 > 9 && box.y0 < 6 && box.y1 > 8, JSON.stringify(box));
    assert.equal(lensBox({ x: 5, y: 7 }, room(40, 60), pixel, 150), null);
  });
  it("shows the width of a long corridor, and nothing where there is no room at all", () => {
    const box = lensBox({ x: 5, y: 7 }, room(1000, 0.01), pixel, 150)!;
    assert.ok(box.y1 - box.y0 < 0.1 && box.x0 < 5 && box.x1 > 5, JSON.stringify(box));
    // A peg in its hole, that may leave upwards.
    const hole = lensBox({ x: 5, y: 7 }, room(0.1, Infinity), pixel, 150)!;
    assert.ok(hole.x0 < 5 && hole.x1 > 5.1 && hole.x1 - hole.x0 < 1 && hole.y0 < 7 && hole.y1 > 7, JSON.stringify(hole));
    assert.equal(lensBox({ x: 5, y: 7 }, room(0, 0), pixel, 150), null);
    assert.equal(lensBox({ x: 5, y: 7 }, room(0, Infinity), pixel, 150), null);
  });
});

describe("a step of a band", () => {
  const steps = (kernel: PlanarKernel, from: PlanarConfiguration, region: number | null, by: 1 | -1) => {
    const all: PlanarConfiguration[] = [];
    for (let at: PlanarConfiguration | null = from; (at = stepTo(kernel, at, region, by, 50)) && all.length < 99; ) all.push(at);
    return all;
  };
  it("is upwards or downwards by one band alone, without overlap, until the part turns no further", { skip: binary() === null && NO_COMMAND }, () => {
    // From where they are drawn: a bolt that is caged, and a peg in a hole that it fits tightly.
    withModel(run(["new", "latch"]), (latch) => {
      for (const [model, region, least] of [[latch, 1, 2], [join(MODELS, "peg_hole.toml"), null, 1]] as const) {
        const kernel = openPair(sceneOf(model), 0) as unknown as PlanarKernel;
        for (const by of [1, -1] as const) {
          const from = { x: 0, y: 0, theta: 0 };
          const way = steps(kernel, from, region, by);
          assert.ok(way.length >= least && way.length < 5, `${model}: ${way.length} steps`);
          [from, ...way].reduce((a, b) => {
            assert.ok(by * (b.theta - a.theta) > 0, JSON.stringify({ a, b }));
            assert.equal(Math.abs(kernel.bandAt(b.theta) - kernel.bandAt(a.theta)), 1);
            assert.notEqual(kernel.classify(b), "blocked");
            assert.ok(Math.hypot(b.x - a.x, b.y - a.y) < 1, JSON.stringify({ a, b }));
            return b;
          });
        }
      }
    });
  });
  it("goes all the way round where nothing is in the way", { skip: binary() === null && NO_COMMAND }, () => {
    const kernel = openPair(sceneOf(join(MODELS, "ball_in_c.toml")), 0) as unknown as PlanarKernel;
    const way = steps(kernel, { x: 0, y: 0, theta: 0 }, 1, -1);
    assert.equal(way.length, 99);
    assert.ok(way.every(({ theta }, i) => i === 0 || theta < way[i - 1]!.theta));
  });
  // Two bands; in the second only x > 2 is free.
  const world = (isWall: boolean) => {
    const bandAt = (theta: number) => Math.min(1, Math.floor(theta));
    const isFree = ({ x, theta }: PlanarConfiguration) => bandAt(theta) === 0 || x > 2;
    return {
      bands: [[0, 1], [1, 2]],
      bandAt,
      window: { lo: 0, hi: 2, fullTurn: false },
      classify: (c: PlanarConfiguration) => (isFree(c) ? "free" : "blocked"),
      region: (c: PlanarConfiguration) => (isFree(c) ? 1 : null),
      // Upwards along x = 2, free space on its right.
      slice: (theta: number) => (bandAt(theta) === 1 ? [{ patch: 0, region: 1, points: Float64Array.of(2, -9, 2, 9) }] : []),
      // A wall at x = 1 keeps what comes from the right.
      slide: (from: PlanarConfiguration, to: PlanarConfiguration) => ({ at: !isFree(to) || (isWall && from.x > 1 && to.x < 1) ? from : to, stopped: 0 }),
    } as unknown as PlanarKernel;
  };
  it("goes to the nearest free place of the region, if the part turns back from there", () => {
    const at = stepTo(world(false), { x: 0, y: 4, theta: 0.5 }, 1, 1, 10)!;
    assert.ok(at.theta === 1.5 && at.x > 2 && at.x < 2.01 && Math.abs(at.y - 4) < 0.01, JSON.stringify(at));
    assert.equal(stepTo(world(true), { x: 0, y: 4, theta: 0.5 }, 1, 1, 10), null);
    assert.deepEqual(stepTo(world(true), { x: 5, y: 4, theta: 0.5 }, 1, 1, 10), { x: 5, y: 4, theta: 1.5 });
  });
});

describe("graphs", () => {
  const samples = Array.from({ length: 5001 }, (_, i) => ({ t: i / 1000, wheel: i === 2500 ? 9 : Math.sin(i / 100), rest: 1 }));
  const record = readRecord("run", { parts: ["wheel", "rest"], samples, events: [], status: "done" });
  const [wheel, ...others] = seriesOf(record, [{ name: "wheel", loops: [], layers: [], feature_names: {}, motion: { type: "revolute", center: { x: 0, y: 0 }, range: null } }], { fixed: "", moving: "" });
  it("are of what changes, and keep extremes when they are thinned", () => {
    assert.ok(wheel && others.length === 0);
    assert.equal(wheel.kind, "angle");
    const points = graphOf(wheel, 5, 100);
    assert.ok(points.length < 500);
    assert.equal(Math.max(...points.map(([, y]) => y)), 1);
    assert.ok(points.every(([x], i) => i === 0 || x >= points[i - 1]![0]));
  });
  it("have the value that is played", () => {
    assert.ok(wheel);
    assert.equal(valueAt(wheel, 2.5004, false), 9);
    assert.ok(Math.abs(valueAt(wheel, 2.5005, true) - (9 + Math.sin(25.01)) / 2) < 1e-9);
  });
});

describe("names and rims", () => {
  const corners = (points: [number, number][]) => points.map(([x, y]) => ({ x, y, bulge: 0 }));
  it("stand in the material", () => {
    // A C whose middle is empty: its back is the widest.
    const c = corners([[0, 0], [10, 0], [10, 2], [2, 2], [2, 8], [10, 8], [10, 10], [0, 10]]);
    const { at, width } = labelPlace([c])!;
    assert.equal(width, 10);
    assert.ok(at.x === 5 && (at.y < 2 || at.y > 8), JSON.stringify(at));
    assert.equal(labelPlace([]), null);
  });
  it("are the edges of one triangle only", () => {
    const rim = rimOf([0, 1, 2, 2, 1, 3]);
    const pairs = Array.from({ length: rim.length / 2 }, (_, i) => [rim[2 * i]!, rim[2 * i + 1]!].sort().join("-"));
    assert.deepEqual(pairs.sort(), ["0-1", "0-2", "1-3", "2-3"]);
  });
});

describe("the first pair", () => {
  const square = (x: number) => ({ name: "", layers: [], feature_names: {}, motion: { type: "planar" as const }, loops: [[[x, 0], [x + 1, 0], [x + 1, 1]].map(([a = 0, b = 0]) => ({ x: a, y: b, bulge: 0 }))] });
  const pair = (more: object): ScenePair => ({ fixed: 0, moving: 1, class: "general", space: null, error: null, regions: [regions[0]!], ...more }) as unknown as ScenePair;
  const scene = (pairs: ScenePair[]) => ({ parts: [square(0), square(1), square(9)], pairs, show: { pair: null, question: null, view: null } }) as unknown as Scene;
  it("is one that matters", () => {
    const joint = pair({ class: "lower" });
    const apart = pair({ moving: 2 });
    const never = pair({ space: JSON.stringify({ patches: [] }) });
    const near = pair({});
    const caged = pair({ moving: 2, regions });
    assert.equal(firstPair(scene([joint, apart, never, near])), 3);
    assert.equal(firstPair(scene([joint, never, apart])), 2);
    assert.equal(firstPair(scene([joint, never])), 1);
    assert.equal(firstPair(scene([near, caged])), 1);
    assert.equal(firstPair(scene([near, near])), 0);
    assert.equal(firstPair({ ...scene([caged, near, joint]), show: { pair: 2, question: null, view: null } }), 2);
  });
});

/** Placements, the mechanism that follows a pair, and outlines with arcs. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import type { PlanarConfiguration } from "../src/kernel/api.js";
import type { Scene, SceneMotion, SceneVertex } from "../src/scene.js";
import { configurationOf, placed } from "../src/ui/mechanism.js";
import { arcOf, boxOf, bulgeOfRadius, bulgeThrough, edgeOf, featurePlace, middleOf } from "../src/ui/outline.js";
import { IDENTITY, apply, compose, coordinateOf, inverse, ofMotion, wrap } from "../src/ui/placement.js";
import type { Placement } from "../src/ui/placement.js";

const TOLERANCE = 1e-12;

function near(a: object, b: object): void {
  const of = (o: object) => Object.values(o) as number[];
  assert.ok(of(a).every((x, i) => Math.abs(x - (of(b)[i] ?? NaN)) < TOLERANCE), `${JSON.stringify(a)} is not ${JSON.stringify(b)}`);
}

describe("placements", () => {
  const a: Placement = { x: 3, y: -1, theta: 0.7 };
  const b: Placement = { x: -2, y: 5, theta: -2.1 };

  it("are composed from right to left and undone", () => {
    near(apply(compose(a, b), { x: 1, y: 2 }), apply(a, apply(b, { x: 1, y: 2 })));
    near(compose(a, inverse(a)), IDENTITY);
    near(compose(inverse(a), a), IDENTITY);
  });

  it("follow motions as models define them", () => {
    // c + R_u (q - c): a quarter turn about (2, 1) takes (3, 1) to (2, 2).
    near(apply(ofMotion({ type: "revolute", center: { x: 2, y: 1 }, range: null }, Math.PI / 2), { x: 3, y: 1 }), { x: 2, y: 2 });
    // q + s d / |d|.
    near(apply(ofMotion({ type: "prismatic", direction: { x: 3, y: 4 }, range: null }, 10), { x: 1, y: 1 }), { x: 7, y: 9 });
    for (const motion of [
      { type: "revolute", center: { x: 2, y: 1 }, range: null },
      { type: "prismatic", direction: { x: 3, y: 4 }, range: null },
    ] satisfies SceneMotion[]) {
      assert.ok(Math.abs(coordinateOf(motion, ofMotion(motion, 1.25)) - 1.25) < TOLERANCE);
    }
  });

  it("wrap orientations into a turn", () => {
    assert.ok(Math.abs(wrap(7, -Math.PI) - (7 - 2 * Math.PI)) < TOLERANCE);
    assert.equal(wrap(-Math.PI, -Math.PI), -Math.PI);
  });
});

describe("mechanisms", () => {
  const part = (name: string, motion: SceneMotion) => ({ name, loops: [], layers: [], feature_names: {}, motion });
  const scene = {
    format: "cspace-scene",
    version: 1,
    name: "",
    unit: null,
    parts: [
      part("ratchet", { type: "revolute", center: { x: 0, y: 0 }, range: null }),
      part("pawl", { type: "planar" }),
      part("link", { type: "revolute", center: { x: 1, y: 0 }, range: null }),
      part("plate", { type: "planar" }),
      part("far", { type: "planar" }),
    ],
    joints: [
      { type: "revolute", parts: [2, 1], at: { x: 5, y: 0 }, direction: null },
      { type: "prismatic", parts: [1, 3], at: { x: 0, y: 0 }, direction: { x: 1, y: 0 } },
    ],
    pairs: [{ fixed: 0, moving: 1, class: "general" } as Scene["pairs"][number], { fixed: 0, moving: 2, class: "fixed-axes" } as Scene["pairs"][number]],
    show: { pair: null, question: null, view: null },
    records: [],
  design: null,
  source: null,
  } satisfies Scene;
  const [general, axes] = scene.pairs as [Scene["pairs"][number], Scene["pairs"][number]];
  const rest = scene.parts.map(() => IDENTITY);

  it("place the moving part in the frame of the fixed one", () => {
    const turned = rest.map((p, i) => (i === 0 ? ofMotion(scene.parts[0]?.motion ?? { type: "fixed" }, Math.PI / 2) : p));
    const c: PlanarConfiguration = { x: 2, y: 0, theta: 0.5 };
    const now = placed(scene, general, turned, c);
    near(now[1] ?? {}, { x: 0, y: 2, theta: Math.PI / 2 + 0.5 });
    near(configurationOf(scene, general, now), c);
  });

  it("place the fixed part where the moving one stays", () => {
    const c: PlanarConfiguration = { x: 2, y: 1, theta: 0.5 };
    const now = placed(scene, general, rest, c, "moving");
    near(now[1] ?? {}, IDENTITY);
    near(configurationOf(scene, general, now), c);
  });

  it("read (u, v) off both parts", () => {
    near(configurationOf(scene, axes, placed(scene, axes, rest, { u: 0.25, v: -0.5 })), { u: 0.25, v: -0.5 });
  });

  it("take joined parts along and leave others", () => {
    // The pawl's pin goes from (5, 0) to (1, 4): the link turns a quarter about (1, 0).
    const now = placed(scene, general, rest, { x: -4, y: 4, theta: 0 });
    near(apply(now[2] ?? IDENTITY, { x: 5, y: 0 }), { x: 1, y: 4 });
    near(now[3] ?? {}, now[1] ?? IDENTITY);
    near(now[4] ?? {}, IDENTITY);
  });
});

describe("outlines", () => {
  const half: SceneVertex[] = [
    { x: 1, y: 0, bulge: 1 },
    { x: -1, y: 0, bulge: 0 },
  ];

  it("have arcs as bulges say", () => {
    // Counter-clockwise from (1, 0) over (0, 1) to (-1, 0).
    const edge = edgeOf(half, 0);
    assert.ok(edge);
    near(middleOf(edge), { x: 0, y: 1 });
    const arc = arcOf(edge);
    assert.ok(arc);
    near({ ...arc.center, radius: arc.radius, start: arc.start, sweep: arc.sweep }, { x: 0, y: 0, radius: 1, start: 0, sweep: Math.PI });
    near(boxOf([half]), { x0: -1, y0: 0, x1: 1, y1: 1 });
  });

  it("find bulges by a point and by a radius, on both sides and beyond a half circle", () => {
    for (const bulge of [0.3, -0.3, 0.9, 2.5, -4]) {
      const edge = { from: { x: 1, y: 2 }, to: { x: 4, y: -2 }, bulge };
      assert.ok(Math.abs(bulgeThrough(edge, middleOf(edge)) - bulge) < TOLERANCE);
      assert.ok(Math.abs((bulgeOfRadius(edge, arcOf(edge)?.radius ?? NaN) ?? NaN) - bulge) < TOLERANCE);
      const ends = arcOf(edge);
      assert.ok(ends);
      near({ x: ends.center.x + ends.radius * Math.cos(ends.start + ends.sweep), y: ends.center.y + ends.radius * Math.sin(ends.start + ends.sweep) }, edge.to);
    }
    assert.equal(bulgeOfRadius({ from: { x: 0, y: 0 }, to: { x: 4, y: 0 }, bulge: 0.5 }, 1.9), null);
  });

  it("find features by the names that are printed, and by the model's own", () => {
    const named = { name: "p", loops: [half], layers: [], feature_names: { "convex arc 0 of loop 0": "nose" }, motion: { type: "planar" as const } };
    assert.deepEqual(featurePlace(named, "nose"), { kind: "edge", loop: 0, index: 0 });
    assert.deepEqual(featurePlace(named, "vertex 1 of loop 0"), { kind: "vertex", loop: 0, index: 1 });
    assert.equal(featurePlace(named, "line 7 of loop 0"), null);
    assert.equal(featurePlace(named, "line 0 of loop 0 of the fixed part"), null);
  });
});

/** What is drawn is where the contact is, faces free space, and leaves no gaps. */

import assert from "node:assert/strict";
import { test } from "node:test";
import type { AxesKernel, PlanarKernel } from "../src/kernel/api.js";
import { openPair } from "../src/kernel/index.js";
import { binary, models, NO_COMMAND, times } from "./support/command.js";
import { sizeOf } from "./support/places.js";
import { random } from "./support/random.js";
import { sceneOf } from "./support/scene.js";

const skip = binary() ? false : NO_COMMAND;

test("surfaces are at contact and face free space", { skip }, async (t) => {
  for (const model of models()) {
    const scene = sceneOf(model);
    for (const [index, pair] of scene.pairs.entries()) {
      const kernel = openPair(scene, index) as unknown as PlanarKernel;
      if (!kernel || kernel.coordinates !== "planar" || pair.class === "lower") continue;
      await t.test(`${model.split("/models/")[1]} ${index}`, (t) => {
        const next = random(9);
        const size = sizeOf(kernel);
        const start = performance.now();
        let triangles = 0;
        const step = Math.ceil(kernel.patchCount / times(300, 100));
        for (let patch = 0; patch < kernel.patchCount; patch += step) {
          const { positions, normals, indices } = kernel.surface(patch, 2e-4 * size, size / 6);
          triangles += indices.length / 3;
          assert.ok(positions.every(Number.isFinite) && normals.every(Number.isFinite), `patch ${patch}`);
          const k = 3 * Math.floor((next() * positions.length) / 3);
          // Positions are in single precision.
          const c = { x: positions[k]!, y: positions[k + 1]!, theta: positions[k + 2]! };
          const [lo, hi] = kernel.patch(patch).orientations!;
          assert.ok(c.theta >= lo - 1e-6 && c.theta <= hi + 1e-6);
          assert.ok(Math.abs(kernel.nearest(c)!.distance) < 1e-3 * size, `patch ${patch} ${JSON.stringify(c)}`);
          let [whole, faced] = [0, 0];
          for (let i = 0; i < indices.length; i += 3) {
            const corner = (j: number) => {
              const at = 3 * indices[i + j]!;
              return [positions[at]!, positions[at + 1]!, (positions[at + 2]! * size) / 6];
            };
            const [a, b, d] = [corner(0), corner(1), corner(2)];
            const [u, v] = [b.map((x, n) => x - a[n]!), d.map((x, n) => x - a[n]!)];
            const face = [u[1]! * v[2]! - u[2]! * v[1]!, u[2]! * v[0]! - u[0]! * v[2]!, u[0]! * v[1]! - u[1]! * v[0]!];
            const at = 3 * indices[i]!;
            const facing = face[0]! * normals[at]! + face[1]! * normals[at + 1]! + face[2]! * normals[at + 2]!;
            whole += Math.hypot(...face);
            faced += facing;
          }
          // Where an end moves with the square root of the orientation triangles are as steep as the deviation lets them be.
          assert.ok(faced >= 0.5 * whole || whole < 1e-9 * size * size, `patch ${patch}: ${faced} of ${whole}`);
        }
        t.diagnostic(`${triangles} triangles of every ${step}th patch, ${(performance.now() - start).toFixed(0)} ms`);
      });
    }
  }
});

test("the slice's loops are closed, and free space is on their right", { skip }, () => {
  for (const model of models().filter((m) => /gears.toml|peg|ball|ratchet_pawl/.test(m))) {
    const kernel = openPair(sceneOf(model), 0) as unknown as PlanarKernel;
    if (kernel.coordinates !== "planar") continue;
    const size = sizeOf(kernel);
    for (let theta = -3; theta < 3; theta += 0.37) {
      const curves = kernel.slice(theta, 1e-9 * size);
      for (const { points } of curves) {
        const n = points.length;
        const starts = curves.some((d) => Math.hypot(d.points[0]! - points[n - 2]!, d.points[1]! - points[n - 1]!) < 1e-6 * size);
        assert.ok(starts, `${model} ${theta}`);
        const [dx, dy] = [points[2]! - points[0]!, points[3]! - points[1]!];
        const long = Math.hypot(dx, dy);
        if (long < 1e-6 * size) continue;
        // Farther beside than chords are off their arcs.
        const by = 2e-2 * long;
        const [x, y] = [0.5 * (points[0]! + points[2]!), 0.5 * (points[1]! + points[3]!)];
        const beside = (s: number) => kernel.classify({ x: x + (s * by * dy) / long, y: y - (s * by * dx) / long, theta });
        assert.equal(beside(1), "free", `${model} ${theta}`);
        assert.equal(beside(-1), "blocked", `${model} ${theta}`);
      }
    }
  }
});

/** Twice the signed area, and whether a point is inside, by crossings. */
function holds(points: Float64Array, x: number, y: number): boolean {
  let inside = false;
  const n = points.length / 2;
  for (let i = 0, j = n - 1; i < n; j = i++) {
    const [ax, ay, bx, by] = [points[2 * i]!, points[2 * i + 1]!, points[2 * j]!, points[2 * j + 1]!];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  }
  return inside;
}

test("the free polygons of a plane are its free space, each once", { skip }, async (t) => {
  for (const model of models()) {
    const scene = sceneOf(model);
    for (const [index] of scene.pairs.entries()) {
      const kernel = openPair(scene, index) as unknown as AxesKernel;
      if (!kernel || kernel.coordinates !== "axes") continue;
      await t.test(`${model.split("/models/")[1]} ${index}`, () => {
        const polygons = kernel.free(1e-5);
        const next = random(10);
        const { u, v } = kernel;
        let wrong = 0;
        const count = times(1500, 500);
        for (let k = 0; k < count; k++) {
          const at = (a: typeof u) => (a.kind === "still" ? 0 : a.lo + (a.hi - a.lo) * next());
          const c = { u: at(u), v: at(v) };
          const found = polygons.filter((p) => holds(p.points, c.u, c.v));
          assert.ok(found.length <= 1);
          const free = kernel.classify(c) === "free";
          if (free !== (found.length === 1)) wrong++;
          else if (free) assert.equal(kernel.region(c), found[0]!.region);
        }
        // As much as a deviation of 1e-5 lets be.
        assert.ok(wrong <= 2, `${wrong} of ${count}`);
      });
    }
  }
});

/** Edits of outlines: radii stay, divided edges lie where they lay. Arcs are measured here by three of their points. */

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import type { Place, SceneVertex } from "../src/scene.js";
import { addVertex, bend, circleOf, moveVertex, removeVertex, setRadius } from "../src/ui/edit-shape.js";
import type { Loop } from "../src/ui/edit-shape.js";

/** A slot: two half circles of radius 5 and two lines. */
const slot: Loop = [
  { x: -10, y: -5, bulge: 0 },
  { x: 10, y: -5, bulge: 1 },
  { x: 10, y: 5, bulge: 0 },
  { x: -10, y: 5, bulge: 1 },
];
/** A block with a rounded corner of radius 4. */
const rounded: Loop = [
  { x: 0, y: 0, bulge: 0 },
  { x: 20, y: 0, bulge: 0 },
  { x: 20, y: 16, bulge: Math.tan(Math.PI / 8) },
  { x: 16, y: 20, bulge: 0 },
  { x: 0, y: 20, bulge: 0 },
];
const bore: Loop = [
  { x: -3, y: 1, bulge: 1 },
  { x: 5, y: 1, bulge: 1 },
];

/** A point of an edge, by the definition of the bulge: its sagitta is half the chord times the bulge, to the chord's right. */
function middle(a: SceneVertex, b: Place): Place {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  return { x: (a.x + b.x) / 2 + (a.bulge / 2) * dy, y: (a.y + b.y) / 2 - (a.bulge / 2) * dx };
}

/** The radius of the circle through three points: the product of the sides by four times the area. */
function radius(loop: Loop, index: number): number {
  const [a, c] = [loop[index]!, loop[(index + 1) % loop.length]!];
  const b = middle(a, c);
  const side = (p: Place, q: Place) => Math.hypot(p.x - q.x, p.y - q.y);
  const area = Math.abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  return (side(a, b) * side(b, c) * side(c, a)) / (4 * area);
}

const near = (a: number, b: number) => assert.ok(Math.abs(a - b) < 1e-9 * (1 + Math.abs(b)), `${a} is not ${b}`);

describe("a vertex that is moved", () => {
  it("keeps the radii of both arcs beside it", () => {
    near(radius(moveVertex(rounded, 2, { x: 20, y: 15 }), 2), 4);
    near(radius(moveVertex(rounded, 3, { x: 17, y: 20 }), 2), 4);
    const moved = moveVertex(slot, 2, { x: 9, y: 4 });
    near(radius(moved, 1), 5);
    near(radius(moved, 3), 5);
    assert.deepEqual({ x: moved[2]!.x, y: moved[2]!.y }, { x: 9, y: 4 });
  });
  it("gives the arc the least radius that reaches, where ends are too far apart", () => {
    const moved = moveVertex(slot, 2, { x: 10, y: 9 });
    near(radius(moved, 1), 7);
  });
  it("moves a bore as a whole", () => {
    assert.deepEqual(circleOf(bore), { center: { x: 1, y: 1 }, radius: 4 });
    const moved = moveVertex(bore, 1, { x: 7, y: 4 });
    assert.deepEqual(circleOf(moved), { center: { x: 3, y: 4 }, radius: 4 });
    assert.equal(circleOf(slot), null);
  });
});

describe("radii", () => {
  it("are those of the whole bore", () => {
    const wider = setRadius(bore, 0, 6)!;
    near(radius(wider, 0), 6);
    near(radius(wider, 1), 6);
    const { center, radius: r } = circleOf(bend(bore, 1, { x: 1, y: -1 }))!;
    near(Math.hypot(center.x - 1, center.y - 1), 0);
    near(r, 2);
  });
  it("are refused where no arc reaches", () => {
    assert.equal(setRadius(slot, 1, 4.9), null);
    near(radius(setRadius(rounded, 2, 3)!, 2), 3);
  });
});

describe("vertices", () => {
  it("divide an edge, which stays where it was", () => {
    const divided = addVertex(rounded, 2, { x: 30, y: 27 })!;
    assert.equal(divided.length, rounded.length + 1);
    near(radius(divided, 2), 4);
    near(radius(divided, 3), 4);
    near(Math.hypot(divided[3]!.x - 16, divided[3]!.y - 16), 4);
    assert.deepEqual(addVertex(rounded, 0, { x: 5, y: 3 })![1], { x: 5, y: 0, bulge: 0 });
    assert.equal(addVertex(rounded, 0, { x: -5, y: 3 }), null);
  });
  it("of an arc that is divided and made one again are where they were", () => {
    const again = removeVertex(addVertex(slot, 1, { x: 16, y: 1 })!, 2)!;
    again.forEach((v, i) => {
      near(v.x, slot[i]!.x);
      near(v.y, slot[i]!.y);
      near(v.bulge, slot[i]!.bulge);
    });
  });
  it("are removed until nothing would be left", () => {
    const line = removeVertex(rounded, 2)!;
    assert.equal(line.length, 4);
    assert.equal(line[1]!.bulge, 0);
    const triangle: Loop = [0, 1, 2].map((i) => ({ x: i, y: i * i, bulge: 0 }));
    assert.equal(removeVertex(triangle, 1), null);
    assert.equal(removeVertex(bore, 0), null);
  });
});

/** From the motions u and v to the coordinates x and y of the partition, and to where the parts are. */

import { clamp, cross, dot, turnBy, type Point } from "../plane.js";
import { compose, inverse, type Placement } from "../features.js";
import type { AxesSpaceData, AxisData } from "./data.js";
import type { Graphs } from "./graphs.js";
import { INDEPENDENT } from "./tolerance.js";

/** Where a part is after a motion along its axis, in the assembly. */
export function placedBy(axis: AxisData, t: number): Placement {
  const m = axis.motion;
  switch (m.type) {
    case "fixed":
      return { at: { x: 0, y: 0 }, turn: { cos: 1, sin: 0 } };
    case "revolute": {
      const turn = turnBy(t);
      const c = m.center;
      return { at: { x: c.x - (turn.cos * c.x - turn.sin * c.y), y: c.y - (turn.sin * c.x + turn.cos * c.y) }, turn };
    }
    case "prismatic": {
      const share = t / Math.hypot(m.direction.x, m.direction.y);
      return { at: { x: m.direction.x * share, y: m.direction.y * share }, turn: { cos: 1, sin: 0 } };
    }
  }
}

export class PlaneMap {
  private readonly swapped: boolean;
  /** Of two slides along one line without limits only y − share · x counts; null of others. */
  readonly oneLine: number | null;

  constructor(
    private readonly space: AxesSpaceData,
    private readonly graphs: Graphs,
  ) {
    this.swapped = space.map.swapped;
    const { first, second } = graphs.motions;
    this.oneLine =
      first.kind === "slide" &&
      second.kind === "slide" &&
      graphs.x.kind === "Open" &&
      graphs.y.kind === "Open" &&
      Math.abs(cross(first.direction, second.direction)) < INDEPENDENT
        ? dot(first.direction, second.direction)
        : null;
  }

  get isSwapped(): boolean {
    return this.swapped;
  }

  /** x and y without regard to ranges. */
  inner(u: number, v: number): Point {
    const [x, y] = this.swapped ? [v, u] : [u, v];
    return { x: x / this.space.map.x_unit, y: y / this.space.map.y_unit };
  }

  /** u and v of x and y. */
  outer(x: number, y: number): { u: number; v: number } {
    const [a, b] = [x * this.space.map.x_unit, y * this.space.map.y_unit];
    return this.swapped ? { u: b, v: a } : { u: a, v: b };
  }

  /** As {@link outer}, with 0 for a part that does not move. */
  outerMoved(x: number, y: number): { u: number; v: number } {
    const { first, second } = this.graphs.motions;
    return this.outer(first.kind === "still" ? 0 : x, second.kind === "still" ? 0 : y);
  }

  /** x and y of a configuration; null outside the ranges of motion and of what is not finite. */
  placed(u: number, v: number): Point | null {
    let { x, y } = this.inner(u, v);
    if (!Number.isFinite(x) || !Number.isFinite(y)) return null;
    const { x: ofX, y: ofY, motions } = this.graphs;
    if (ofX.isCircle) x = ofX.reduced(x);
    if (ofY.isCircle) y = ofY.reduced(y);
    if (ofX.isLimited && !(ofX.lo <= x && x <= ofX.hi)) return null;
    if (ofY.isLimited && !(ofY.lo <= y && y <= ofY.hi)) return null;
    // A part that does not move is at 0 and nowhere else.
    if ((motions.first.kind === "still" && x !== 0) || (motions.second.kind === "still" && y !== 0)) return null;
    return this.oneLine === null ? { x, y } : { x: 0, y: y - x * this.oneLine };
  }

  /** x and y brought between the ends of what is computed: beyond, nothing touches. */
  into(p: Point): Point {
    const { x, y } = this.graphs;
    return { x: clamp(p.x, x.lo, x.hi), y: clamp(p.y, y.lo, y.hi) };
  }

  /** Where the two parts are in the assembly, and the moving part seen from the fixed one. */
  placements(u: number, v: number): { fixed: Placement; moving: Placement; relative: Placement } {
    const fixed = placedBy(this.space.fixed_axis, u);
    const moving = placedBy(this.space.moving_axis, v);
    return { fixed, moving, relative: compose(inverse(fixed), moving) };
  }
}

/** Is a configuration of two parts on their axes free, and what touches there? */

import type { Classification } from "../api.js";
import type { Overlap } from "../overlap.js";
import type { AxesSpaceData } from "./data.js";
import type { Graphs } from "./graphs.js";
import type { PlaneMap } from "./plane-map.js";
import { Slots } from "./slots.js";
import { ASTRAY, NEAR } from "./tolerance.js";

const SLOTS = 256;

export class AxesClassifier {
  readonly byX: Slots;
  /** How near to a contact counts as contact (length of the frame). */
  private readonly near: number;

  constructor(
    private readonly space: AxesSpaceData,
    private readonly graphs: Graphs,
    private readonly map: PlaneMap,
    private readonly overlap: () => Overlap,
    contactDistance: number,
  ) {
    this.byX = new Slots(graphs.x, SLOTS, space.branches.map((b) => graphs.box(b.cell).x));
    this.near = contactDistance * space.map.frame.scale;
  }

  classify(u: number, v: number): Classification | null {
    const p = this.map.placed(u, v);
    if (!p) return null;
    if (this.isTouching(p.x, p.y)) return "contact";
    const free =
      this.space.statistics.conflicts > 0
        ? !this.overlaps(p.x, p.y)
        : this.graphs.isBeyond(p.x, p.y) || this.graphs.region(p.x, p.y) !== null;
    return free ? "free" : "blocked";
  }

  region(u: number, v: number): number | null {
    const p = this.map.placed(u, v);
    if (!p || this.isTouching(p.x, p.y)) return null;
    const q = this.map.into(p);
    return this.graphs.region(q.x, q.y);
  }

  /** Patches that touch within a distance (model unit), with their contact functions; the nearest first. */
  contacts(u: number, v: number, within: number): [number, number][] {
    const p = this.map.placed(u, v);
    if (!p) return [];
    const { scale } = this.space.map.frame;
    const reach = within * scale;
    const least = new Map<number, number>();
    for (const i of this.byX.near(p.x, Math.max(reach, NEAR))) {
      const b = this.space.branches[i]!;
      const value = this.touch(b.cell, p.x, p.y, Math.max(reach, NEAR), reach);
      if (value === null) continue;
      const known = least.get(b.patch);
      if (known === undefined || Math.abs(value) < Math.abs(known)) least.set(b.patch, value);
    }
    const found = [...least].map(([patch, value]): [number, number] => [patch, value / scale]);
    return found.sort((a, b) => Math.abs(a[1]) - Math.abs(b[1]) || a[0] - b[0]);
  }

  private overlaps(x: number, y: number): boolean {
    const { u, v } = this.map.outerMoved(x, y);
    const { at, turn } = this.map.placements(u, v).relative;
    return this.overlap().at({ x: at.x, y: at.y, theta: Math.atan2(turn.sin, turn.cos) });
  }

  /** Whether a configuration is within the resolution of the free boundary. */
  private isTouching(x: number, y: number): boolean {
    for (const i of this.byX.near(x, this.near)) {
      const { cell } = this.space.branches[i]!;
      if (this.touch(cell, x, y, this.near, this.near) === null) continue;
      // A corner that is all but on a pivot is as near to a side everywhere, deep in blocked space too.
      if (Math.abs(this.aboveCurve(cell, x, y)) <= ASTRAY || !this.overlaps(x, y)) return true;
    }
    return false;
  }

  inBox(cell: number, x: number, y: number, reach: number): boolean {
    const box = this.graphs.box(cell);
    return this.graphs.x.brought(x, box.x, reach) !== null && this.graphs.y.brought(y, box.y, reach) !== null;
  }

  /** The contact function of a cell at a configuration that touches there; null if it does not. */
  touch(cell: number, x: number, y: number, reach: number, within: number): number | null {
    const value = this.graphs.condition(cell).value(x, y);
    const near = Math.abs(value) <= within && this.inBox(cell, x, y, reach);
    return near && this.onOwnRoot(cell, x, y, within) ? value : null;
  }

  /**
   * Whether a configuration at which the contact function vanishes is on the cell's curve: at one x the function has a second root, which may
   * be in the cell's box as well, deep in blocked space. Between the two it is extreme in the middle.
   */
  private onOwnRoot(cell: number, x: number, y: number, within: number): boolean {
    const middle = y - 0.5 * this.aboveCurve(cell, x, y);
    const condition = this.graphs.condition(cell);
    return Math.abs(condition.value(x, middle)) <= Math.max(within, Math.abs(condition.value(x, y)));
  }

  /** How far a configuration is above a cell's curve along y, the shorter way around; 0 of one that is vertical. */
  aboveCurve(cell: number, x: number, y: number): number {
    if (this.graphs.piece(cell).vertical) return 0;
    const c = this.graphs.cell(cell);
    const middle = 0.5 * (c.from + c.to);
    return this.graphs.y.apart(y, this.graphs.at(cell, middle + this.graphs.x.apart(x, middle)));
  }
}

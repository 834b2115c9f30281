/** Ranges of a coordinate, found by place. */

import { clamp, TAU } from "../plane.js";
import type { Extent, Range } from "./extent.js";
import { NEAR } from "./tolerance.js";

export class Slots {
  private readonly lists: number[][];

  constructor(
    private readonly extent: Extent,
    count: number,
    ranges: readonly Range[],
  ) {
    this.lists = Array.from({ length: count }, () => []);
    ranges.forEach(([lo, hi], i) => {
      for (const slot of this.reached(lo, hi)) this.lists[slot]!.push(i);
    });
  }

  /** Ranges that may come nearer to a place than `reach`, ascending. */
  near(t: number, reach: number): readonly number[] {
    return this.between(t - reach, t + reach);
  }

  between(lo: number, hi: number): readonly number[] {
    const slots = this.reached(lo, hi);
    if (slots.length === 1) return this.lists[slots[0]!]!;
    const found = new Set<number>();
    for (const slot of slots) for (const i of this.lists[slot]!) found.add(i);
    return [...found].sort((a, b) => a - b);
  }

  private reached(lo: number, hi: number): number[] {
    const count = this.lists.length;
    const { lo: first, hi: last, isCircle } = this.extent;
    const slot = (t: number) => Math.floor(((t - first) / (last - first)) * count);
    let from = slot(lo - NEAR);
    let to = slot(hi + NEAR);
    if (!isCircle) [from, to] = [clamp(from, 0, count - 1), clamp(to, 0, count - 1)];
    else if (hi - lo >= TAU || to - from >= count) [from, to] = [0, count - 1];
    const found: number[] = [];
    for (let k = from; k <= to; k++) found.push(((k % count) + count) % count);
    return found;
  }
}

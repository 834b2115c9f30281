/** Where a coordinate runs: around a turn, between limits, or as far as contacts reach. */

import { TAU, wrapped } from "../plane.js";
import type { ExtentData } from "./data.js";

export type Range = readonly [number, number];

export class Extent {
  readonly lo: number;
  readonly hi: number;
  readonly kind: ExtentData["kind"];

  constructor(data: ExtentData) {
    this.lo = data.lo;
    this.hi = data.hi;
    this.kind = data.kind;
  }

  get isCircle(): boolean {
    return this.kind === "Circle";
  }

  get isLimited(): boolean {
    return this.kind === "TurnLimits" || this.kind === "SlideLimits";
  }

  /** Brought into the first turn, if it goes around. */
  reduced(t: number): number {
    if (this.kind !== "Circle" && this.kind !== "TurnLimits") return t;
    const r = t - TAU * Math.floor((t - this.lo) / TAU);
    return r >= this.lo + TAU ? this.lo : r;
  }

  /** a − b, the shorter way around a circle. */
  apart(a: number, b: number): number {
    return this.isCircle ? wrapped(a - b) : a - b;
  }

  /** Brought by turns into a range, or no farther from it than `reach`; null if it is not there. */
  brought(t: number, [lo, hi]: Range, reach: number): number | null {
    const at = this.isCircle ? t + TAU * Math.ceil((lo - reach - t) / TAU) : t;
    return lo - reach <= at && at <= hi + reach ? at : null;
  }
}

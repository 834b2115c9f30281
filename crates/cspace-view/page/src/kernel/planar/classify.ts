/** Is a configuration free? */

import type { Classification, PlanarConfiguration } from "../api.js";
import { distanceBelow } from "../curve.js";
import { fromAngle, TAU } from "../plane.js";
import type { Overlap } from "../overlap.js";
import { firstMet } from "./ray.js";
import type { Surface } from "./surface.js";

export interface Located {
  class: Classification;
  /** The region that the curve bounds by which that is told. */
  region: number;
}

/** Of a position from which a ray meets nothing. */
const UNBOUNDED = 0;
/** Around a contact that is in doubt the parts are tested in so many directions. */
const DIRECTIONS = 8;

export class Classifier {
  constructor(
    private readonly surface: Surface,
    private readonly overlap: () => Overlap,
    private readonly contactDistance: number,
  ) {}

  /** Whether a configuration is finite and within the window. */
  covers(c: PlanarConfiguration): boolean {
    const window = this.surface.space.window;
    const within = window.full_turn || (c.theta >= window.lo && c.theta <= window.hi);
    return Number.isFinite(c.x) && Number.isFinite(c.y) && Number.isFinite(c.theta) && within;
  }

  located(c: PlanarConfiguration): Located | null {
    if (!this.covers(c)) return null;
    const slice = this.surface.slice(c.theta);
    let nearest = -1;
    let least = Infinity;
    slice.curves.forEach((curve, i) => {
      const away = distanceBelow(curve.curve, c, least);
      if (away < least || nearest < 0) [least, nearest] = [away, i];
    });
    const near = nearest >= 0 && least <= this.contactDistance && (!slice.doubtful || this.touches(c));
    const met = firstMet(slice, c);
    const bySlice = met === null || met.fromFree;
    const free = !near && slice.doubtful ? !this.overlap().at(c) : bySlice;
    const bounding = free === bySlice ? (met ? met.curve : -1) : nearest;
    const patch = slice.curves[bounding]?.patch;
    return {
      class: near ? "contact" : free ? "free" : "blocked",
      region: patch === undefined ? UNBOUNDED : this.surface.patches[patch]!.region,
    };
  }

  /** Whether of some positions twice the distance of contact away some overlap and some do not. */
  private touches(c: PlanarConfiguration): boolean {
    const overlaps = (k: number): boolean => {
      const d = fromAngle((TAU / DIRECTIONS) * k);
      const by = 2 * this.contactDistance;
      return this.overlap().at({ x: c.x + d.x * by, y: c.y + d.y * by, theta: c.theta });
    };
    const first = overlaps(0);
    for (let k = 1; k < DIRECTIONS; k++) if (overlaps(k) !== first) return true;
    return false;
  }
}

/** How configurations are placed in the 3-D view: z is the orientation, scaled. */

import type { Place } from "../scene.js";
import { rotate, type Placement } from "./placement.js";

export interface SpaceScale {
  /** What is in the middle (model unit). */
  center: [number, number];
  perRadian: number;
  deviation: number;
  /**
   * A point of the moving part, whose places are drawn instead of those of the part's origin; (0, 0) is the origin. A part that is drawn far
   * from its origin swings about it, and the space would be a thin tube about a wide helix.
   */
  arm: Place;
}

const NO_SWING: Place = { x: 0, y: 0 };

/** By how much the drawn place is beside x and y: nothing at orientation 0. */
export function swing({ arm }: SpaceScale, theta: number): Place {
  if (arm.x === 0 && arm.y === 0) return NO_SWING;
  const r = rotate(arm, theta);
  return { x: r.x - arm.x, y: r.y - arm.y };
}

/** Where a configuration is drawn, so many radians above its orientation. */
export function inSpace(scale: SpaceScale, { x, y, theta }: Placement, above = 0): [number, number, number] {
  const aside = swing(scale, theta);
  return [x + aside.x - scale.center[0], y + aside.y - scale.center[1], (theta + above) * scale.perRadian];
}

/** How {@link swing} changes with z. */
export function swingSlope({ arm, perRadian }: SpaceScale, theta: number): Place {
  const r = rotate(arm, theta);
  return { x: -r.y / perRadian, y: r.x / perRadian };
}

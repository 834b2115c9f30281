/** The slice at the current orientation, cut once for all views. */

import type { DrawnCurve, PlanarKernel } from "../kernel/api.js";
import { isPlanar } from "./mechanism.js";
import type { Session } from "./session.js";
import { sliceExtent } from "./slice-extent.js";

/** Curves are drawn within this share of the slice's extent. */
const DEVIATION = 1 / 4000;

interface Cut {
  kernel: PlanarKernel;
  theta: number;
  curves: DrawnCurve[];
}

let last: Cut | null = null;

/** The extent found last, by pair: bounds take longer than slices, and edits change the extent little. */
let known: { pair: number; kernel: PlanarKernel; extent: number } | null = null;

export function extentOf(session: Session, kernel: PlanarKernel): number {
  const { pair, editing } = session.state;
  if (known && (known.kernel === kernel || (editing && known.pair === pair))) return known.extent;
  const { lo, hi } = kernel.bounds();
  known = { pair, kernel, extent: Math.max(hi[0] - lo[0], hi[1] - lo[1]) || 1 };
  return known.extent;
}

/** What is farther away than so many extents of a slice is not shown together with it. */
export const FAR = 8;

/** Whether contacts of other orientations are too far away to be shown together: those of a part that is drawn far from its origin. */
export function swings(session: Session, kernel: PlanarKernel): boolean {
  return extentOf(session, kernel) > FAR * sliceExtent(session.state);
}

/** How many times finer than usual slices are drawn: a power of the step. */
let finer = 1;
const FINER_STEP = 8;
const FINEST = FINER_STEP ** 6;

/** Draws slices within a deviation (model unit), or as usual if that is finer. Whether they are drawn otherwise than before. */
export function refine(session: Session, deviation: number): boolean {
  const usual = sliceExtent(session.state) * DEVIATION;
  const before = finer;
  finer = 1;
  while (usual / finer > deviation && finer < FINEST) finer *= FINER_STEP;
  if (finer !== before) last = null;
  return finer !== before;
}

export function currentSlice(session: Session): DrawnCurve[] {
  const kernel = session.planar;
  const c = session.state.configuration;
  if (!kernel || !isPlanar(c)) return [];
  if (last?.kernel === kernel && last.theta === c.theta) return last.curves;
  last = { kernel, theta: c.theta, curves: kernel.slice(c.theta, (sliceExtent(session.state) * DEVIATION) / finer) };
  return last.curves;
}

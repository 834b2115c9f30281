/** The slice at the current orientation, cut once for all views. */

import type { DrawnCurve, PlanarKernel } from "../kernel/api.js";
import { isPlanar } from "./mechanism.js";
import type { Session } from "./session.js";

/** Curves are drawn within this share of the space's extent. */
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

export function currentSlice(session: Session): DrawnCurve[] {
  const kernel = session.planar;
  const c = session.state.configuration;
  if (!kernel || !isPlanar(c)) return [];
  if (last?.kernel === kernel && last.theta === c.theta) return last.curves;
  last = { kernel, theta: c.theta, curves: kernel.slice(c.theta, extentOf(session, kernel) * DEVIATION) };
  return last.curves;
}

/** The next band: where the moving part is put there, so that it does not overlap what it is to stop at. */

import type { PlanarConfiguration, PlanarKernel } from "../kernel/api.js";
import { TURN, wrap } from "./placement.js";

/** A place beside a contact curve is looked for at this share of the slice's width, and at twice that until it is free. */
const BESIDE = 1e-6;
const DOUBLINGS = 14;
/** A part that turns gives way to contacts so often; each time it is turned on from where it got to. */
const YIELDS = 64;

type Slicing = Pick<PlanarKernel, "bands" | "bandAt" | "window" | "classify" | "region" | "slice" | "slide">;

/**
 * Where a part goes that turns to the next band: as it gets there when it turns and gives way; else to the nearest place of the same region
 * in the middle of that band from which it turns back to where it was. Null if there is none: no band is passed over.
 */
export function stepTo(kernel: Slicing, from: PlanarConfiguration, region: number | null, by: 1 | -1, width: number): PlanarConfiguration | null {
  const here = kernel.bandAt(from.theta);
  const next = neighbour(kernel, here, by);
  const [lo, hi] = kernel.bands[next ?? -1] ?? [0, 0];
  if (next === null || next === here) return null;
  const to = { ...from, theta: from.theta + wrap((lo + hi) / 2 - from.theta, by > 0 ? 0 : -TURN) };
  const turned = turn(kernel, from, to.theta, next);
  if (turned) return turned;
  const at = placeIn(kernel, to, region, width);
  const back = at && turn(kernel, at, from.theta, here);
  const came = back && kernel.slide(back, from).at;
  return came && came.x === from.x && came.y === from.y && came.theta === from.theta ? at : null;
}

/** Turns a part on until it is in a band, while contacts move it aside; null if it gets stuck before. */
function turn(kernel: Slicing, from: PlanarConfiguration, theta: number, band: number): PlanarConfiguration | null {
  for (let at = from, k = 0; k < YIELDS; k += 1) {
    const next = kernel.slide(at, { ...at, theta }).at;
    if (kernel.bandAt(next.theta) === band && kernel.classify(next) !== "blocked") return next;
    if (Math.abs(theta - next.theta) >= Math.abs(theta - at.theta)) return null;
    at = next;
  }
  return null;
}

/** The next band, which goes round if the window does. */
export function neighbour({ bands, window }: Pick<PlanarKernel, "bands" | "window">, band: number, by: 1 | -1): number | null {
  const next = band + by;
  if (window.fullTurn) return (next + bands.length) % bands.length;
  return next >= 0 && next < bands.length ? next : null;
}

/** The place itself if it is free in the region, else the nearest beside one of the region's contact curves. */
function placeIn(kernel: Slicing, to: PlanarConfiguration, region: number | null, width: number): PlanarConfiguration | null {
  const isIn = (c: PlanarConfiguration) => kernel.classify(c) === "free" && (region === null || kernel.region(c) === region);
  if (isIn(to)) return to;
  let nearest: { x: number; y: number; nx: number; ny: number } | null = null;
  let least = Infinity;
  for (const curve of kernel.slice(to.theta, width * BESIDE)) {
    if (region !== null && curve.region !== region) continue;
    const p = curve.points;
    for (let i = 0; i + 3 < p.length; i += 2) {
      const [ax, ay, bx, by] = [p[i] ?? 0, p[i + 1] ?? 0, p[i + 2] ?? 0, p[i + 3] ?? 0];
      const [dx, dy] = [bx - ax, by - ay];
      const length = Math.hypot(dx, dy);
      if (length === 0) continue;
      const f = Math.min(1, Math.max(0, ((to.x - ax) * dx + (to.y - ay) * dy) / (length * length)));
      const [x, y] = [ax + f * dx, ay + f * dy];
      const away = Math.hypot(to.x - x, to.y - y);
      if (away < least) [least, nearest] = [away, { x, y, nx: dy / length, ny: -dx / length }];
    }
  }
  if (!nearest) return null;
  // Free space is on the right of a contact curve.
  for (let k = 0, beside = width * BESIDE; k < DOUBLINGS; k += 1, beside *= 2) {
    const at = { ...to, x: nearest.x + beside * nearest.nx, y: nearest.y + beside * nearest.ny };
    if (isIn(at)) return at;
  }
  return null;
}

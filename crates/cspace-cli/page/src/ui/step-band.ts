/** The next band: where the moving part is put there, so that it does not overlap what it is to stop at. */

import type { PlanarConfiguration, PlanarKernel } from "../kernel/api.js";

export interface Step {
  at: PlanarConfiguration;
  /** Bands that were passed over, because the region has no place in their middles. */
  passed: number;
}

/** A place beside a contact curve is looked for at this share of the slice's width, and at twice that until it is free. */
const BESIDE = 1e-6;
const DOUBLINGS = 14;

type Slicing = Pick<PlanarKernel, "bands" | "bandAt" | "window" | "classify" | "region" | "slice" | "slide">;

/**
 * Where a part goes that turns to the next band: as it gets there when it turns, stopping and sliding; else to the nearest place of the
 * same region in the middle of that band, or of the first band after it in which the region is. Null if there is none.
 */
export function stepTo(kernel: Slicing, from: PlanarConfiguration, region: number | null, by: 1 | -1, width: number): Step | null {
  const count = kernel.bands.length;
  let band = kernel.bandAt(from.theta);
  for (let passed = 0; passed < count; passed += 1) {
    const next = neighbour(kernel, band, by);
    if (next === null) return null;
    band = next;
    const [lo, hi] = kernel.bands[band] ?? [0, 0];
    const to = { ...from, theta: (lo + hi) / 2 };
    if (passed === 0) {
      const { at } = kernel.slide(from, to);
      if (kernel.bandAt(at.theta) === band && kernel.classify(at) !== "blocked") return { at, passed };
    }
    const at = placeIn(kernel, to, region, width);
    if (at) return { at, passed };
  }
  return null;
}

/** What there is to say of a step; null of one to the next band. */
export function stepMessage(step: Step | null, region: string): string | null {
  if (!step) return `No further band has a place of ${region}: nothing is moved. Switch off "Stop at contact" to look at them.`;
  if (step.passed === 0) return null;
  return `${step.passed === 1 ? "A band has" : `${step.passed} bands have`} no place of ${region} in the middle, and ${step.passed === 1 ? "is" : "are"} passed over.`;
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

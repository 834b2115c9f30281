/** Configurations of planar pairs to ask about. */

import type { PlanarConfiguration, PlanarKernel } from "../../src/kernel/api.js";

/** Of the whole window, as far as contacts reach and a little farther, and some turns away. */
export function anywhere(kernel: PlanarKernel, next: () => number): PlanarConfiguration {
  const { lo, hi } = kernel.bounds();
  const along = (a: number, b: number) => a - 0.1 * (b - a) + 1.2 * (b - a) * next();
  const { lo: first, hi: last, fullTurn } = kernel.window;
  const turns = fullTurn ? Math.floor(5 * next()) - 2 : 0;
  return {
    x: along(lo[0], hi[0]),
    y: along(lo[1], hi[1]),
    theta: first + (last - first) * next() + turns * 2 * Math.PI,
  };
}

export function sizeOf(kernel: PlanarKernel): number {
  const { lo, hi } = kernel.bounds();
  return Math.hypot(hi[0] - lo[0], hi[1] - lo[1]);
}

/**
 * Places of contact curves, moved along the normal by a millionth of the size, down to less than what counts as contact, on either side; and
 * not at all.
 */
export function atContact(kernel: PlanarKernel, count: number, next: () => number): PlanarConfiguration[] {
  const size = sizeOf(kernel);
  const found: PlanarConfiguration[] = [];
  for (let tries = 0; found.length < count && tries < 50 * count && kernel.patchCount > 0; tries++) {
    const patch = Math.floor(next() * kernel.patchCount);
    const [lo, hi] = kernel.patch(patch).orientations!;
    const theta = lo + (hi - lo) * next();
    const curve = kernel.slice(theta, size * 1e-4).find((c) => c.patch === patch);
    if (!curve) continue;
    const k = Math.floor((next() * curve.points.length) / 2);
    const [x, y] = [curve.points[2 * k]!, curve.points[2 * k + 1]!];
    const touch = kernel.touching({ x, y, theta }, size * 1e-6)[0];
    if (!touch) continue;
    const by = size * [0, 1, -1][Math.floor(3 * next())]! * 10 ** (-6 - 8 * next());
    found.push({ x: x + touch.normal[0] * by, y: y + touch.normal[1] * by, theta });
  }
  return found;
}

/** Places of contact curves at critical orientations and a moment beside: ends of curves are hardly known there. */
export function atCritical(kernel: PlanarKernel, count: number, next: () => number): PlanarConfiguration[] {
  const critical = kernel.criticalOrientations;
  const size = sizeOf(kernel);
  const found: PlanarConfiguration[] = [];
  for (let k = 0; k < count && critical.length > 0; k++) {
    const beside = [0, 1, -1][Math.floor(3 * next())]! * 10 ** (-5 - 11 * next());
    const theta = critical[Math.floor(next() * critical.length)]! + beside;
    const curves = kernel.slice(theta, size * 1e-3);
    const points = curves[Math.floor(next() * curves.length)]?.points;
    if (!points) continue;
    const i = next() < 0.5 ? 0 : points.length - 2;
    const by = [0, 1, -1].map((s) => s * size * 10 ** (-6 - 8 * next()));
    found.push({ x: points[i]! + by[Math.floor(3 * next())]!, y: points[i + 1]! + by[Math.floor(3 * next())]!, theta });
  }
  const { lo, hi, fullTurn } = kernel.window;
  return found.filter((c) => fullTurn || (c.theta >= lo && c.theta <= hi));
}

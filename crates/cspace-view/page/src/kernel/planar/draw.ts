/** Slices and bounds to be drawn. */

import type { DrawnCurve } from "../api.js";
import { curvePoint, type Curve } from "../curve.js";
import { sweepOf, radiusOf } from "../edge.js";
import type { Surface } from "./surface.js";

/** So many pieces of an arc are as many as a picture needs. */
const MOST_PIECES = 512;

/** The number of chords that keep within a deviation of an arc. */
export function pieces(radius: number, sweep: number, deviation: number): number {
  const angle = Math.abs(sweep);
  const half = deviation < radius ? Math.acos(1 - deviation / radius) : 0.5 * Math.PI;
  return Math.max(1, Math.min(MOST_PIECES, Math.ceil(angle / Math.max(2 * half, 1e-3))));
}

function piecesOf(c: Curve, deviation: number): number {
  if (c.kind === "segment") return 1;
  if (c.kind === "arc") return pieces(c.radius, c.sweep, deviation);
  if (c.bulge === 0 || (c.start.x === c.end.x && c.start.y === c.end.y)) return 1;
  return pieces(radiusOf(c), sweepOf(c), deviation);
}

export function drawSlice(surface: Surface, theta: number, deviation: number): DrawnCurve[] {
  return surface.slice(theta).curves.map(({ patch, curve, start, end }) => {
    const n = piecesOf(curve, deviation);
    const points = new Float64Array(2 * n + 2);
    for (let k = 0; k <= n; k++) {
      const p = k === 0 ? start : k === n ? end : curvePoint(curve, k / n);
      points[2 * k] = p.x;
      points[2 * k + 1] = p.y;
    }
    return { patch, region: surface.patches[patch]!.region, points };
  });
}

/** Slices looked at for the bounds: positions between them are within a share of the picture that nobody sees. */
const SLICES = 96;

export function boundsOf(surface: Surface): { lo: [number, number]; hi: [number, number] } {
  const { lo: first, hi: last } = surface.space.window;
  const lo: [number, number] = [Infinity, Infinity];
  const hi: [number, number] = [-Infinity, -Infinity];
  for (let k = 0; k <= SLICES; k++) {
    const theta = Math.min(first + ((last - first) * k) / SLICES, last);
    for (const { points } of drawSlice(surface, theta, Infinity)) {
      for (let i = 0; i < points.length; i += 2) {
        lo[0] = Math.min(lo[0], points[i]!);
        hi[0] = Math.max(hi[0], points[i]!);
        lo[1] = Math.min(lo[1], points[i + 1]!);
        hi[1] = Math.max(hi[1], points[i + 1]!);
      }
    }
  }
  return Number.isFinite(lo[0]) ? { lo, hi } : { lo: [0, 0], hi: [0, 0] };
}

/** The (u, v) plane to be drawn: contact curves, and the free gaps between them as polygons. */

import type { DrawnCurve, FreePolygon } from "../api.js";
import { TAU } from "../plane.js";
import type { AxesSpaceData, GapData } from "./data.js";
import type { Graphs } from "./graphs.js";
import type { PlaneMap } from "./plane-map.js";

/** An interval is halved at most so often: curves turn around with the square root of x, as steep as one likes. */
const HALVINGS = 12;

/** Places between which some functions are straight but for a deviation, from lo to hi. */
function places(lo: number, hi: number, deviation: number, at: (x: number) => number[]): number[] {
  const found = [lo];
  const halve = (a: number, fa: number[], b: number, fb: number[], left: number): void => {
    const m = 0.5 * (a + b);
    const fm = at(m);
    const bent = fm.some((y, i) => Math.abs(y - 0.5 * (fa[i]! + fb[i]!)) > deviation);
    if (left > 0 && m > a && m < b && (bent || left > HALVINGS - 2)) {
      halve(a, fa, m, fm, left - 1);
      halve(m, fm, b, fb, left - 1);
    } else {
      found.push(b);
    }
  };
  if (hi > lo) halve(lo, at(lo), hi, at(hi), HALVINGS);
  return found;
}

export function drawCurves(space: AxesSpaceData, graphs: Graphs, map: PlaneMap, deviation: number): DrawnCurve[] {
  const unit = space.map.y_unit;
  return space.branches.map((b) => {
    const c = graphs.cell(b.cell);
    const piece = graphs.piece(b.cell);
    const xs = piece.vertical ? [c.from, c.to] : places(c.from, c.to, deviation / unit, (x) => [graphs.yOf(piece, x)]);
    const points = new Float64Array(2 * xs.length);
    xs.forEach((t, i) => {
      const { u, v } = piece.vertical ? map.outer(piece.start.x, t) : map.outer(t, graphs.yOf(piece, t));
      points[2 * i] = u;
      points[2 * i + 1] = v;
    });
    return { patch: b.patch, region: space.patches[b.patch]?.region ?? null, points };
  });
}

export function drawFree(space: AxesSpaceData, graphs: Graphs, map: PlaneMap, deviation: number): FreePolygon[] {
  const found: FreePolygon[] = [];
  for (const band of space.bands) {
    for (let i = band.gaps.start; i < band.gaps.end; i++) {
      const gap = space.gaps[i]!;
      for (const polygon of polygons(gap, band.lo, band.hi, graphs, deviation / space.map.y_unit)) {
        const points = new Float64Array(2 * polygon.length);
        polygon.forEach(([x, y], k) => {
          const { u, v } = map.outer(x, y);
          points[2 * k] = u;
          points[2 * k + 1] = v;
        });
        found.push({ region: gap.region, points });
      }
    }
  }
  return found;
}

/** A gap over its band; where y goes around it is divided at the seam, and brought into the first turn. */
function polygons(gap: GapData, lo: number, hi: number, graphs: Graphs, deviation: number): [number, number][][] {
  const { y } = graphs;
  let xs = places(lo, hi, deviation, (x) => graphs.interval(gap, x));
  const spans = xs.map((x) => graphs.interval(gap, x));
  if (!y.isCircle) return [outline(xs, spans, -Infinity, Infinity, 0)];
  const least = Math.min(...spans.map((s) => s[0]));
  const most = Math.max(...spans.map((s) => s[1]));
  const found: [number, number][][] = [];
  const first = Math.floor((least - y.lo) / TAU);
  const last = Math.ceil((most - y.lo) / TAU) - 1;
  if (first < last) xs = withSeams(xs, spans, y.lo);
  const cut = xs.map((x) => graphs.interval(gap, x));
  for (let k = first; k <= last; k++) {
    const from = y.lo + TAU * k;
    const polygon = outline(xs, cut, from, from + TAU, -TAU * k);
    if (polygon.length > 2) found.push(polygon);
  }
  return found;
}

/** Places with those added at which an end of the spans passes the seam, as on a straight line. */
function withSeams(xs: number[], spans: [number, number][], seam: number): number[] {
  const found: number[] = [];
  xs.forEach((x, i) => {
    const next = xs[i + 1];
    found.push(x);
    if (next === undefined) return;
    const between: number[] = [];
    for (const end of [0, 1] as const) {
      const [a, b] = [(spans[i]![end] - seam) / TAU, (spans[i + 1]![end] - seam) / TAU];
      if (Math.floor(a) !== Math.floor(b)) between.push(x + ((next - x) * (Math.round(Math.max(Math.floor(a), Math.floor(b))) - a)) / (b - a));
    }
    found.push(...between.filter((t) => t > x && t < next).sort((a, b) => a - b));
  });
  return found;
}

function outline(xs: number[], spans: [number, number][], lo: number, hi: number, by: number): [number, number][] {
  const clip = (t: number) => Math.min(Math.max(t, lo), hi) + by;
  const lower = xs.map((x, i): [number, number] => [x, clip(spans[i]![0])]);
  const upper = xs.map((x, i): [number, number] => [x, clip(spans[i]![1])]);
  // Where it has no height it is not there.
  const first = lower.findIndex((p, i) => upper[Math.min(i + 1, xs.length - 1)]![1] > lower[Math.min(i + 1, xs.length - 1)]![1] || upper[i]![1] > p[1]);
  if (first < 0) return [];
  return [...lower.slice(first), ...upper.slice(first).reverse()];
}

/** Curves of slices and planes, as few elements of SVG: one path for each colour. */

import type { DrawnCurve, Kernel } from "../kernel/api.js";
import { TOUCHING, patchColour, type Colouring } from "./colours.js";
import { svg } from "./dom.js";

export interface Shown {
  colouring: Colouring;
  hidden: ReadonlySet<number>;
  touching: ReadonlySet<number>;
}

export function pathOf(points: ArrayLike<number>, closed = false): string {
  let d = "";
  for (let i = 0; i + 1 < points.length; i += 2) d += `${i === 0 ? "M" : "L"}${points[i]} ${points[i + 1]}`;
  return closed ? `${d}Z` : d;
}

/** Curves strung together to loops where one begins at another's end. */
export function loopsOf(curves: readonly ArrayLike<number>[], joined: number): number[][] {
  // Ends are looked up in a grid, in their own cell and those around it.
  const cell = (x: number) => Math.floor(x / (2 * joined));
  const begins = new Map<string, number[]>();
  curves.forEach((c, i) => {
    const key = `${cell(c[0] ?? 0)},${cell(c[1] ?? 0)}`;
    begins.set(key, [...(begins.get(key) ?? []), i]);
  });
  const used = new Set<number>();
  const next = (x: number, y: number): number | null => {
    for (const i of [-1, 0, 1]) {
      for (const j of [-1, 0, 1]) {
        for (const k of begins.get(`${cell(x) + i},${cell(y) + j}`) ?? []) {
          const c = curves[k];
          if (c && !used.has(k) && Math.hypot((c[0] ?? 0) - x, (c[1] ?? 0) - y) <= joined) return k;
        }
      }
    }
    return null;
  };
  const loops: number[][] = [];
  curves.forEach((_, first) => {
    const loop: number[] = [];
    for (let at: number | null = first; at !== null && !used.has(at); at = next(loop[loop.length - 2] ?? 0, loop[loop.length - 1] ?? 0)) {
      used.add(at);
      loop.push(...Array.from(curves[at] ?? []));
    }
    if (loop.length > 0) loops.push(loop);
  });
  return loops;
}

export function curvePaths(kernel: Kernel, curves: readonly DrawnCurve[], { colouring, hidden, touching }: Shown): SVGElement[] {
  const paths = new Map<string, string>();
  let lit = "";
  for (const curve of curves) {
    if (curve.region !== null && hidden.has(curve.region)) continue;
    const d = pathOf(curve.points);
    if (touching.has(curve.patch)) lit += d;
    const colour = patchColour(colouring, { region: curve.region, kind: kernel.patch(curve.patch).kind });
    paths.set(colour, (paths.get(colour) ?? "") + d);
  }
  const elements: SVGElement[] = [...paths].map(([stroke, d]) => svg("path", { class: "curve", stroke, d }));
  if (lit) elements.push(svg("path", { class: "curve lit", stroke: TOUCHING, d: lit }));
  return elements;
}

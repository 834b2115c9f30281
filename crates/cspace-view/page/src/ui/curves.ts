/** Curves of slices and planes, as few elements of SVG: one path for each colour. */

import type { DrawnCurve, Kernel } from "../kernel/api.js";
import { TOUCHING, patchColour } from "./colours.js";
import type { Colouring } from "./colours.js";
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

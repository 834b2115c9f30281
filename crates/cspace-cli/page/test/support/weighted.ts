/** Configurations as vectors of which all coordinates count alike: the way in which sliding takes the nearest one to a goal. */

import type { AxesKernel, AxisInfo, Configuration, Kernel, PlanarKernel } from "../../src/kernel/api.js";
import type { Place, ScenePair } from "../../src/scene.js";

export interface Weighted {
  vector(c: Configuration): number[];
  configuration(v: readonly number[]): Configuration;
  /** Some configuration that the parts can have. */
  anywhere(next: () => number): Configuration;
  /** Brought into the window. */
  within(c: Configuration): Configuration;
  /** Whether a coordinate can change. */
  moves: boolean[];
}

/** What is read of a saved space. */
type Saved = Record<string, unknown>;

export function weightedOf(pair: ScenePair, kernel: Kernel): Weighted {
  return kernel.coordinates === "axes"
    ? onAxes(JSON.parse(pair.space!) as Saved, kernel as unknown as AxesKernel)
    : inPlane(JSON.parse(pair.space!) as Saved, kernel as unknown as PlanarKernel);
}

function onAxes(space: Saved, kernel: AxesKernel): Weighted {
  const map = space["map"] as { swapped: boolean; x_unit: number; y_unit: number };
  const [a, b] = map.swapped ? [map.y_unit, map.x_unit] : [map.x_unit, map.y_unit];
  const along = (axis: AxisInfo, next: () => number) => (axis.kind === "still" ? 0 : axis.lo + (axis.hi - axis.lo) * next());
  return {
    vector: (c) => ("u" in c ? [c.u / a, c.v / b] : []),
    configuration: ([u, v]) => ({ u: u! * a, v: v! * b }),
    anywhere: (next) => ({ u: along(kernel.u, next), v: along(kernel.v, next) }),
    within: (c) => c,
    moves: [kernel.u.kind !== "still", kernel.v.kind !== "still"],
  };
}

/** The moving part's centre, and its orientation by how far that moves the part. */
function inPlane(space: Saved, kernel: PlanarKernel): Weighted {
  const { moving_center: m, scale } = space["frame"] as { moving_center: Place; scale: number };
  const outline = (space as unknown as { moving: { loops: Place[][] } }).moving.loops.flat();
  const radius = Math.max(...outline.map((p) => Math.hypot(p.x - m.x, p.y - m.y))) * scale;
  const center = (t: number) => [Math.cos(t) * m.x - Math.sin(t) * m.y, Math.sin(t) * m.x + Math.cos(t) * m.y] as const;
  const { lo, hi } = kernel.bounds();
  const { window } = kernel;
  const along = (k: 0 | 1, next: () => number) => lo[k] + (hi[k] - lo[k]) * (1.2 * next() - 0.1);
  return {
    vector: (c) => {
      if ("u" in c) return [];
      const [x, y] = center(c.theta);
      return [(c.x + x) * scale, (c.y + y) * scale, c.theta * radius];
    },
    configuration: ([a, b, t]) => {
      const theta = t! / radius;
      const [x, y] = center(theta);
      return { x: a! / scale - x, y: b! / scale - y, theta };
    },
    anywhere: (next) => ({ x: along(0, next), y: along(1, next), theta: window.lo + (window.hi - window.lo) * next() }),
    within: (c) =>
      window.fullTurn || "u" in c ? c : { ...c, theta: Math.min(Math.max(c.theta, window.lo), window.hi) },
    moves: [true, true, true],
  };
}

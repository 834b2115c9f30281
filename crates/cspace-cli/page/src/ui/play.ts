/** How far the moving part can go from where it is, along each coordinate alone: by first contacts, which are exact. */

import type { AxesKernel, Configuration, Kernel, PlanarKernel } from "../kernel/api.js";
import { isAxes } from "./mechanism.js";
import { TURN } from "./placement.js";

export type Coordinate = "x" | "y" | "theta" | "u" | "v";

/** From a configuration, as far as the first contact back and forth; infinite where nothing is in the way. */
export interface Way {
  coordinate: Coordinate;
  kind: "length" | "angle";
  back: number;
  forth: number;
}

/** A part that has gone this many times the extent of all contacts has left. */
const FAR = 2;

let last: { kernel: Kernel; at: Configuration; ways: Way[] } | null = null;

/** How far the part can go, found once for all views. */
export function playOf(kernel: Kernel, c: Configuration): Way[] {
  if (last?.kernel !== kernel || last.at !== c) last = { kernel, at: c, ways: waysOf(kernel, c) };
  return last.ways;
}

/** Ways along x, y and the orientation, or along u and v of parts that are not still. */
function waysOf(kernel: Kernel, c: Configuration): Way[] {
  if (isAxes(c)) {
    const { u, v } = kernel as unknown as AxesKernel;
    return ([["u", u], ["v", v]] as const).flatMap(([coordinate, info]): Way[] => {
      if (info.kind === "still") return [];
      const far = info.round ? TURN : info.hi - info.lo;
      return [along(kernel, c, coordinate, info.kind, far)];
    });
  }
  const planar = kernel as unknown as PlanarKernel;
  const { lo, hi } = planar.bounds();
  const extent = FAR * Math.max(hi[0] - lo[0], hi[1] - lo[1]);
  return [along(kernel, c, "x", "length", extent), along(kernel, c, "y", "length", extent), along(kernel, c, "theta", "angle", TURN)];
}

function along(kernel: Kernel, c: Configuration, coordinate: Coordinate, kind: Way["kind"], far: number): Way {
  const values = c as unknown as Record<Coordinate, number>;
  const reach = (by: number) => {
    const { at, stopped } = kernel.advance(c, { ...values, [coordinate]: values[coordinate] + by } as unknown as Configuration);
    const gone = Math.abs((at as unknown as typeof values)[coordinate] - values[coordinate]);
    // What a range of motion ends is not gone as far as was asked, either.
    return stopped === null && gone >= Math.abs(by) ? Infinity : gone;
  };
  return { coordinate, kind, back: reach(-far), forth: reach(far) };
}

export function widthOf({ back, forth }: Way): number {
  return back + forth;
}

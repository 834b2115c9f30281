/** What the page asks of a pair's configuration space. It is answered by the kernel, compiled to WebAssembly. */

import type { AxisInfo, Classification, DrawnCurve, FreePolygon, PairClass, PatchInfo, PatchSurface, Touch } from "../../build/kernel/cspace.js";

export type { AxisInfo, Classification, DrawnCurve, FreePolygon, PatchInfo, PatchKind, PatchSurface, Touch } from "../../build/kernel/cspace.js";

export interface PlanarConfiguration {
  x: number;
  y: number;
  theta: number;
}

export interface AxesConfiguration {
  u: number;
  v: number;
}

export type Configuration = PlanarConfiguration | AxesConfiguration;

/** Where a motion got to. */
export interface Motion<C extends Configuration> {
  at: C;
  /** The patch that stopped it, if one did. */
  stopped: number | null;
}

/** What pairs of all classes answer. */
export interface Kernel<C extends Configuration = Configuration> {
  readonly class: PairClass;
  readonly coordinates: "planar" | "axes";
  readonly patchCount: number;
  patch(index: number): PatchInfo;

  /** What `cspace classify` says; null outside the window or the ranges of motion, and of what is not finite. */
  classify(c: C): Classification | null;
  /** Whether the parts fit exactly: they touch, and have no room to move. */
  fitsExactly(c: C): boolean;
  /** The free region of a free configuration. */
  region(c: C): number | null;
  /** What `cspace play` lists: features no farther apart than a distance (model unit; the resolution unless given), nearest first. */
  touching(c: C, within?: number): Touch[];
  /** The first that it lists, however far they are apart; null outside the window or the ranges of motion. */
  nearest(c: C): Touch | null;
  /** What people call a feature that is listed by a name: its name in the model, or where on the part it is, such as `bottom side`. */
  words(feature: string, isMoving: boolean): string;
  /** Patches within the resolution: at a critical orientation those of both of its sides. */
  patchesTouching(c: C): number[];

  /**
   * The configuration itself if it may be moved to; otherwise the first contact on the straight way, to within a resolution. What is asked
   * beyond the window or a range of motion is brought to its end first. From blocked space any way leads, so that a part can be taken out.
   */
  advance(from: C, to: C): Motion<C>;
  /** As {@link advance}, then on along the surface, by its contact functions, as near to `to` as it leads. Never blocked if `from` is not. */
  slide(from: C, to: C): Motion<C>;
}

/** A pair of parts in the plane. */
export interface PlanarKernel extends Kernel<PlanarConfiguration> {
  readonly coordinates: "planar";
  readonly window: { lo: number; hi: number; fullTurn: boolean };
  readonly criticalOrientations: readonly number[];
  readonly bands: readonly [number, number][];
  /** Index of the band that holds an orientation; −1 outside of the window. */
  bandAt(theta: number): number;
  /** The slice, within a deviation (model unit). */
  slice(theta: number, deviation: number): DrawnCurve[];
  /** Bounds of all positions in contact (model unit). */
  bounds(): { lo: [number, number]; hi: [number, number] };
  /** A patch as triangles, within a deviation (model unit and radians scaled by `perRadian`). */
  surface(patch: number, deviation: number, perRadian: number): PatchSurface;
}

/** A pair with fixed axes. */
export interface AxesKernel extends Kernel<AxesConfiguration> {
  readonly coordinates: "axes";
  /** What u and v are: angles or lengths, from where to where, whether they go round. A part that does not move is `still`. */
  readonly u: AxisInfo;
  readonly v: AxisInfo;
  curves(deviation: number): DrawnCurve[];
  /** All free space of one period, as polygons that do not overlap. */
  free(deviation: number): FreePolygon[];
}

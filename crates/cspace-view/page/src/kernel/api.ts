/** What the page asks of a pair's configuration space. All of it is answered in the page, in double precision. */

import type { PairClass } from "../scene.js";

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

export type Classification = "free" | "blocked" | "contact";

/** A feature pair that touches, or nearly. */
export interface Touch {
  /** As the command prints features: the model's name for it, or `line 3 of loop 0`. */
  fixed: string;
  moving: string;
  /** How far they are apart (model unit); less than 0 by as much as they overlap. */
  distance: number;
  /** The fixed part's point of the two that are nearest to each other, in the fixed part's frame (planar), or in the assembly (fixed axes). */
  at: [number, number];
  /** The outward unit normal of the fixed part there, in the same frame. */
  normal: [number, number];
}

export type PatchKind = "line-vertex" | "line-arc" | "arc-vertex" | "arc-arc";

export interface PatchInfo {
  fixed: string;
  moving: string;
  /** Kinds of the two features, whichever of them is the fixed part's. */
  kind: PatchKind;
  region: number | null;
  /** First and last orientation of a planar patch. */
  orientations: [number, number] | null;
}

/** A piece of a slice or of the (u, v) plane that bounds free space, as points close enough to draw. */
export interface DrawnCurve {
  patch: number;
  region: number | null;
  /** [x0, y0, x1, y1, ...] (or u, v), within the asked deviation of the curve. */
  points: Float64Array;
}

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
  /** The free region of a free configuration. */
  region(c: C): number | null;
  /** What `cspace contacts` lists: features no farther apart than a distance (model unit; the resolution unless given), nearest first. */
  touching(c: C, within?: number): Touch[];
  /** The first that it lists, however far they are apart; null outside the window or the ranges of motion. */
  nearest(c: C): Touch | null;
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
  /**
   * A patch as triangles, within a deviation (model unit and radians scaled by `perRadian`): positions (x, y, θ) and indices; θ runs
   * from the patch's first to its last orientation and may pass π. Triangles face free space; `normals` are unit, with θ scaled by `perRadian`.
   */
  surface(patch: number, deviation: number, perRadian: number): { positions: Float32Array; normals: Float32Array; indices: Uint32Array };
}

/** A gap of the plane: free between two curves over an interval. */
export interface FreePolygon {
  region: number;
  /** A closed polygon [u0, v0, u1, v1, ...]. */
  points: Float64Array;
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

export interface AxisInfo {
  kind: "still" | "angle" | "length";
  lo: number;
  hi: number;
  /** Whether it repeats after a turn. */
  round: boolean;
}

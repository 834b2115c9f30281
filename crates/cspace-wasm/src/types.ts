export type PairClass = "lower" | "fixed-axes" | "symmetric" | "general";

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

/** Where a motion got to. */
export interface Reached {
  /** [x, y, theta], or [u, v] of a pair with fixed axes. */
  at: number[];
  /** The patch that stopped it, if one did. */
  stopped: number | null;
}

/** A piece of a slice or of the (u, v) plane that bounds free space, as points close enough to draw. */
export interface DrawnCurve {
  patch: number;
  region: number | null;
  /** [x0, y0, x1, y1, ...] (or u, v), within the requested deviation of the curve. */
  points: Float64Array;
}

/** A gap of the plane: free between two curves over an interval. */
export interface FreePolygon {
  region: number;
  /** A closed polygon [u0, v0, u1, v1, ...]. */
  points: Float64Array;
}

/**
 * A patch as triangles: positions (x, y, theta) and indices; theta runs from the patch's first to its last orientation and may pass pi.
 * Triangles face free space; normals are unit, with theta scaled by `perRadian`.
 */
export interface PatchSurface {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

/** What a coordinate is: an angle or a length, from where to where, and whether it repeats after a turn. A part that does not move is `still`. */
export interface AxisInfo {
  kind: "still" | "angle" | "length";
  lo: number;
  hi: number;
  round: boolean;
}

/** What became of a drag of a mechanism. */
export interface Came {
  /** The coordinates of each part: none, [u], or [x, y, theta]. */
  parts: number[][];
  /** Whether the part is where it was dragged to. */
  reached: boolean;
  /** What stops it, in words. */
  stopped: string[];
  /** Names of parts that overlap each other. */
  overlapping: [string, string][];
  /** Sentences on the parts that are smaller by a gap than drawn, because they fit exactly. */
  gaps: string[];
  /** Names of parts that went at once to where forces balance. */
  snaps: string[];
}

/** The scene: all that a page shows, as JSON. `docs/page.md` describes every field. Angles are radians, lengths in the model's unit. */

/** The version of the format that this page reads. */
export const SCENE_VERSION = 1;

export interface Scene {
  format: "cspace-scene";
  version: typeof SCENE_VERSION;
  /** What the model is called. */
  name: string;
  /** The label of the unit of length. */
  unit: string | null;
  parts: ScenePart[];
  joints: SceneJoint[];
  pairs: ScenePair[];
  show: SceneShow;
  /** What `cspace plan` and `cspace simulate` print with `--json`, to be played. */
  records: SceneRecord[];
  /** The parameters and requirements of the model; null if it has none, or its text is not here. */
  design: SceneDesign | null;
  /** What pairs are computed from again once parts are edited; null of a model that cannot be written. */
  source: SceneSource | null;
}

/** What is shown first, as the model's `show` says. */
export interface SceneShow {
  /** Index of the pair; null if the model names none, or it is not among the pairs here. */
  pair: number | null;
  /** The question that it answers. */
  question: string | null;
  /** What is large; null for the parts. */
  view: View | null;
}

/** What is large: the parts; the slice or plane beside them; and the surface of the space, too. */
export type View = "parts" | "slice" | "space";

/** A model, and which of its pairs are shown, in the order of the scene. */
export interface SceneSource {
  /** TOML. */
  model: string;
  pairs: { fixed: number; moving: number; window: [number, number] | null }[];
  /** Whether the general method is used whatever the class. */
  general: boolean;
  /** The text with the parameters of the model, and values that they were given. */
  design: { text: string; file: string; set: SceneSetting[] } | null;
}

/** A value for a parameter: a number, an angle such as `18deg`, or an expression of other parameters. */
export interface SceneSetting {
  name: string;
  value: string;
}

export interface SceneDesign {
  parameters: SceneParameter[];
  /** The names of the requirements. */
  requirements: string[];
}

export interface SceneParameter {
  name: string;
  /** Of an angle in radians. */
  value: number;
  /** The expression by which it follows from other parameters. */
  expression: string | null;
  is_angle: boolean;
  /** Whether it says how often something is repeated: a whole number. */
  is_count: boolean;
  /** The values that a slider offers first. */
  range: [number, number];
}

export interface SceneVertex {
  x: number;
  y: number;
  /** Of the edge that leaves it: tan(sweep / 4), positive counter-clockwise; 0 a line. */
  bulge: number;
}

export interface ScenePart {
  name: string;
  /** As the model gives them; a loop is closed. */
  loops: SceneVertex[][];
  /** The lowest first: heights, none at every height, and the numbers of loops. */
  layers: { z: [number, number] | null; loops: number[] }[];
  /** The names the model gives to features, by what they are called without: `line 3 of loop 0`. */
  feature_names: Record<string, string>;
  motion: SceneMotion;
}

export type SceneMotion =
  | { type: "planar" }
  | { type: "fixed" }
  | { type: "revolute"; center: Place; range: [number, number] | null }
  | { type: "prismatic"; direction: Place; range: [number, number] | null };

/** A point or a vector, as the saved spaces have them. */
export interface Place {
  x: number;
  y: number;
}

export interface SceneJoint {
  type: "revolute" | "prismatic";
  /** Indices of the two parts. */
  parts: [number, number];
  /** Where it is, in the assembly's frame at zero motion. */
  at: Place;
  direction: Place | null;
}

export type PairClass = "lower" | "fixed-axes" | "symmetric" | "general";

export interface ScenePair {
  /** Index of the part in whose frame configurations are expressed. */
  fixed: number;
  /** Index of the part that moves in that frame. */
  moving: number;
  class: PairClass;
  /** The configuration space as `cspace export -o OUT.json` writes it, as text for the kernel; null until it is computed. */
  space: string | null;
  /** Whether the page has computed it itself. */
  own?: boolean;
  /** Why there is none, if it cannot be computed. */
  error: string | null;
  /** Lines, arcs and vertices that are not smooth joints, of both parts; and how often each repeats in a turn. */
  features: { fixed: number; moving: number };
  symmetry: { fixed: number; moving: number };
  /** Configurations nearer to a contact than this are in contact (model unit). */
  contact_distance: number;
  /** Contacts are known to this (model unit). */
  resolution: number;
  /** Bands of a planar pair [lo, hi], in ascending order. */
  bands: [number, number][];
  /** Free regions in the order of their numbers. */
  regions: SceneRegion[];
  /** How long it took to compute (s). */
  seconds: number;
}

export interface SceneRegion {
  unbounded: boolean;
  /** A configuration in it: [x, y, θ] or [u, v]. */
  sample: number[];
  /** Of a pair on fixed axes: where u and v are in it; else null. */
  ranges: [SceneRange, SceneRange] | null;
}

/** From where to where a coordinate goes (model unit or radians), whether without limit below and above, and whether it turns for ever. */
export interface SceneRange {
  lo: number;
  hi: number;
  open: [boolean, boolean];
  around: boolean;
}

export interface SceneRecord {
  /** What it is called: a file's name. */
  name: string;
  /** A `plan` or `simulate` answer, as it was printed. */
  record: unknown;
}

/** What the page reads of the space of a lower pair. */
export interface LowerSpace {
  joint: { type: "revolute" | "prismatic"; at?: Place; direction?: Place };
  limits: [number, number] | null;
}

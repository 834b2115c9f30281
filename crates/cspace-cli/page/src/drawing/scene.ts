/** A drawing and its faces, as JSON. `docs/page.md` describes every field. Lengths are in the model's unit. */

import type { Place, SceneVertex } from "../scene.js";

/** The version of the format that this page reads. */
export const DRAWING_VERSION = 2;

export interface DrawingScene {
  format: "cspace-drawing";
  version: typeof DRAWING_VERSION;
  source: DrawingSource;
  /** All that is drawn, as the ends of lines and arcs. */
  curves: SceneVertex[][];
  /** The largest first. */
  faces: SceneFace[];
  /** The number of faces of the drawing, of which `faces` has the largest. */
  count: number;
  /** The parts that `cspace import` makes without picks, if each is one face; none otherwise. */
  parts: ImportedPart[];
  /** What cannot be used and bounds no face, in the words of the command, and what to do. */
  dropped: string | null;
}

export interface ImportedPart {
  name: string;
  /** Index of the face. */
  face: number;
}

/** What the kernel makes the model of: the file, and how it is read. */
export interface DrawingSource {
  /** The file's name. */
  file: string;
  /** The file's bytes, in base 64. */
  data: string;
  /** The name of the model. */
  name: string;
  /** The label of the unit of length. */
  unit: string | null;
  /** The command that makes the model, up to its picks. */
  command: string;
  /** The layers of a DXF file that are read; all if there are none here. */
  layers: string[];
  /** The ids of the SVG elements that are read; all if there are none. */
  ids: string[];
  /** Colours of what is read; all if there are none. */
  colors: string[];
  /** Line types of a DXF file that are read; if there are none, all of outlines. */
  linetypes: string[];
  /** Whether a rectangle around everything is left out. */
  without_sheet: boolean;
  /** Whether the outlines of a DXF file's hatches are read too. */
  hatches: boolean;
  /** Every length of the drawing is multiplied by it. */
  scale: number;
  /** Ends nearer than this are one; null as usual. */
  join: number | null;
  /** Curves become lines and arcs within this; null as usual. */
  fit: number | null;
}

export interface SceneFace {
  /** A point in the face. */
  inside: Place;
  area: number;
  /** The outer boundary, then those of what lies within. */
  loops: SceneVertex[][];
  /** Why the face alone is no part; it may be one together with others. */
  refusal: string | null;
}

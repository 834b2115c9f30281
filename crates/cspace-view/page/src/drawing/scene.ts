/** A drawing and its faces, as JSON. `docs/page.md` describes every field. Lengths are in the model's unit. */

import type { Place, SceneVertex } from "../scene.js";
import { textOf } from "../ui/dom.js";

/** The version of the format that this page reads. */
const DRAWING_VERSION = 1;

export interface DrawingScene {
  format: "cspace-drawing";
  version: typeof DRAWING_VERSION;
  /** The name of the model. */
  name: string;
  /** The label of the unit of length. */
  unit: string | null;
  /** The command that makes the model, up to its picks. */
  command: string;
  /** All that is drawn, as the ends of lines and arcs. */
  curves: SceneVertex[][];
  /** The largest first. */
  faces: SceneFace[];
  /** The number of faces of the drawing, of which `faces` has the largest. */
  count: number;
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

/** The drawing in the page; throws what the user is to read. */
export function readDrawing(): DrawingScene {
  const scene = JSON.parse(textOf("scene")) as DrawingScene;
  if (scene.format !== "cspace-drawing") throw new Error("What is in this page is no drawing.");
  if (scene.version !== DRAWING_VERSION) throw new Error(`The drawing has version ${scene.version}, and this page reads version ${DRAWING_VERSION}.`);
  return scene;
}

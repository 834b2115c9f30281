/** Where the name of a part stands: in the middle of the widest stretch of its material. */

import type { Place, ScenePart } from "../scene.js";
import { arcOf, boxOf, edgesOf } from "./outline.js";

/** So many levels of an outline are looked at. */
const LEVELS = 15;
/** Arcs count as so many chords for a turn: a name need not be where it is to a hair. */
const CHORDS = 24;

export interface Stretch {
  /** In the part's frame. */
  at: Place;
  width: number;
}

/** Null of a part without material. */
export function labelPlace(loops: ScenePart["loops"]): Stretch | null {
  const box = boxOf(loops);
  const chords = loops.flatMap((loop) => edgesOf(loop).flatMap(chordsOf));
  let widest: Stretch | null = null;
  for (let k = 0; k < LEVELS; k += 1) {
    const y = box.y0 + ((k + 0.5) / LEVELS) * (box.y1 - box.y0);
    const crossings = chords
      .filter(([a, b]) => a.y > y !== b.y > y)
      .map(([a, b]) => a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x))
      .sort((a, b) => a - b);
    for (let i = 0; i + 1 < crossings.length; i += 2) {
      const [x0 = 0, x1 = 0] = [crossings[i], crossings[i + 1]];
      if (x1 - x0 > (widest?.width ?? 0)) widest = { at: { x: (x0 + x1) / 2, y }, width: x1 - x0 };
    }
  }
  return widest;
}

function chordsOf(edge: ReturnType<typeof edgesOf>[number]): [Place, Place][] {
  const arc = arcOf(edge);
  if (!arc) return [[edge.from, edge.to]];
  const count = Math.max(1, Math.ceil((Math.abs(arc.sweep) / (2 * Math.PI)) * CHORDS));
  const at = (k: number): Place => {
    if (k === 0) return edge.from;
    if (k === count) return edge.to;
    const angle = arc.start + (k / count) * arc.sweep;
    return { x: arc.center.x + arc.radius * Math.cos(angle), y: arc.center.y + arc.radius * Math.sin(angle) };
  };
  return Array.from({ length: count }, (_, k) => [at(k), at(k + 1)]);
}

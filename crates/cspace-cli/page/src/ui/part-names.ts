/** The names of parts, on them. Those of the pair are always there; others where they have room. */

import type { Place, ScenePair, ScenePart } from "../scene.js";
import { svg } from "./dom.js";
import { labelPlace, type Stretch } from "./label-place.js";
import { IDENTITY, apply, type Placement } from "./placement.js";
import type { Viewport } from "./viewport.js";

/** About as wide and as high as a character of a name is (root ems). */
const CHARACTER = 0.52;
const LINE = 1.2;
/** Half the width of a pivot's mark (pixels). */
const MARK = 12;

export class PartNames {
  readonly group = svg("g", { class: "part-names", "aria-hidden": "true" });
  #places = new WeakMap<ScenePart, Stretch | null>();

  draw(viewport: Viewport, parts: readonly ScenePart[], placements: readonly Placement[], pair: ScenePair | undefined, marks: readonly Place[]): void {
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const taken = marks.map(({ x, y }) => ({ x, y, half: MARK }));
    const names: SVGElement[] = [];
    const ofPair = pair ? [pair.moving, pair.fixed] : [];
    const order = [...ofPair, ...parts.map((_, i) => i).filter((i) => !ofPair.includes(i))];
    for (const i of order) {
      const part = parts[i];
      const stretch = part && this.#placeOf(part);
      if (!part || !stretch) continue;
      const { x, y } = viewport.toScreen(apply(placements[i] ?? IDENTITY, stretch.at));
      const width = part.name.length * CHARACTER * rem;
      if (!ofPair.includes(i) && width > stretch.width / viewport.pixel.x) continue;
      // A name that another one covers is put above or below it.
      const free = [0, 1, -1, 2, -2].map((k) => y + k * LINE * rem).find((at) => taken.every((t) => Math.abs(t.y - at) >= LINE * rem || Math.abs(t.x - x) > t.half + width / 2));
      if (free === undefined) continue;
      taken.push({ x, y: free, half: width / 2 });
      names.push(svg("text", { x, y: free, "text-anchor": "middle", "dominant-baseline": "central", class: ofPair.includes(i) ? "" : "other" }, part.name));
    }
    this.group.replaceChildren(...names);
  }

  #placeOf(part: ScenePart): Stretch | null {
    let place = this.#places.get(part);
    if (place === undefined) {
      place = labelPlace(part.loops);
      this.#places.set(part, place);
    }
    return place;
  }
}

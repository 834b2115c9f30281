/** What can be grabbed of edited parts: where it is in the assembly, how it is drawn, and what is nearest to a pointer. */

import type { Place, ScenePart } from "../scene.js";
import { set, svg } from "./dom.js";
import { nearestOn } from "./edit-shape.js";
import { short } from "./numbers.js";
import { edgeOf, middleOf } from "./outline.js";
import { IDENTITY, apply, inverse, type Placement } from "./placement.js";
import type { Viewport } from "./viewport.js";

export interface Edited {
  loops: ScenePart["loops"];
  motion: ScenePart["motion"];
  offset: number;
  /** Whether it was changed here: it follows parameters no more. */
  byHand: boolean;
}

export type VertexHandle = { kind: "vertex"; part: number; loop: number; index: number };

export type Handle = VertexHandle | { kind: "bulge"; part: number; loop: number; index: number } | { kind: "pivot"; part: number };

/** How near to a handle it is grabbed, in pixels. */
const GRAB = 14;
const HANDLE = 4.5;
/** How near to an edge a double click adds a vertex to it, in pixels. */
const ON_EDGE = 10;

/** Handles of some of the parts, and of these of the loops that are at the height that is looked at. */
export class Handles {
  constructor(
    private readonly edited: readonly Edited[],
    private readonly placements: readonly Placement[],
    private readonly parts: readonly number[],
    private readonly loops: readonly ReadonlySet<number>[],
  ) {}

  private all(): Handle[] {
    return this.parts.flatMap((part) => {
      const e = this.edited[part];
      if (!e) return [];
      const handles: Handle[] = e.loops.flatMap((loop, l) =>
        (this.isSeen(part, l) ? loop : []).flatMap((_, i): Handle[] => [
          { kind: "bulge", part, loop: l, index: i },
          { kind: "vertex", part, loop: l, index: i },
        ]),
      );
      if (e.motion.type === "revolute") handles.push({ kind: "pivot", part });
      return handles;
    });
  }

  private isSeen(part: number, loop: number): boolean {
    return this.loops[part]?.has(loop) ?? true;
  }

  /** In the assembly. */
  placeOf(handle: Handle): Place | null {
    const e = this.edited[handle.part];
    if (!e) return null;
    // A pivot belongs to the ground.
    if (handle.kind === "pivot") return e.motion.type === "revolute" ? e.motion.center : null;
    const edge = edgeOf(e.loops[handle.loop] ?? [], handle.index);
    return edge ? apply(this.placements[handle.part] ?? IDENTITY, handle.kind === "vertex" ? edge.from : middleOf(edge)) : null;
  }

  /** `names` are of the parts; a handle that gets the focus is told. */
  drawn(viewport: Viewport, selected: Handle | null, names: readonly string[], focused: (handle: Handle) => void): SVGElement[] {
    return this.all().flatMap((handle) => {
      const at = this.placeOf(handle);
      if (!at) return [];
      const element = this.element(handle, viewport.toScreen(at), isSame(handle, selected) ? " chosen" : "");
      const what = handle.kind === "pivot" ? "pivot" : `${handle.kind === "vertex" ? "vertex" : "middle of edge"} ${handle.index + 1}${handle.loop > 0 ? ` of hole ${handle.loop}` : ""}`;
      set(element, { tabindex: 0, role: "button", "aria-label": `${what} of ${names[handle.part]} at ${short(at.x)}, ${short(at.y)}: arrow keys move it` });
      element.addEventListener("focus", () => focused(handle));
      return [element];
    });
  }

  private element(handle: Handle, { x, y }: Place, chosen: string): SVGElement {
    if (handle.kind === "vertex") {
      return svg("rect", { class: `handle vertex${chosen}`, x: x - HANDLE, y: y - HANDLE, width: 2 * HANDLE, height: 2 * HANDLE });
    }
    return svg("circle", { class: `handle ${handle.kind}${chosen}`, cx: x, cy: y, r: handle.kind === "pivot" ? 8 : HANDLE - 0.5 });
  }

  nearest(at: Place, { pixel }: Viewport): Handle | null {
    let nearest: Handle | null = null;
    let least = GRAB;
    for (const handle of this.all()) {
      const place = this.placeOf(handle);
      if (!place) continue;
      const away = Math.hypot((place.x - at.x) / pixel.x, (place.y - at.y) / pixel.y);
      // Where they lie on each other, vertices go before middles of edges.
      if (away < least + (handle.kind === "bulge" ? -2 : 0)) [nearest, least] = [handle, away];
    }
    return nearest;
  }

  /** The edge that a place is on, by its first vertex, and the place in the part's frame. */
  edgeAt(at: Place, { pixel }: Viewport): { of: VertexHandle; own: Place } | null {
    let found: { of: VertexHandle; own: Place } | null = null;
    let least = ON_EDGE * pixel.x;
    for (const part of this.parts) {
      const own = apply(inverse(this.placements[part] ?? IDENTITY), at);
      this.edited[part]?.loops.forEach((loop, l) =>
        loop.forEach((_, index) => {
          const edge = this.isSeen(part, l) ? edgeOf(loop, index) : null;
          const on = edge ? nearestOn(edge, own).at : null;
          const away = on ? Math.hypot(on.x - own.x, on.y - own.y) : Infinity;
          if (away < least) [least, found] = [away, { of: { kind: "vertex", part, loop: l, index }, own }];
        }),
      );
    }
    return found;
  }
}

export function isSame(a: Handle, b: Handle | null): boolean {
  if (!b || a.kind !== b.kind || a.part !== b.part) return false;
  return a.kind === "pivot" || b.kind === "pivot" || (a.loop === b.loop && a.index === b.index);
}

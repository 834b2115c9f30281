/** Measuring: two clicks on corners or edges give their distance, which follows the parts. */

import type { Place, ScenePart } from "../scene.js";
import { distanceOf, type Measured } from "./distance.js";
import { svg } from "./dom.js";
import { nearestOn } from "./edit-shape.js";
import { loopsAt } from "./heights.js";
import { length, rounded } from "./numbers.js";
import { arcOf, edgeOf, edgePath, type Edge } from "./outline.js";
import { IDENTITY, apply, type Placement } from "./placement.js";
import type { Session } from "./session.js";
import type { Drag, Viewport } from "./viewport.js";

/** How near to a corner or an edge a click is for it (pixels); a finger is as thick. */
const NEAR = 14;

interface Picked {
  part: number;
  loop: number;
  index: number;
  corner: boolean;
}

export class Measure {
  readonly group = svg("g", { class: "measure" });
  #picked: Picked[] = [];

  constructor(private readonly session: Session, private readonly viewport: Viewport) {
    session.store.subscribe((changed, state) => {
      // Edges of another shape are other edges.
      if ((changed.has("measuring") && !state.measuring) || changed.has("parts")) this.#picked = [];
    });
  }

  /** Takes a click on a corner or an edge; what is clicked beside them is dragged as usual. */
  grab(at: Place): Drag | null {
    if (!this.session.state.measuring) return null;
    const picked = this.#at(at);
    if (!picked) return null;
    this.#picked = this.#picked.length >= 2 ? [picked] : [...this.#picked, picked];
    this.draw();
    return { move: () => {} };
  }

  #at(at: Place): Picked | null {
    const { parts, placements } = this.session.state;
    const { interval } = this.session;
    const near = NEAR * this.viewport.pixel.x;
    let found: Picked | null = null;
    let least = Infinity;
    parts.forEach((part, p) =>
      loopsAt(part, interval).forEach((l) =>
        part.loops[l]?.forEach((_, index) => {
          const edge = placedEdge(part, l, index, placements[p] ?? IDENTITY);
          if (!edge) return;
          const on = nearestOn(edge, at).at;
          const toEdge = Math.hypot(on.x - at.x, on.y - at.y);
          const toCorner = Math.hypot(edge.from.x - at.x, edge.from.y - at.y);
          // A corner lies on two edges, and goes before them.
          if (toCorner < near && toCorner - near < least) [least, found] = [toCorner - near, { part: p, loop: l, index, corner: true }];
          else if (toEdge < near && toEdge < least) [least, found] = [toEdge, { part: p, loop: l, index, corner: false }];
        }),
      ),
    );
    return found;
  }

  draw(): void {
    const { parts, placements } = this.session.state;
    const shown: SVGElement[] = [];
    const measured = this.#picked.flatMap(({ part, loop, index, corner }): { of: Measured; text: string }[] => {
      const own = parts[part];
      const edge = own && placedEdge(own, loop, index, placements[part] ?? IDENTITY);
      if (!edge) return [];
      return [corner ? { of: { point: edge.from }, text: "" } : { of: { edge }, text: this.#sizeOf(edge) }];
    });
    for (const { of } of measured) {
      if ("point" in of) {
        const { x, y } = this.viewport.toScreen(of.point);
        shown.push(svg("circle", { class: "measured", cx: x, cy: y, r: 6 }));
      } else shown.push(svg("path", { class: "measured", d: this.#onScreen(of.edge) }));
    }
    const [a, b] = measured;
    if (a && b) {
      const { from, to, length: gap } = distanceOf(a.of, b.of);
      const [p, q] = [this.viewport.toScreen(from), this.viewport.toScreen(to)];
      shown.push(svg("path", { class: "dimension", d: `M${p.x} ${p.y}L${q.x} ${q.y}` }), label({ x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 }, this.#text(gap)));
    } else if (a?.text) {
      const at = "edge" in a.of ? middle(a.of.edge) : a.of.point;
      shown.push(label(this.viewport.toScreen(at), a.text));
    }
    this.group.replaceChildren(...shown);
  }

  #sizeOf(edge: Edge): string {
    const arc = arcOf(edge);
    return arc ? `radius ${this.#text(arc.radius)}` : `length ${this.#text(Math.hypot(edge.to.x - edge.from.x, edge.to.y - edge.from.y))}`;
  }

  #text(value: number): string {
    return length(rounded(value, 6), this.session.scene.unit);
  }

  /** An edge on the screen, where y points downwards: it turns the other way. */
  #onScreen({ from, to, bulge }: Edge): string {
    return edgePath({ from: this.viewport.toScreen(from), to: this.viewport.toScreen(to), bulge: -bulge });
  }
}

function placedEdge(part: ScenePart, loop: number, index: number, at: Placement): Edge | null {
  const edge = edgeOf(part.loops[loop] ?? [], index);
  return edge && { from: apply(at, edge.from), to: apply(at, edge.to), bulge: edge.bulge };
}

/** The middle of an edge: an arc is as far beside its chord as its bulge says, in halves of the chord. */
export function middle({ from, to, bulge }: Edge): Place {
  return { x: (from.x + to.x + bulge * (to.y - from.y)) / 2, y: (from.y + to.y - bulge * (to.x - from.x)) / 2 };
}

function label({ x, y }: Place, text: string): SVGElement {
  return svg("text", { class: "dimension-text", x, y: y - 10, "text-anchor": "middle" }, text);
}

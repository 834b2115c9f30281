/**
 * A lens in a corner of a view, beside what it magnifies: what is around the configuration, at a scale at which its room can be seen. It is there where the room
 * is less than the mark of the configuration covers.
 */

import type { Classification } from "../kernel/api.js";
import type { Place } from "../scene.js";
import { set, svg } from "./dom.js";
import type { Box } from "./outline.js";
import type { Viewport } from "./viewport.js";

/** Side of the lens, and its distance from the view's edges (pixels); no more than a share of the view. */
const SIDE = 150;
const MARGIN = 10;
const MOST_OF_VIEW = 0.4;
/** Its words below it are so high (pixels). */
const WORDS = 24;
/** The mark of a configuration covers as much (pixels). */
const COVERED = 24;
/** A lens that shows less than this many times larger is not worth its place. */
const LEAST_ZOOM = 1.5;
/** The lens is wider than the room by this, and no longer than so many times its width. */
const AROUND = 1.5;
const LONGEST = 3;
/** Room of less is none, of that along the other coordinate. */
const WEDGED = 1e-6;

/** How far it is to the first contacts, back and forth along both coordinates of the view. */
export interface Room {
  across: { back: number; forth: number };
  up: { back: number; forth: number };
}

/** What the lens shows (units of the view); null where the view itself shows the room. */
export function lensBox(at: Place, { across, up }: Room, pixel: Place, side: number): Box | null {
  const widths = [(across.back + across.forth) / pixel.x, (up.back + up.forth) / pixel.y];
  const [least, most] = [Math.min(...widths), Math.max(...widths)];
  if (!(least < COVERED) || most === 0) return null;
  // Wedged along one coordinate, it has only the other.
  const ends = Number.isFinite(most);
  const width = AROUND * Math.min(most, !ends || least > WEDGED * most ? LONGEST * least : most / LONGEST);
  if (width === 0 || side < LEAST_ZOOM * width) return null;
  const middle = ({ back, forth }: Room["across"], per: number) => ((back + forth) / per <= width ? (forth - back) / 2 : 0);
  const center = { x: at.x + middle(across, pixel.x), y: at.y + middle(up, pixel.y) };
  const half = { x: (width / 2) * pixel.x, y: (width / 2) * pixel.y };
  return { x0: center.x - half.x, x1: center.x + half.x, y0: center.y - half.y, y1: center.y + half.y };
}

/** The upper left corner of a lens: that of the view in which it is, unless what it magnifies lies there; then the first that is clear, or the farthest. */
export function lensCorner(of: Place, side: number, { width, height }: { width: number; height: number }, was: number): { corner: number; at: Place } {
  const [right, low] = [width - side - MARGIN, height - side - MARGIN - WORDS];
  const corners = [{ x: right, y: MARGIN }, { x: MARGIN, y: MARGIN }, { x: right, y: low }, { x: MARGIN, y: low }];
  /** How far it is beside the lens, less what the mark covers. */
  const clear = ({ x, y }: Place) => Math.max(x - of.x, of.x - x - side, y - of.y, of.y - y - side - WORDS) - COVERED / 2;
  const order = [was, 0, 1, 2, 3];
  const corner = order.find((i) => clear(corners[i] ?? of) >= 0) ?? order.reduce((a, b) => (clear(corners[b] ?? of) > clear(corners[a] ?? of) ? b : a));
  return { corner, at: corners[corner] ?? of };
}

export class Lens {
  /** Which corner of the view it is in. */
  #corner = 0;
  readonly group = svg("g", { class: "lens", visibility: "hidden" });
  readonly #world = svg("g");
  readonly #point = svg("circle", { class: "lens-point", r: 4 });
  readonly #text = svg("text", { class: "lens-text" });
  readonly #frame = svg("rect", { class: "lens-frame", rx: 6 });
  readonly #ground = svg("rect", { class: "lens-ground", rx: 6 });
  readonly #clip = svg("rect", { rx: 6 });

  constructor(private readonly viewport: Viewport, id: string) {
    const inside = svg("g", { "clip-path": `url(#${id})` }, this.#world, this.#point);
    this.group.append(svg("clipPath", { id }, this.#clip), this.#ground, inside, this.#frame, this.#text);
    viewport.overlay.append(this.group);
  }

  get side(): number {
    const { width, height } = this.viewport.size;
    return Math.min(SIDE, MOST_OF_VIEW * width, MOST_OF_VIEW * height);
  }

  hide(): void {
    set(this.group, { visibility: "hidden" });
  }

  show(box: Box, at: Place, classification: Classification | null, content: readonly SVGElement[], text: string): void {
    const side = this.side;
    const { corner, at: { x, y } } = lensCorner(this.viewport.toScreen(at), side, this.viewport.size, this.#corner);
    this.#corner = corner;
    const [sx, sy] = [side / (box.x1 - box.x0), side / (box.y1 - box.y0)];
    const square = { x, y, width: side, height: side };
    for (const rect of [this.#clip, this.#ground, this.#frame]) set(rect, square);
    set(this.#world, { transform: `matrix(${sx} 0 0 ${-sy} ${x - sx * box.x0} ${y + sy * box.y1})` });
    this.#world.replaceChildren(...content);
    set(this.#point, { cx: x + sx * (at.x - box.x0), cy: y + sy * (box.y1 - at.y) });
    set(this.#text, { x: x + side / 2, y: y + side + 4, "text-anchor": "middle", "dominant-baseline": "hanging" });
    this.#text.textContent = text;
    set(this.group, { "data-class": classification, visibility: null });
  }
}

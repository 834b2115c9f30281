/**
 * The side view of parts that are stacks of layers: a column for each part, the heights upwards. One height is chosen by a click, or
 * in the list above, and is then looked at alone. Models without heights have no side view.
 */

import type { ScenePart } from "../scene.js";
import { html, set, svg } from "./dom.js";
import { intervalsOf, isAt, middleOf, type Interval } from "./heights.js";
import { length, short } from "./numbers.js";
import { boxOf } from "./outline.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";

/** Room for the numbers of the axis, and above and below the stack (root ems). */
const NUMBERS = 3.2;
const ABOVE = 1.7;
const BELOW = 0.9;
/** Parts at every height reach so far beyond the stack (root ems). */
const BEYOND = 0.5;
/** A line of numbers (root ems). */
const LINE = 1.05;
/** The share of a column's width between it and the next. */
const BETWEEN = 0.2;
/** What is narrower or lower could not be seen (pixels). */
const LEAST = 3;

export class StackView {
  readonly svg = svg("svg", { class: "stack-view", role: "img" });
  readonly #choice = html("select", { "aria-label": "Height" });
  /** The lowest first. */
  #intervals: Interval[] = [];

  constructor(private readonly element: HTMLElement, private readonly session: Session) {
    element.append(this.#choice, this.svg);
    this.#choice.addEventListener("change", () => this.#choose(this.#intervals[this.#intervals.length - this.#choice.selectedIndex] ?? null));
    this.svg.addEventListener("click", (event) => this.#click(event));
    new ResizeObserver(() => this.#draw()).observe(this.svg);
    session.store.subscribe((changed, { parts }) => {
      if (changed.has("parts")) {
        this.#intervals = intervalsOf(parts);
        element.hidden = this.#intervals.length === 0;
        element.style.setProperty("--columns", String(parts.length));
      }
      if ((["parts", "height", "scene"] as Key[]).some((k) => changed.has(k))) this.#list();
      if ((["parts", "height", "scene", "pair"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
  }

  get isShown(): boolean {
    return !this.element.hidden;
  }

  #choose(interval: Interval | null): void {
    this.session.store.change({ height: interval && middleOf(interval) });
  }

  /** Where in the stack the chosen interval is; -1 if all heights are shown. */
  get #chosen(): number {
    const at = this.session.interval;
    return at ? this.#intervals.findIndex(([lo]) => lo === at[0]) : -1;
  }

  /** A click on what is chosen leads back to all heights. */
  #click(event: MouseEvent): void {
    const { y0, scale, lo } = this.#plot();
    const z = lo + (y0 - (event.clientY - this.svg.getBoundingClientRect().top)) / scale;
    const found = this.#intervals.findIndex((interval) => z < interval[1]);
    const index = found < 0 ? this.#intervals.length - 1 : found;
    this.#choose(index === this.#chosen ? null : (this.#intervals[index] ?? null));
  }

  /** The list, the highest on top as in the picture, so that the arrow keys go up and down. */
  #list(): void {
    const texts = ["All heights", ...[...this.#intervals].reverse().map((interval) => this.#text(interval))];
    // An open list would be closed by other entries.
    if (texts.join("\n") !== [...this.#choice.options].map((o) => o.text).join("\n")) this.#choice.replaceChildren(...texts.map((text) => html("option", {}, text)));
    const chosen = this.#chosen;
    this.#choice.selectedIndex = chosen < 0 ? 0 : this.#intervals.length - chosen;
  }

  #text([lo, hi]: Interval): string {
    return `${short(lo)} to ${length(hi, this.session.scene.unit)}`;
  }

  /** Where the lowest height is, and pixels per unit upwards. */
  #plot(): { rem: number; width: number; height: number; lo: number; hi: number; y0: number; scale: number } {
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const { width, height } = this.svg.getBoundingClientRect();
    const lo = this.#intervals[0]?.[0] ?? 0;
    const hi = this.#intervals.at(-1)?.[1] ?? 1;
    const y0 = height - BELOW * rem;
    return { rem, width, height, lo, hi, y0, scale: (y0 - ABOVE * rem) / (hi - lo) };
  }

  #draw(): void {
    const { rem, width, height, lo, hi, y0, scale } = this.#plot();
    if (this.#intervals.length === 0 || width === 0 || !(scale > 0)) return;
    const { state, pair, scene, interval } = this.session;
    const y = (z: number) => y0 - (z - lo) * scale;
    const left = NUMBERS * rem;
    const column = (width - left) / state.parts.length;
    const beyond = BEYOND * rem;
    const ends = [lo, ...this.#intervals.map(([, top]) => top)];
    const drawn: SVGElement[] = [];
    if (interval) {
      const band = { x: left, y: y(interval[1]), width: width - left, height: (interval[1] - interval[0]) * scale };
      drawn.push(svg("rect", { class: "stack-chosen", ...band }, svg("title", {}, this.#text(interval))));
    }
    drawn.push(svg("path", { class: "grid", d: ends.map((z) => `M${left} ${y(z)}H${width}`).join("") }));
    const names: SVGElement[] = [];
    state.parts.forEach((part, i) => {
      const x0 = left + (i + BETWEEN / 2) * column;
      const role = i === pair?.fixed ? "fixed" : i === pair?.moving ? "moving" : "other";
      const group = svg("g", { class: `part ${role}` });
      for (const { z, text, share } of layersOf(part, (z) => this.#text(z))) {
        const top = z ? y(z[1]) : y(hi) - beyond;
        const bottom = z ? y(z[0]) : y0 + beyond;
        const w = Math.max(LEAST, (share[1] - share[0]) * (1 - BETWEEN) * column);
        const box = { x: x0 + share[0] * (1 - BETWEEN) * column, y: top, width: w, height: Math.max(LEAST, bottom - top) };
        const kind = !isAt(z, interval) ? " away" : part.layers.length > 1 && !interval ? " layer" : "";
        group.append(svg("rect", { class: `outline${kind}`, ...box }, svg("title", {}, text)));
      }
      drawn.push(group);
      // Along the column, from the bottom upwards.
      const at = { x: left + (i + 0.5) * column, y: y0 - 0.4 * rem };
      names.push(svg("text", { ...at, transform: `rotate(-90 ${at.x} ${at.y})`, "dominant-baseline": "central" }, part.name));
    });
    drawn.push(svg("g", { class: "part-names" }, ...names));
    drawn.push(svg("path", { class: "stack-axis", d: `M${left} ${height}V${ABOVE * rem - beyond}${ends.map((z) => `M${left - 4} ${y(z)}h4`).join("")}` }));
    drawn.push(svg("g", { class: "grid-numbers" }, ...this.#numbers(ends, y, left, rem)));
    set(this.svg, { "aria-label": `Side view, heights ${scene.unit ? `in ${scene.unit} ` : ""}upwards. ${state.parts.map((part) => layersOf(part, (z) => this.#text(z)).map(({ text }) => text).join("; ")).join("; ")}` });
    this.svg.replaceChildren(...drawn);
  }

  /** Of heights too near to each other for their numbers, the lower is written; the ends of the stack always are. */
  #numbers(ends: readonly number[], y: (z: number) => number, left: number, rem: number): SVGElement[] {
    const { unit } = this.session.scene;
    const written: number[] = [];
    for (const z of [ends[0], ends.at(-1), ...ends]) {
      if (z !== undefined && written.every((other) => Math.abs(y(other) - y(z)) >= LINE * rem)) written.push(z);
    }
    const number = (z: number) => svg("text", { x: left - 6, y: y(z), "text-anchor": "end", "dominant-baseline": "central" }, short(z));
    return [...written.map(number), svg("text", { x: left, y: 0.8 * rem, "text-anchor": "middle", class: "unit" }, unit ? `z, ${unit}` : "z")];
  }
}

/** The layers of a part, what is said of each, and from where to where it is in the extent of the part along x. */
function layersOf(part: ScenePart, text: (z: Interval) => string): { z: Interval | null; text: string; share: Interval }[] {
  const all = boxOf(part.loops);
  const width = all.x1 - all.x0;
  return part.layers.map(({ z, loops }) => {
    const box = boxOf(loops.map((l) => part.loops[l] ?? []));
    const share: Interval = width > 0 ? [(box.x0 - all.x0) / width, (box.x1 - all.x0) / width] : [0, 1];
    return { z, text: `${part.name}, ${z ? `z ${text(z)}` : "at every height"}`, share };
  });
}

/** Coordinates over time, beside the playing of a record: a strip for each, with a cursor where it is played. */

import { html, say, set, svg } from "./dom.js";
import { degrees, length, within } from "./numbers.js";
import { graphOf, seriesOf, valueAt } from "./record-series.js";
import type { Series } from "./record-series.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { HEIGHT, WIDTH, shareAt, stretched } from "./strip-plot.js";

/** As many strips are drawn. */
const MOST = 24;

interface Strip {
  series: Series;
  value: HTMLElement;
}

export class Graphs {
  readonly #session: Session;
  readonly #element: HTMLElement;
  #strips: Strip[] = [];

  constructor(parent: HTMLElement, session: Session) {
    this.#session = session;
    this.#element = parent;
    session.store.subscribe((changed) => {
      if (changed.has("record") || changed.has("pair")) this.#build();
      if ((["record", "pair", "time"] as Key[]).some((k) => changed.has(k))) this.#follow();
    });
  }

  #build(): void {
    const { state, scene, pair } = this.#session;
    const record = state.record;
    this.#element.hidden = !record;
    const name = (part: number | undefined) => (part === undefined ? "" : (scene.parts[part]?.name ?? ""));
    const all = record ? seriesOf(record, state.parts, { fixed: name(pair?.fixed), moving: name(pair?.moving) }) : [];
    this.#strips = all.slice(0, MOST).map((series) => ({ series, value: html("output") }));
    const more = all.length > MOST ? [html("p", { class: "faint" }, `and ${all.length - MOST} more coordinates`)] : [];
    this.#element.replaceChildren(...this.#strips.map((strip) => this.#draw(strip, record?.duration ?? 0)), ...more);
  }

  #draw({ series, value }: Strip, duration: number): HTMLElement {
    const points = graphOf(series, duration, WIDTH / 2);
    const d = points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x * WIDTH} ${(1 - y) * HEIGHT}`).join("");
    const ends = html("span", { class: "faint" }, `${this.#text(series, series.lo)} to ${this.#text(series, series.hi)}`);
    const plot = html("div", { class: "plot" }, ...stretched(svg("path", { d })));
    const to = (event: PointerEvent) => {
      this.#session.store.change({ time: shareAt(plot, event) * duration, playing: false });
    };
    plot.addEventListener("pointerdown", (event) => {
      plot.setPointerCapture(event.pointerId);
      to(event);
    });
    plot.addEventListener("pointermove", (event) => {
      if (plot.hasPointerCapture(event.pointerId)) to(event);
    });
    return html("div", { class: "strip" }, html("div", { class: "strip-head" }, html("b", {}, series.name), value, ends), plot);
  }

  #text({ kind, lo, hi }: Series, value: number): string {
    return kind === "angle" ? degrees(value, 4, hi - lo) : length(within(value, hi - lo, 4), this.#session.scene.unit);
  }

  #follow(): void {
    const { record, time } = this.#session.state;
    if (!record) return;
    set(this.#element, { style: `--at: ${record.duration > 0 ? (100 * time) / record.duration : 0}%` });
    for (const { series, value } of this.#strips) say(value, this.#text(series, valueAt(series, time, record.kind === "plan")));
  }
}

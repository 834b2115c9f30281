/** Coordinates over time, beside the playing of a record: a strip for each, with a cursor where it is played. */

import { button, download, fileName, html, say, set, svg } from "./dom.js";
import { degrees, length, within } from "./numbers.js";
import { stretches, type PlayableRecord } from "./playable.js";
import { csvOf, graphOf, seriesOf, valueAt, type Series } from "./record-series.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { HEIGHT, WIDTH, atOnce, numbers, shareAt, stretched } from "./strip-plot.js";

/** As many strips are drawn. */
const MOST = 24;

interface Strip {
  series: Series;
  value: HTMLElement;
}

export class Graphs {
  #strips: Strip[] = [];

  constructor(private readonly element: HTMLElement, private readonly session: Session) {
    session.store.subscribe((changed) => {
      if (changed.has("record") || changed.has("pair")) this.#build();
      if ((["record", "pair", "time"] as Key[]).some((k) => changed.has(k))) this.#follow();
    });
  }

  #build(): void {
    const { state, scene, pair } = this.session;
    const record = state.record;
    this.element.hidden = !record;
    const name = (part: number | undefined) => (part === undefined ? "" : (scene.parts[part]?.name ?? ""));
    const all = record ? seriesOf(record, state.parts, { fixed: name(pair?.fixed), moving: name(pair?.moving) }, scene.unit) : [];
    this.#strips = all.slice(0, MOST).map((series) => ({ series, value: html("output") }));
    const more = all.length > MOST ? [html("p", { class: "faint" }, `and ${all.length - MOST} more coordinates`)] : [];
    if (!record) return;
    const save = () => download(fileName(record.name.replace(/\.json(\.gz)?$/, ""), "csv"), new Blob([csvOf(record, all, scene.unit)], { type: "text/csv" }));
    const csv = button("CSV", save, { class: "small", title: "Save all coordinates over time as a table" });
    this.element.replaceChildren(csv, ...this.#strips.map((strip) => this.#draw(strip, record)), numbers(record), ...more);
  }

  #draw({ series, value }: Strip, record: PlayableRecord): HTMLElement {
    const { duration } = record;
    const points = graphOf(series, duration, WIDTH / 2);
    const d = points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x * WIDTH} ${(1 - y) * HEIGHT}`).join("");
    const ends = html("span", { class: "faint" }, `${this.#text(series, series.lo)} to ${this.#text(series, series.hi)}`);
    const shades = stretches(record).map(([from, to]) => svg("rect", { class: "at-once", x: (from / duration) * WIDTH, width: ((to - from) / duration) * WIDTH, y: 0, height: HEIGHT }));
    const plot = html("div", { class: "plot", title: shades.length > 0 ? atOnce : null }, ...stretched(...shades, svg("path", { d })));
    const to = (event: PointerEvent) => {
      this.session.store.change({ time: shareAt(plot, event) * duration, playing: false });
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

  #text({ kind, unit, lo, hi }: Series, value: number): string {
    return kind === "angle" ? degrees(value, 4, hi - lo) : length(within(value, hi - lo, 4), kind === "load" ? (unit ?? null) : this.session.scene.unit);
  }

  #follow(): void {
    const { record, time } = this.session.state;
    if (!record) return;
    set(this.element, { style: `--at: ${record.duration > 0 ? (100 * time) / record.duration : 0}%` });
    for (const { series, value } of this.#strips) say(value, this.#text(series, valueAt(series, time, record.kind === "plan")));
  }
}

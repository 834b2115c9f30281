/** The drawing of a strip: it is stretched to the strip's size, and has a cursor at the share `--at` of its width. */

import { html, svg } from "./dom.js";
import { timeNumbers, type PlayableRecord } from "./playable.js";
import { SNAP_SECONDS } from "./records.js";

/** The drawing's own width and height. */
export const WIDTH = 600;
export const HEIGHT = 100;

/** What is drawn, with the cursor above it. */
export function stretched(...drawn: SVGElement[]): Element[] {
  const graph = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", "aria-hidden": "true" }, ...drawn);
  return [graph, html("i", { class: "cursor" })];
}

/** The values at the ends of both axes: texts below from left to right, and on the left the highest and the lowest. */
export function axes(below: readonly string[], left: readonly string[]): Element[] {
  const texts = (of: readonly string[], on: string) => html("div", { class: `axis ${on}`, "aria-hidden": "true" }, ...of.map((text) => html("span", {}, text)));
  return [texts(below, "below"), texts(left, "left")];
}

/** What is said of what is shaded. */
export const atOnce = `Shaded: what happens at once is played in ${SNAP_SECONDS} s.`;

/** The axis of time below a track or graphs. */
export function numbers(record: PlayableRecord): HTMLElement {
  const at = (t: number) => `left: ${(100 * t) / (record.duration || 1)}%`;
  const all = timeNumbers(record);
  return html("div", { class: "time-axis", "aria-hidden": "true" }, ...all.map(({ t, text }, i) => html("span", { style: at(t) }, i === all.length - 1 ? `${text} s` : text)));
}

/** Where a pointer is along a strip, as a share of its width from 0 to 1. */
export function shareAt(plot: Element, event: MouseEvent): number {
  const r = plot.getBoundingClientRect();
  return Math.min(1, Math.max(0, (event.clientX - r.left) / Math.max(1, r.width)));
}

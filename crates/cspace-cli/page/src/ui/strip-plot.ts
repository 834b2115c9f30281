/** The drawing of a strip: it is stretched to the strip's size, and has a cursor at the share `--at` of its width. */

import { html, svg } from "./dom.js";

/** The drawing's own width and height. */
export const WIDTH = 600;
export const HEIGHT = 100;

/** What is drawn, with the cursor above it. */
export function stretched(...drawn: SVGElement[]): Element[] {
  const graph = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", "aria-hidden": "true" }, ...drawn);
  return [graph, html("i", { class: "cursor" })];
}

/** Where a pointer is along a strip, as a share of its width from 0 to 1. */
export function shareAt(plot: Element, event: MouseEvent): number {
  const r = plot.getBoundingClientRect();
  return Math.min(1, Math.max(0, (event.clientX - r.left) / Math.max(1, r.width)));
}

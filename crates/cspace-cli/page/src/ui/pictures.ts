/** Pictures of what is seen: the parts beside the space, as SVG or PNG. */

import { svg } from "./dom.js";

/** What CSS says of elements that a file has to say itself. */
const PROPERTIES = [
  "fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-opacity", "stroke-linecap", "stroke-linejoin", "stroke-dasharray",
  "vector-effect", "opacity", "visibility", "display", "font-size", "font-family", "font-weight", "paint-order", "text-anchor", "dominant-baseline",
] as const;

/** PNG files have this many pixels for each of the screen's. */
const PNG_SCALE = 2;

/** One of the views side by side: an SVG, or a canvas that has been drawn just now. */
export type Pane = SVGSVGElement | HTMLCanvasElement;

interface Picture {
  text: string;
  width: number;
  height: number;
}

/** Around what is drawn (pixels). */
const BORDER = 24;
/** Numbers nearer to an edge of a pane belong to it (pixels). */
const EDGE = 10;
/** The line of words below (pixels), and the size of its font. */
const LINE = 26;
const FONT = 15;

/** The panes beside each other, each as far as something is drawn in it, with a line of words below. */
export function picture(panes: readonly Pane[], background: string, colour: string, title: string): Picture {
  const sizes = panes.map(drawnIn);
  const width = sizes.reduce((sum, s) => sum + s.width, 0);
  const tallest = Math.max(...sizes.map((s) => s.height));
  const height = tallest + LINE;
  const root = svg("svg", { xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `0 0 ${width} ${height}` }, svg("title", {}, title));
  root.append(svg("rect", { width, height, fill: background }));
  let x = 0;
  panes.forEach((pane, i) => {
    const size = sizes[i];
    if (!size) return;
    const box = { x, y: (tallest - size.height) / 2, width: size.width, height: size.height };
    const { x: left, y: top } = pane.getBoundingClientRect();
    if (pane instanceof SVGSVGElement) root.append(svg("svg", { ...box, viewBox: `${size.x - left} ${size.y - top} ${size.width} ${size.height}`, overflow: "hidden" }, ...styled(pane, size)));
    else root.append(svg("image", { ...box, href: pane.toDataURL("image/png") }), ...labelsOf(pane, box.x - size.x, box.y - size.y));
    x += size.width;
  });
  root.append(svg("text", { x: FONT / 2, y: height - FONT / 2, fill: colour, "font-size": FONT, "font-family": "system-ui, sans-serif" }, title));
  return { text: new XMLSerializer().serializeToString(root), width, height };
}

/** The part of a pane in which something is drawn, beside the grid. */
function drawnIn(pane: Pane): DOMRect {
  const all = pane.getBoundingClientRect();
  const drawn = [...pane.querySelectorAll(":scope > g:not(.grid-numbers) :is(path, rect, circle, text)")].map((e) => e.getBoundingClientRect()).filter((r) => r.width + r.height > 0);
  if (drawn.length === 0) return all;
  const within = (a: number, from: number, to: number) => Math.min(to, Math.max(from, a));
  const [x0, x1] = [Math.min(...drawn.map((r) => r.left)) - 2 * BORDER, Math.max(...drawn.map((r) => r.right)) + BORDER].map((x) => within(x, all.left, all.right)) as [number, number];
  const [y0, y1] = [Math.min(...drawn.map((r) => r.top)) - BORDER, Math.max(...drawn.map((r) => r.bottom)) + BORDER].map((y) => within(y, all.top, all.bottom)) as [number, number];
  return new DOMRect(x0, y0, x1 - x0, y1 - y0);
}

/** The numbers that the page lays over a canvas, as text. */
function labelsOf(canvas: HTMLCanvasElement, dx: number, dy: number): SVGElement[] {
  return [...(canvas.parentElement?.querySelectorAll<HTMLElement>(".space-labels span:not([hidden])") ?? [])].map((label) => {
    const at = label.getBoundingClientRect();
    const style = getComputedStyle(label);
    const attributes = { "text-anchor": "middle", "dominant-baseline": "central", fill: style.color, "font-size": style.fontSize, "font-family": style.fontFamily };
    return svg("text", { x: at.x + at.width / 2 + dx, y: at.y + at.height / 2 + dy, ...attributes }, label.textContent ?? "");
  });
}

function styled(from: SVGSVGElement, seen: DOMRect): Node[] {
  const copy = from.cloneNode(true) as SVGSVGElement;
  const originals = from.querySelectorAll("*");
  copy.querySelectorAll("*").forEach((element, i) => {
    const original = originals[i];
    if (!original) return;
    const style = getComputedStyle(original);
    for (const name of PROPERTIES) {
      const value = style.getPropertyValue(name);
      if (value && value !== "none" && value !== "normal") element.setAttribute(name, value);
      else if (name === "fill" || name === "stroke") element.setAttribute(name, "none");
    }
    element.removeAttribute("class");
  });
  // The numbers of the grid stand at the edges of what is seen.
  const all = from.getBoundingClientRect();
  const grid = [...from.children].findIndex((e) => e.classList.contains("grid-numbers"));
  const [left, right, top, bottom] = [seen.left - all.left, seen.right - all.left, seen.top - all.top, seen.bottom - all.top];
  for (const text of [...(copy.children[grid]?.children ?? [])]) {
    const [x, y] = [Number(text.getAttribute("x")), Number(text.getAttribute("y"))];
    const [isBelow, isUnit] = [y > all.height - EDGE, x > all.width - EDGE];
    if (isBelow) text.setAttribute("y", String(y - all.height + bottom));
    if (isUnit) text.setAttribute("x", String(x - all.width + right));
    else if (!isBelow && x < EDGE) text.setAttribute("x", String(x + left));
    // Those of what is cut off, and in the corners.
    if (!isUnit && (isBelow ? x < left || x > right - 2 * BORDER : y < top + EDGE || y > bottom - LINE)) text.remove();
  }
  // What only catches the pointer is no part of a picture.
  for (const grip of [...from.querySelectorAll("*")].flatMap((e, i) => (e.classList.contains("grip") ? [i] : []))) {
    copy.querySelectorAll("*")[grip]?.setAttribute("data-gone", "");
  }
  copy.querySelectorAll("[data-gone]").forEach((e) => e.remove());
  return [...copy.childNodes];
}

export function svgFile({ text }: Picture): Blob {
  return new Blob([`<?xml version="1.0" encoding="UTF-8"?>\n${text}\n`], { type: "image/svg+xml" });
}

export async function pngFile(of: Picture): Promise<Blob> {
  const image = new Image();
  const url = URL.createObjectURL(svgFile(of));
  try {
    await new Promise<void>((resolve, reject) => {
      image.onload = () => resolve();
      image.onerror = () => reject(new Error("the picture cannot be drawn"));
      image.src = url;
    });
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(of.width * PNG_SCALE);
    canvas.height = Math.round(of.height * PNG_SCALE);
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise<Blob>((resolve, reject) => {
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the browser makes no PNG"))), "image/png");
    });
  } finally {
    URL.revokeObjectURL(url);
  }
}

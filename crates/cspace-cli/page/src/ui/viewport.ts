/** A plane that is panned and zoomed: an SVG in which the model's y points upwards, with a grid and its numbers. */

import type { Place } from "../scene.js";
import { set, svg } from "./dom.js";
import { gridLines, heldScale, lineText } from "./grid.js";
import { angleStep, lengthStep } from "./numbers.js";
import { centerOf, type Box } from "./outline.js";
import { turnBetween } from "./placement.js";

/** What is dragged, if not the plane itself. */
export interface Drag {
  move(to: Place, event: PointerEvent): void;
  end?(): void;
}

export interface ViewportOptions {
  /** Whether a unit is as long along both axes. */
  uniform: boolean;
  label: string;
  /** Shows everything. */
  fit(): void;
  /** Begins to drag what is at a place; null if there is nothing. */
  grab(at: Place, event: PointerEvent): Drag | null;
  /** Of a part that one finger has taken: turns it, as a second finger goes about the first; null where the two zoom. */
  twist?(event: PointerEvent): ((by: number, about: Place) => void) | null;
  /** Whether the wheel is for what is at a place, and not to zoom. */
  wheel?(at: Place, event: WheelEvent): boolean;
  /** Whether a double click is for what is at a place, and not to show everything. */
  double?(at: Place): boolean;
}

export type AxisKind = "length" | "angle";

/** Grid lines are at least this far apart, in pixels. */
const GRID_PIXELS = 56;
/** About as wide as a character of the grid's numbers is, and as high as their line (root ems). */
const CHARACTER = 0.5;
const LINE = 1.4;
/** A unit of more characters, such as the names of two motions, is long. */
const LONG = 8;
/** It begins so far from the left edge, beside the numbers (rem). */
const BESIDE = 3.5;

/** The room between numbers of the grid, and between them and the unit, in pixels. */
const NUMBER_GAP = 10;
/** A box without width is shown as if it had this share of its distance from the origin. */
const LEAST_WIDTH = 1e-9;
/** A notch of the wheel zooms by this factor. */
const ZOOM_PER_PIXEL = 1.0015;

export class Viewport {
  readonly svg: SVGSVGElement;
  /** In the model's unit. */
  readonly world = svg("g");
  /** In pixels, on top. */
  readonly overlay = svg("g");
  /** What depends on the scale is drawn again. */
  onView: (() => void) | null = null;
  unit = "";
  kinds: [AxisKind, AxisKind] = ["length", "length"];

  readonly #grid = svg("path", { class: "grid" });
  readonly #axes = svg("path", { class: "grid-axes" });
  readonly #numbers = svg("g", { class: "grid-numbers", "aria-hidden": "true" });
  #center: Place = { x: 0, y: 0 };
  /** Pixels per unit. */
  #scale: Place = { x: 1, y: 1 };
  #width = 1;
  #height = 1;
  #fitted: { box: Box; margin: number } | null = null;
  #touched = false;
  readonly #pointers = new Map<number, { x: number; y: number }>();
  #drag: Drag | null = null;
  #dragPointer = -1;
  #twist: ((by: number, about: Place) => void) | null = null;

  constructor(parent: HTMLElement, private readonly options: ViewportOptions) {
    this.svg = svg("svg", { class: "viewport", role: "application", "aria-label": options.label, tabindex: 0 });
    this.svg.append(this.#grid, this.#axes, this.world, this.#numbers, this.overlay);
    parent.append(this.svg);
    this.#listen();
    new ResizeObserver(() => this.#resized()).observe(this.svg);
    this.#resized();
  }

  /** In pixels. */
  get size(): { width: number; height: number } {
    return { width: this.#width, height: this.#height };
  }

  get pixel(): Place {
    return { x: 1 / this.#scale.x, y: 1 / this.#scale.y };
  }

  /** What is seen. */
  get box(): Box {
    const [w, h] = [this.#width / 2 / this.#scale.x, this.#height / 2 / this.#scale.y];
    return { x0: this.#center.x - w, y0: this.#center.y - h, x1: this.#center.x + w, y1: this.#center.y + h };
  }

  toScreen(p: Place): Place {
    return { x: this.#width / 2 + (p.x - this.#center.x) * this.#scale.x, y: this.#height / 2 - (p.y - this.#center.y) * this.#scale.y };
  }

  toWorld(client: { clientX: number; clientY: number }): Place {
    const r = this.svg.getBoundingClientRect();
    return {
      x: this.#center.x + (client.clientX - r.left - this.#width / 2) / this.#scale.x,
      y: this.#center.y - (client.clientY - r.top - this.#height / 2) / this.#scale.y,
    };
  }

  /** Shows a box; again whenever the size changes, until the user pans or zooms. */
  fit(box: Box, margin = 0.1): void {
    if (!(box.x1 >= box.x0) || !(box.y1 >= box.y0) || !Object.values(box).every(Number.isFinite)) return;
    this.#fitted = { box, margin };
    this.#touched = false;
    const { x: w, y: h } = extentOf(box);
    const x = this.#width / (w * (1 + 2 * margin));
    const y = this.#height / (h * (1 + 2 * margin));
    const least = Math.min(x, y);
    this.#center = centerOf(box);
    this.#scale = this.options.uniform ? { x: least, y: least } : { x, y };
    this.#draw();
  }

  zoom(factor: number, about: Place = this.#center): void {
    factor = this.#held(factor);
    if (factor === 1) return;
    this.#touched = true;
    this.#scale = { x: this.#scale.x * factor, y: this.#scale.y * factor };
    this.#center = { x: about.x + (this.#center.x - about.x) / factor, y: about.y + (this.#center.y - about.y) / factor };
    this.#draw();
  }

  /** As much of a zoom as the limits of both axes leave. */
  #held(factor: number): number {
    if (!this.#fitted) return factor;
    const { x, y } = extentOf(this.#fitted.box);
    // One extent for both axes where they have one scale.
    const [w, h] = this.options.uniform ? [Math.max(x, y), Math.max(x, y)] : [x, y];
    const by = [
      heldScale(this.#scale.x * factor, w, this.#center.x) / this.#scale.x,
      heldScale(this.#scale.y * factor, h, this.#center.y) / this.#scale.y,
    ];
    // Panning may have taken the centre to where the present scale is too fine: that is not a reason to zoom the other way.
    return factor > 1 ? Math.max(1, Math.min(...by)) : Math.min(1, Math.max(...by));
  }

  #pan(dx: number, dy: number): void {
    this.#touched = true;
    this.#center = { x: this.#center.x - dx / this.#scale.x, y: this.#center.y + dy / this.#scale.y };
    this.#draw();
  }

  #resized(): void {
    const { width, height } = this.svg.getBoundingClientRect();
    if (width === 0 || height === 0) return;
    [this.#width, this.#height] = [width, height];
    if (this.#fitted && !this.#touched) this.fit(this.#fitted.box, this.#fitted.margin);
    else this.#draw();
  }

  #draw(): void {
    const { x: sx, y: sy } = this.#scale;
    const origin = this.toScreen({ x: 0, y: 0 });
    set(this.world, { transform: `matrix(${sx} 0 0 ${-sy} ${origin.x} ${origin.y})` });
    this.#drawGrid(origin);
    this.onView?.();
  }

  #drawGrid(origin: Place): void {
    const box = this.box;
    const steps = [this.kinds[0] === "angle" ? angleStep : lengthStep, this.kinds[1] === "angle" ? angleStep : lengthStep] as const;
    const dx = steps[0](GRID_PIXELS / this.#scale.x);
    const dy = this.options.uniform ? dx : steps[1](GRID_PIXELS / this.#scale.y);
    const lines: string[] = [];
    const numbers: SVGElement[] = [];
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const widthOf = (text: string) => text.length * CHARACTER * rem;
    const label = (kind: AxisKind, value: number, step: number) =>
      kind === "angle" ? `${lineText((value * 180) / Math.PI, (step * 180) / Math.PI)}°` : lineText(value, step);
    // The unit has the corner for itself, with a larger font; what is long stands above, beside the numbers.
    const isLong = this.unit.length > LONG;
    const end = this.#width - (this.unit && !isLong ? 1.2 * widthOf(this.unit) + rem : 0);
    const across = gridLines(box.x0, box.x1, dx).map(({ index, value }) => ({ index, x: this.toScreen({ x: value, y: 0 }).x, text: label(this.kinds[0], value, dx) }));
    // Long numbers stand at every second or third line.
    const every = Math.max(1, Math.ceil((Math.max(...across.map(({ text }) => widthOf(text))) + NUMBER_GAP) / (dx * this.#scale.x)));
    for (const { index, x, text } of across) {
      lines.push(`M${x} 0V${this.#height}`);
      if (index % every === 0 && x + 3 + widthOf(text) < end) numbers.push(svg("text", { x: x + 3, y: this.#height - 5 }, text));
    }
    for (const { value } of gridLines(box.y0, box.y1, dy)) {
      const y = this.toScreen({ x: 0, y: value }).y;
      lines.push(`M0 ${y}H${this.#width}`);
      if (y < this.#height - LINE * rem) numbers.push(svg("text", { x: 4, y: y - 3 }, label(this.kinds[1], value, dy)));
    }
    const corner = isLong ? { x: BESIDE * rem, y: 1.2 * rem, "text-anchor": "start" } : { x: this.#width - 6, y: this.#height - 5, "text-anchor": "end" };
    if (this.unit) numbers.push(svg("text", { ...corner, class: "unit" }, this.unit));
    set(this.#grid, { d: lines.join("") });
    set(this.#axes, { d: `M${origin.x} 0V${this.#height}M0 ${origin.y}H${this.#width}` });
    this.#numbers.replaceChildren(...numbers);
  }

  #listen(): void {
    const element = this.svg;
    element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 && event.button !== 1) return;
      element.setPointerCapture(event.pointerId);
      this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (this.#pointers.size > 1) {
        this.#twist = (this.#drag && this.options.twist?.(event)) || null;
        this.#endDrag();
      } else if (event.button === 0) {
        this.#drag = this.options.grab(this.toWorld(event), event);
        this.#dragPointer = event.pointerId;
      }
    });
    element.addEventListener("pointermove", (event) => {
      const before = this.#pointers.get(event.pointerId);
      if (!before) return;
      if (this.#drag && event.pointerId === this.#dragPointer) {
        this.#drag.move(this.toWorld(event), event);
        this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        return;
      }
      const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const was = Math.hypot(before.x - other.x, before.y - other.y);
        const is = Math.hypot(event.clientX - other.x, event.clientY - other.y);
        if (this.#twist) {
          const by = turnBetween({ x: before.x - other.x, y: other.y - before.y }, { x: event.clientX - other.x, y: other.y - event.clientY });
          this.#twist(by, this.toWorld({ clientX: other.x, clientY: other.y }));
          this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
          return;
        }
        const middle = { clientX: (event.clientX + other.x) / 2, clientY: (event.clientY + other.y) / 2 };
        if (was > 0 && is > 0) this.zoom(is / was, this.toWorld(middle));
        this.#pan((event.clientX - before.x) / 2, (event.clientY - before.y) / 2);
      } else {
        this.#pan(event.clientX - before.x, event.clientY - before.y);
      }
      this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    const up = (event: PointerEvent) => {
      this.#pointers.delete(event.pointerId);
      this.#twist = null;
      if (event.pointerId === this.#dragPointer) this.#endDrag();
    };
    element.addEventListener("pointerup", up);
    element.addEventListener("pointercancel", up);
    element.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const at = this.toWorld(event);
        // The browser tells a pinch on a touch pad as a wheel with Ctrl.
        if (!event.ctrlKey && this.options.wheel?.(at, event)) return;
        this.zoom(ZOOM_PER_PIXEL ** -wheelPixels(event), at);
      },
      { passive: false },
    );
    element.addEventListener("dblclick", (event) => {
      if (!this.options.double?.(this.toWorld(event))) this.options.fit();
    });
  }

  #endDrag(): void {
    this.#drag?.end?.();
    this.#drag = null;
    this.#dragPointer = -1;
  }
}

function extentOf(box: Box): Place {
  return {
    x: Math.max(box.x1 - box.x0, LEAST_WIDTH * Math.abs(box.x0)) || 1,
    y: Math.max(box.y1 - box.y0, LEAST_WIDTH * Math.abs(box.y0)) || 1,
  };
}

/** How far a wheel turned, in pixels, whatever it counts in. */
export function wheelPixels(event: WheelEvent): number {
  const perUnit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : event.deltaMode === WheelEvent.DOM_DELTA_PAGE ? 400 : 1;
  // With Shift some systems turn the wheel sideways.
  return (event.deltaY || event.deltaX) * perUnit;
}

/** Pixels that a part slides for each of the wheel. */
const SLIDE = 1 / 20;
/** With Alt the wheel moves so much less. */
const FINE = 0.1;

/** How far a wheel's notch slides a part, in pixels. */
export function wheelSlide(event: WheelEvent): number {
  return -wheelPixels(event) * SLIDE * (event.altKey ? FINE : 1);
}

/** How much a wheel's notch turns a part. */
const RADIANS_PER_PIXEL = Math.PI / 180 / 50;

export function wheelAngle(event: WheelEvent): number {
  return -wheelPixels(event) * RADIANS_PER_PIXEL * (event.altKey ? FINE : 1);
}

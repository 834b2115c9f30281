/** The plane (u, v) of a pair with fixed axes: free regions, blocked space, contact curves, and the configuration. */

import type { AxesKernel, AxisInfo, DrawnCurve, FreePolygon } from "../kernel/api.js";
import type { Place } from "../scene.js";
import { regionColour } from "./colours.js";
import type { ContactHand } from "./contact-hand.js";
import { curvePaths, pathOf } from "./curves.js";
import { set, svg } from "./dom.js";
import { isAxes } from "./mechanism.js";
import { Lens, lensBox } from "./lens.js";
import { degrees, length, rounded } from "./numbers.js";
import { emptyBox, grow } from "./outline.js";
import type { Box } from "./outline.js";
import { TURN, wrap } from "./placement.js";
import { playOf } from "./play.js";
import type { Session } from "./session.js";
import { pointMark } from "./slice-view.js";
import type { Key, State } from "./state.js";
import { unhurried } from "./unhurried.js";
import { Viewport, wheelSlide } from "./viewport.js";
import type { Drag } from "./viewport.js";

const GRAB = 26;
/** Curves are drawn within this share of the smaller extent of the plane. */
const DEVIATION = 1 / 4000;
/** A part that stands still has a strip of this width (model unit or radians), so that there is something to see. */
const STILL = 1;
/** The lens follows so much later (ms): what bounds the room is found by motions. */
const LENS_PAUSE = 80;
/** Curves are drawn within this share of the lens. */
const LENS_DEVIATION = 1 / 200;

export class PlaneView {
  readonly viewport: Viewport;
  readonly #session: Session;
  /** What drags contact curves. */
  readonly #contacts: ContactHand | null;
  readonly #blocked: SVGRectElement;
  readonly #free: SVGGElement;
  readonly #curves: SVGGElement;
  readonly #path: SVGPathElement;
  readonly #point: SVGGElement;
  readonly #lens: Lens;
  readonly #lookCloser = unhurried(() => this.#drawLens(), LENS_PAUSE);
  #drawn: { kernel: AxesKernel; deviation: number; curves: DrawnCurve[]; free: FreePolygon[] } | null = null;

  constructor(parent: HTMLElement, session: Session, contacts: ContactHand | null) {
    this.#session = session;
    this.#contacts = contacts;
    this.viewport = new Viewport(parent, {
      uniform: false,
      fit: () => this.fit(),
      label: "The plane of the motions u and v of the two parts. Drag the point to move them.",
      grab: (at) => this.#grab(at),
      wheel: (at, event) => this.#wheel(at, event),
    });
    this.#blocked = svg("rect", { class: "blocked-space" });
    this.#free = svg("g");
    this.#curves = svg("g");
    this.#path = svg("path", { class: "way" });
    const clip = svg("clipPath", { id: "plane-period" }, svg("rect"));
    const content = svg("g", { "clip-path": "url(#plane-period)" }, this.#blocked, this.#free, this.#path, this.#curves);
    this.viewport.world.append(clip, content);
    this.#point = pointMark();
    this.viewport.overlay.append(this.#point);
    this.#lens = new Lens(this.viewport, "plane-lens");
    this.viewport.onView = () => {
      this.#placePoint();
      this.#lookCloser();
    };
    session.store.subscribe((changed, state) => this.#update(changed, state));
  }

  #update(changed: ReadonlySet<Key>, state: Readonly<State>): void {
    const kernel = this.#session.axes;
    if (!kernel) return;
    if (changed.has("space")) this.#build(kernel, !state.editing);
    if (["space", "where", "colouring", "hidden"].some((k) => changed.has(k as Key))) this.#paint(state, kernel);
    if (changed.has("record") || changed.has("space")) this.#drawPath(state, kernel);
    if (changed.has("configuration") || changed.has("space")) this.#placePoint();
    if (["configuration", "space", "where", "colouring", "hidden"].some((k) => changed.has(k as Key))) this.#lookCloser();
    if (changed.has("where")) set(this.#point, { class: `point ${state.where.classification ?? "unknown"}` });
  }

  #build(kernel: AxesKernel, fit: boolean): void {
    const box = periodOf(kernel);
    this.viewport.kinds = [kernel.u.kind === "angle" ? "angle" : "length", kernel.v.kind === "angle" ? "angle" : "length"];
    this.viewport.unit = this.#axisText();
    const attributes = { x: box.x0, y: box.y0, width: box.x1 - box.x0, height: box.y1 - box.y0 };
    set(this.#blocked, attributes);
    const clip = this.viewport.world.querySelector("clipPath rect");
    if (clip) set(clip, attributes);
    const deviation = Math.min(box.x1 - box.x0, box.y1 - box.y0) * DEVIATION;
    // Of a part that stands still a contact is one place, as far as the plane is drawn across.
    const isDrawn = ({ points }: DrawnCurve) => points.some((p, i) => p !== points[i % 2]);
    this.#drawn = { kernel, deviation, curves: kernel.curves(deviation).filter(isDrawn), free: kernel.free(deviation) };
    const byRegion = new Map<number, string>();
    for (const { region, points } of this.#drawn.free) byRegion.set(region, (byRegion.get(region) ?? "") + pathOf(points, true));
    this.#free.replaceChildren(
      ...[...byRegion].map(([region, d]) => svg("path", { class: "free-region", "data-region": region, fill: regionColour(region), stroke: regionColour(region), d }, svg("title", {}, `region ${region}`))),
    );
    if (fit) this.fit();
  }

  /** Shows the ranges of both motions, or a turn. */
  fit(): void {
    const kernel = this.#session.axes;
    if (kernel) this.viewport.fit(periodOf(kernel), 0.06);
  }

  /** Shows all of a region. */
  fitRegion(region: number): void {
    const box = emptyBox();
    for (const { region: of, points } of this.#drawn?.free ?? []) {
      if (of === region) for (let i = 0; i + 1 < points.length; i += 2) grow(box, { x: points[i] ?? 0, y: points[i + 1] ?? 0 });
    }
    this.viewport.fit(box, 0.06);
  }

  #drawLens(): void {
    const { axes: kernel, state } = this.#session;
    const c = state.configuration;
    const inside = state.where.classification === "free" || state.where.classification === "contact";
    const drawn = this.#drawn;
    if (!kernel || !isAxes(c) || !inside || drawn?.kernel !== kernel) return this.#lens.hide();
    const play = playOf(kernel as never, c);
    const of = (name: "u" | "v") => play.find((w) => w.coordinate === name) ?? { back: 0, forth: 0 };
    const at = inPeriod(kernel, c);
    const box = play.length === 2 ? lensBox(at, { across: of("u"), up: of("v") }, this.viewport.pixel, this.#lens.side) : null;
    if (!box) return this.#lens.hide();
    const within = Math.min(box.x1 - box.x0, box.y1 - box.y0) * LENS_DEVIATION;
    if (within < drawn.deviation) Object.assign(drawn, { deviation: within, curves: kernel.curves(within), free: kernel.free(within) });
    const shown = { colouring: state.colouring, hidden: state.hidden, touching: new Set(state.where.patches) };
    const rooms = drawn.free.map(({ region, points }) => svg("path", { class: "free-region", fill: regionColour(region), stroke: "none", d: pathOf(points, true) }));
    const blocked = svg("rect", { class: "blocked-space", x: box.x0, y: box.y0, width: box.x1 - box.x0, height: box.y1 - box.y0 });
    const text = (value: number, axis: AxisInfo) => (axis.kind === "angle" ? degrees(value, 3) : length(rounded(value), this.#session.scene.unit));
    this.#lens.show(
      box,
      at,
      state.where.classification,
      [blocked, svg("g", {}, ...rooms), ...curvePaths(kernel as never, drawn.curves, shown)],
      `${text(box.x1 - box.x0, kernel.u)} by ${text(box.y1 - box.y0, kernel.v)}`,
    );
  }

  #axisText(): string {
    const { pair, scene } = this.#session;
    const text = (part: number | undefined) => {
      const of = part === undefined ? undefined : scene.parts[part];
      const unit = of?.motion.type === "prismatic" && scene.unit ? ` (${scene.unit})` : "";
      return `${of?.name ?? ""}${unit}`;
    };
    return `→ ${text(pair?.fixed)}   ↑ ${text(pair?.moving)}`;
  }

  #paint(state: Readonly<State>, kernel: AxesKernel): void {
    if (this.#drawn?.kernel !== kernel) return;
    for (const path of this.#free.children) set(path, { visibility: state.hidden.has(Number(path.getAttribute("data-region"))) ? "hidden" : null });
    const shown = { colouring: state.colouring, hidden: state.hidden, touching: new Set(state.where.patches) };
    const paths = curvePaths(kernel as never, this.#drawn.curves, shown);
    // What runs over a period's end is seen at its beginning too.
    const shifts = (axis: AxisInfo) => (axis.round ? [-TURN, 0, TURN] : [0]);
    const copies = shifts(kernel.u).flatMap((u) =>
      shifts(kernel.v).map((v) => svg("g", { transform: `translate(${u} ${v})` }, ...paths.map((p) => p.cloneNode(true)))),
    );
    this.#curves.replaceChildren(...copies);
  }

  #drawPath(state: Readonly<State>, kernel: AxesKernel): void {
    const steps = state.record?.kind === "plan" ? state.record.steps : [];
    let d = "";
    for (let i = 0; i + 1 < steps.length; i += 1) {
      const [a, b] = [steps[i]?.at, steps[i + 1]?.at];
      if (!a || !b || !isAxes(a) || !isAxes(b)) continue;
      // Each leg begins in the period; its other end may lie outside, and is seen again by the next leg.
      const from = inPeriod(kernel, a);
      d += pathOf([from.x, from.y, from.x + b.u - a.u, from.y + b.v - a.v]);
    }
    set(this.#path, { d });
  }

  #placePoint(): void {
    const c = this.#session.state.configuration;
    const kernel = this.#session.axes;
    if (!kernel || !isAxes(c)) return;
    const { x, y } = this.viewport.toScreen(inPeriod(kernel, c));
    set(this.#point, { transform: `translate(${x} ${y})` });
  }

  #grab(at: Place): Drag | null {
    const c = this.#session.state.configuration;
    const kernel = this.#session.axes;
    if (!kernel || !isAxes(c)) return null;
    const p = inPeriod(kernel, c);
    const { x, y } = this.viewport.pixel;
    if (Math.hypot((at.x - p.x) / x, (at.y - p.y) / y) > GRAB) {
      return this.#contacts?.grab(at, this.viewport, kernel, this.#drawn?.curves ?? [], ({ x: u, y: v }) => ({ u, v })) ?? null;
    }
    const [du, dv] = [c.u - at.x, c.v - at.y];
    const { store } = this.#session;
    store.change({ dragging: true, playing: false });
    return {
      move: (to) => this.#session.aim({ u: to.x + du, v: to.y + dv }),
      end: () => store.change({ dragging: false }),
    };
  }

  #wheel(_at: Place, event: WheelEvent): boolean {
    if (!event.shiftKey && !this.#session.state.dragging) return false;
    this.#session.nudge(0, wheelSlide(event) * this.viewport.pixel.y);
    return true;
  }
}

function periodOf(kernel: AxesKernel): Box {
  const [u, v] = [rangeOf(kernel.u), rangeOf(kernel.v)];
  return { x0: u[0], y0: v[0], x1: u[1], y1: v[1] };
}

function rangeOf({ lo, hi, round }: AxisInfo): [number, number] {
  if (round) return [lo, lo + TURN];
  return hi > lo ? [lo, hi] : [lo - STILL / 2, lo + STILL / 2];
}

function inPeriod(kernel: AxesKernel, { u, v }: { u: number; v: number }): Place {
  return { x: kernel.u.round ? wrap(u, kernel.u.lo) : u, y: kernel.v.round ? wrap(v, kernel.v.lo) : v };
}

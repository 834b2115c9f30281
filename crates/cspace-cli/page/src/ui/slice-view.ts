/** The slice at the current orientation, in the plane. The point in it can be dragged. */

import type { Place } from "../scene.js";
import type { DrawnCurve, PlanarKernel } from "../kernel/api.js";
import type { ContactHand } from "./contact-hand.js";
import { curvePaths, loopsOf, pathOf } from "./curves.js";
import { set, svg } from "./dom.js";
import { DragGoal } from "./drag-goal.js";
import { isPlanar } from "./mechanism.js";
import { Lens, lensBox } from "./lens.js";
import { length, rounded } from "./numbers.js";
import { emptyBox, grow } from "./outline.js";
import type { Box } from "./outline.js";
import { playOf } from "./play.js";
import type { Session } from "./session.js";
import { sliceExtent } from "./slice-extent.js";
import { FAR, currentSlice, refine, swings } from "./slices.js";
import type { Key, State } from "./state.js";
import { unhurried } from "./unhurried.js";
import { cagedIn } from "./verdict.js";
import { Viewport, wheelAngle } from "./viewport.js";
import type { Drag } from "./viewport.js";

/** How near to the point it is grabbed, in pixels; fingers are thicker than mice. */
const GRAB = 26;
/** Ends of curves nearer than this share of the slice's extent are one point, to fill what they are around. */
const JOINED = 1e-6;
/** Curves are drawn within so many pixels, or finer. */
const DEVIATION_PIXELS = 0.25;
/** The lens follows so much later (ms): what bounds the room is found by motions. */
const LENS_PAUSE = 80;
/** Curves are drawn within this share of the lens. */
const LENS_DEVIATION = 1 / 1500;
/** Around a region that is shown alone, of its extent. */
const REGION_MARGIN = 0.3;

export class SliceView {
  readonly viewport: Viewport;
  readonly #session: Session;
  /** What drags contact curves. */
  readonly #contacts: ContactHand | null;
  /** Whether contacts of other orientations are too far away to be shown together. */
  #swings = false;
  readonly #curves: SVGGElement;
  readonly #blocked: SVGPathElement;
  readonly #path: SVGPathElement;
  readonly #point: SVGGElement;
  readonly #lens: Lens;
  readonly #lookCloser = unhurried(() => this.#drawLens(), LENS_PAUSE);

  constructor(parent: HTMLElement, session: Session, contacts: ContactHand | null) {
    this.#session = session;
    this.#contacts = contacts;
    this.viewport = new Viewport(parent, {
      uniform: true,
      fit: () => this.fit(),
      label: "The slice of the configuration space at the current orientation. Drag the point to move the part.",
      grab: (at) => this.#grab(at),
      wheel: (at, event) => {
        if (!session.state.dragging && !event.shiftKey && !this.#isNear(at)) return false;
        session.turn(wheelAngle(event));
        return true;
      },
    });
    this.viewport.unit = session.scene.unit ?? "";
    this.#path = svg("path", { class: "way" });
    this.#curves = svg("g");
    this.#blocked = svg("path", { class: "blocked-space", "fill-rule": "evenodd" });
    this.viewport.world.append(this.#blocked, this.#path, this.#curves);
    this.#point = pointMark();
    this.viewport.overlay.append(this.#point);
    this.#lens = new Lens(this.viewport, "slice-lens");
    this.viewport.onView = () => {
      if (refine(session, DEVIATION_PIXELS * this.viewport.pixel.x)) this.#drawCurves();
      this.#placePoint();
      this.#lookCloser();
    };
    session.store.subscribe((changed, state) => this.#update(changed, state));
  }

  #update(changed: ReadonlySet<Key>, state: Readonly<State>): void {
    const kernel = this.#session.planar;
    if (changed.has("space") && kernel && !state.editing) {
      this.fit();
      const region = cagedIn(this.#session);
      if (region !== null) this.fitRegion(region);
    }
    if (["configuration", "space", "where", "colouring", "hidden"].some((k) => changed.has(k as Key))) {
      if (changed.has("configuration")) this.#follow();
      this.#drawCurves(changed.has("configuration") || changed.has("space"));
      this.#placePoint();
      this.#lookCloser();
      set(this.#point, { class: `point ${state.where.classification ?? "unknown"}` });
    }
    if (changed.has("record")) {
      const steps = state.record?.kind === "plan" ? state.record.steps : [];
      if (kernel && steps.length > 0) this.fit();
      set(this.#path, { d: pathOf(steps.flatMap(({ at }) => (isPlanar(at) ? [at.x, at.y] : []))) });
    }
  }

  #drawCurves(fill = true): void {
    const { planar: kernel, state } = this.#session;
    const shown = { colouring: state.colouring, hidden: state.hidden, touching: new Set(state.where.patches) };
    if (fill) this.#fill(kernel);
    this.#curves.replaceChildren(...(kernel ? curvePaths(kernel as never, currentSlice(this.#session), shown) : []));
  }

  /** Shows all contacts, and the configuration and the way that is played if they are not far away. */
  fit(): void {
    const { planar: kernel, state } = this.#session;
    if (!kernel) return;
    const { lo, hi } = kernel.bounds();
    const far = FAR * sliceExtent(this.#session.state);
    this.#swings = swings(this.#session, kernel);
    const box = this.#swings ? boxOfCurves(currentSlice(this.#session)) : { x0: lo[0], y0: lo[1], x1: hi[0], y1: hi[1] };
    const c = state.configuration;
    if (isPlanar(c) && !(awayFrom(box, c) > far)) grow(box, c);
    for (const { at } of state.record?.kind === "plan" ? state.record.steps : []) if (isPlanar(at) && !(awayFrom(box, at) > far)) grow(box, at);
    this.viewport.fit(box);
  }

  /** Shows what bounds a region at the current orientation. */
  fitRegion(region: number): void {
    const { planar: kernel, state } = this.#session;
    const c = state.configuration;
    if (!kernel || !isPlanar(c)) return;
    const curves = currentSlice(this.#session).filter((curve) => curve.region === region);
    if (curves.length > 0) this.viewport.fit(boxOfCurves(curves), REGION_MARGIN);
  }

  #drawLens(): void {
    const { planar: kernel, state, scene } = this.#session;
    const { configuration: c, where } = state;
    const inside = where.classification === "free" || where.classification === "contact";
    if (!kernel || !isPlanar(c) || !inside) return this.#lens.hide();
    const [across, up] = playOf(kernel as never, c);
    const box = across && up && lensBox(c, { across, up }, this.viewport.pixel, this.#lens.side);
    if (!box) return this.#lens.hide();
    const curves = kernel.slice(c.theta, (box.x1 - box.x0) * LENS_DEVIATION);
    const loops = loopsOf(curves.map((curve) => curve.points), sliceExtent(this.#session.state) * JOINED);
    const shown = { colouring: state.colouring, hidden: state.hidden, touching: new Set(where.patches) };
    const blocked = svg("path", { class: "blocked-space", "fill-rule": "evenodd", d: loops.map((points) => pathOf(points, true)).join("") });
    this.#lens.show(box, c, where.classification, [blocked, ...curvePaths(kernel as never, curves, shown)], `${length(rounded(box.x1 - box.x0), scene.unit)} wide`);
  }

  /** Where contacts of other orientations are elsewhere, the view goes along. */
  #follow(): void {
    if (!this.#swings) return;
    const [seen, box] = [this.viewport.box, boxOfCurves(currentSlice(this.#session))];
    if (box.x0 > seen.x1 || box.x1 < seen.x0 || box.y0 > seen.y1 || box.y1 < seen.y0) this.fit();
  }

  /** Far away everything is free, so that what an odd number of loops is around is blocked. */
  #fill(kernel: PlanarKernel | null): void {
    const curves = kernel ? currentSlice(this.#session) : [];
    const loops = kernel ? loopsOf(curves.map((c) => c.points), sliceExtent(this.#session.state) * JOINED) : [];
    set(this.#blocked, { d: loops.map((points) => pathOf(points, true)).join("") });
  }

  #placePoint(): void {
    const c = this.#session.state.configuration;
    if (!isPlanar(c)) return;
    const { x, y } = this.viewport.toScreen(c);
    set(this.#point, { transform: `translate(${x} ${y})` });
  }

  #isNear(at: Place): boolean {
    const c = this.#session.state.configuration;
    return isPlanar(c) && Math.hypot(at.x - c.x, at.y - c.y) < GRAB * this.viewport.pixel.x;
  }

  #grab(at: Place): Drag | null {
    const c = this.#session.state.configuration;
    const kernel = this.#session.planar;
    if (!isPlanar(c)) return null;
    if (!this.#isNear(at)) return (kernel && this.#contacts?.grab(at, this.viewport, kernel, currentSlice(this.#session), ({ x, y }) => ({ x, y, theta: c.theta }))) ?? null;
    const [dx, dy] = [c.x - at.x, c.y - at.y];
    const goal = new DragGoal(c, () => this.#session.turnedBy);
    const { store } = this.#session;
    store.change({ dragging: true, playing: false });
    return {
      move: (to) => {
        goal.moveTo(to.x + dx, to.y + dy);
        this.#session.aim(goal.placement);
      },
      end: () => store.change({ dragging: false }),
    };
  }
}

function boxOfCurves(curves: readonly DrawnCurve[]): Box {
  const box = emptyBox();
  for (const { points } of curves) for (let i = 0; i + 1 < points.length; i += 2) grow(box, { x: points[i] ?? 0, y: points[i + 1] ?? 0 });
  return box;
}

/** How far a point is outside of a box; no number of an empty box. */
function awayFrom(box: Box, { x, y }: Place): number {
  if (box.x0 > box.x1) return NaN;
  return Math.max(box.x0 - x, x - box.x1, box.y0 - y, y - box.y1);
}

/** The configuration as a point with a ring to grab. */
export function pointMark(): SVGGElement {
  return svg("g", { class: "point" }, svg("circle", { class: "point-ring", r: 11 }), svg("circle", { class: "point-dot", r: 4.5 }));
}

/**
 * The parts, to scale, where they are in the assembly. Those of the selected pair can be dragged. Where one height is looked at alone,
 * layers at others are faint, and let the pointer through.
 */

import type { Touch } from "../kernel/api.js";
import type { Place, ScenePart } from "../scene.js";
import { set, svg } from "./dom.js";
import { DragGoal } from "./drag-goal.js";
import type { Editor } from "./edit.js";
import { gridStep } from "./grid.js";
import { isAt, partAt, touchesAt } from "./heights.js";
import { lowerPair } from "./lower.js";
import { Measure } from "./measure.js";
import { placed } from "./mechanism.js";
import { boxOf, centerOf, edgeOf, edgePath, emptyBox, featurePlace, grow, growBy, outlinePath } from "./outline.js";
import { PartNames } from "./part-names.js";
import { IDENTITY, TURN, apply, coordinateOf, inverse, ofMotion, rotate, shortestTurn, unit, type Placement } from "./placement.js";
import type { MechanismHand } from "./mechanism-hand.js";
import type { Session } from "./session.js";
import type { Key, State } from "./state.js";
import { Viewport, wheelAngle, wheelSlide, type Drag } from "./viewport.js";

/** Lengths in pixels. */
const NORMAL_ARROW = 34;
const PIVOT = 7;
/** With Shift a dragged part is turned: a half turn for 360 pixels. */
const RADIANS_PER_PIXEL = TURN / 720;
/** What is seen where there is no part (model unit). */
const EMPTY = [-60, -40, 60, 40];
/** A record is seen whole if about so many of its steps are. */
const FITTED_STEPS = 60;

interface Drawn {
  part: ScenePart;
  group: SVGGElement;
  /** The outline of each layer, the lowest first. */
  layers: SVGGElement;
  grip: SVGPathElement;
  touching: SVGGElement;
}

export class PartsView {
  readonly viewport: Viewport;
  readonly #session: Session;
  readonly #editor: Editor | null;
  readonly #hand: MechanismHand | null;
  readonly #parts = svg("g");
  readonly #pivots = svg("g", { class: "pivots" });
  readonly #names = new PartNames();
  readonly #measure: Measure;
  readonly #marks = svg("g", { class: "marks" });
  readonly #handles = svg("g", { class: "handles" });
  #drawn: Drawn[] = [];
  /** The parts as they are at the height that is looked at. */
  #seen: ScenePart[] = [];

  constructor(parent: HTMLElement, session: Session, editor: Editor | null, hand: MechanismHand | null) {
    this.#session = session;
    this.#editor = editor;
    this.#hand = hand;
    this.viewport = new Viewport(parent, {
      uniform: true,
      fit: () => this.fit(),
      label: "The parts. Drag a part to move it; the wheel over the moving part turns it.",
      grab: (at, event) => this.#grab(at, event),
      twist: () => this.#twist(),
      wheel: (at, event) => this.#wheel(at, event),
      double: (at) => editor?.addAt(at, this.viewport) ?? false,
    });
    this.#measure = new Measure(session, this.viewport);
    this.viewport.unit = session.scene.unit ?? "";
    this.viewport.world.append(this.#parts);
    this.viewport.overlay.append(this.#pivots, this.#names.group, this.#marks, this.#measure.group, this.#handles);
    this.#handles.addEventListener("keydown", (event) => {
      const [dx, dy] = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as Record<string, [number, number]>)[event.key] ?? [0, 0];
      if (dx === 0 && dy === 0) return;
      event.preventDefault();
      event.stopPropagation();
      const step = gridStep(this.viewport) * (event.shiftKey ? 0.1 : 1);
      editor?.nudge(dx * step, dy * step, step);
    });
    this.viewport.onView = () => this.#drawOverlay();
    editor?.onSelect.push(() => this.#drawOverlay());
    session.store.subscribe((changed, state) => this.#update(changed, state));
    this.fit();
  }

  /** Shows all parts, and those of the pair as far as they are near. */
  fit(): void {
    const box = emptyBox();
    const { parts } = this.#session.state;
    if (parts.length === 0) growBy(box, EMPTY);
    const boxes = parts.map((part) => boxOf(part.loops));
    for (const placements of this.#wayPlacements()) {
      boxes.forEach((of, i) => {
        const p = placements[i] ?? IDENTITY;
        for (const x of [of.x0, of.x1]) for (const y of [of.y0, of.y1]) grow(box, apply(p, { x, y }));
      });
    }
    this.viewport.fit(box, 0.12);
  }

  /** Where the parts are, and where a record takes them. */
  #wayPlacements(): (readonly Placement[])[] {
    const { state, pair, scene } = this.#session;
    const { record, placements } = state;
    const every = Math.ceil((record?.steps.length ?? 0) / FITTED_STEPS) || 1;
    if (record?.kind === "simulation") return [placements, ...record.steps.filter((_, i) => i % every === 0).map((s) => this.#session.placementsBy(s.parts))];
    if (record && pair) return [placements, ...record.steps.filter((_, i) => i % every === 0).map((s) => placed(scene, pair, placements, s.at))];
    return [placements];
  }

  #update(changed: ReadonlySet<Key>, state: Readonly<State>): void {
    if (changed.has("parts")) this.#build(state);
    if (changed.has("parts") || changed.has("height")) this.#atHeight(state);
    if (changed.has("pair") || changed.has("parts") || changed.has("held")) this.#classes();
    if (changed.has("placements") || changed.has("parts")) {
      this.#drawn.forEach((d, i) => set(d.group, { transform: matrix(state.placements[i] ?? IDENTITY) }));
    }
    if (changed.has("where") || changed.has("reason") || changed.has("pair") || changed.has("parts") || changed.has("height")) this.#touching();
    if (changed.has("record") && state.record) this.fit();
    if (["placements", "where", "parts", "pair", "editing", "measuring", "height"].some((k) => changed.has(k as Key))) this.#drawOverlay();
  }

  #build(state: Readonly<State>): void {
    // While a vertex is dragged the same elements are kept, or the pointer would lose them.
    state.parts.forEach((part, i) => {
      let drawn = this.#drawn[i];
      if (!drawn) {
        const layers = svg("g", {});
        const grip = svg("path", { class: "grip" });
        const touching = svg("g", { class: "touching" });
        const group = svg("g", { "data-part": i }, svg("title", {}, part.name), layers, grip, touching);
        this.#parts.append(group);
        drawn = { part, group, layers, grip, touching };
        this.#drawn[i] = drawn;
      }
      if (drawn.part === part && drawn.layers.hasChildNodes()) return;
      drawn.part = part;
      const { layers } = drawn;
      while (layers.children.length > part.layers.length) layers.lastChild?.remove();
      part.layers.forEach(({ z, loops }, k) => {
        const path = layers.children[k] ?? layers.appendChild(svg("path", {}, svg("title", {})));
        set(path, { d: outlinePath(loops.map((l) => part.loops[l] ?? [])) });
        if (path.firstChild) path.firstChild.textContent = z ? `${part.name}, z ${z[0]} to ${z[1]}` : part.name;
      });
    });
  }

  #atHeight(state: Readonly<State>): void {
    const { interval } = this.#session;
    this.#seen = state.parts.map((part) => partAt(part, interval));
    set(this.#parts, { class: interval ? "at-height" : null });
    this.#drawn.forEach(({ part, layers, grip }, i) => {
      set(grip, { d: outlinePath(this.#seen[i]?.loops ?? []) });
      part.layers.forEach(({ z }, k) => {
        const kind = !isAt(z, interval) ? " away" : part.layers.length > 1 && !interval ? " layer" : "";
        const path = layers.children[k];
        if (path) set(path, { class: `outline${kind}` });
      });
    });
  }

  /** What touches at the height that is looked at. */
  get #touches(): Touch[] {
    const { pair, state, interval } = this.#session;
    const touches = (part: number | undefined, feature: string) => {
      const of = part === undefined ? undefined : state.parts[part];
      const place = of && featurePlace(of, feature);
      return !place || touchesAt(of, place.loop, interval);
    };
    return state.where.touching.filter((touch) => touches(pair?.fixed, touch.fixed) && touches(pair?.moving, touch.moving));
  }

  #classes(): void {
    const pair = this.#session.pair;
    this.#drawn.forEach((d, i) => {
      const overlaps = this.#session.state.held?.overlapping.some((names) => names.includes(d.part.name));
      const role = !pair ? "other" : i === pair.fixed ? "fixed" : i === pair.moving ? "moving" : "other";
      set(d.group, { class: `part ${role}${overlaps ? " overlapping" : ""}` });
    });
    // Those of the pair are drawn over the others.
    for (const i of pair ? [pair.fixed, pair.moving] : []) {
      const group = this.#drawn[i]?.group;
      if (group) this.#parts.append(group);
    }
  }

  #touching(): void {
    const pair = this.#session.pair;
    this.#drawn.forEach((d) => d.touching.replaceChildren());
    if (!pair) return;
    const light = (index: number, name: string, kind: "touch" | "reason") => {
      const d = this.#drawn[index];
      const place = d ? featurePlace(d.part, name) : null;
      if (!d || !place) return;
      const loop = d.part.loops[place.loop] ?? [];
      const vertex = loop[place.index];
      if (place.kind === "vertex" && vertex) {
        // A line of no length with round ends is a dot of the stroke's width at any zoom.
        d.touching.append(svg("path", { class: `${kind}-vertex`, d: `M${vertex.x} ${vertex.y}h0` }));
      } else {
        const edge = edgeOf(loop, place.index);
        if (edge) d.touching.append(svg("path", { class: `${kind}-edge`, d: edgePath(edge) }));
      }
    };
    const { fixed, moving } = this.#session.state.reason;
    fixed.forEach((name) => light(pair.fixed, name, "reason"));
    moving.forEach((name) => light(pair.moving, name, "reason"));
    for (const touch of this.#touches) {
      light(pair.fixed, touch.fixed, "touch");
      light(pair.moving, touch.moving, "touch");
    }
  }

  #drawOverlay(): void {
    const { state, pair } = { state: this.#session.state, pair: this.#session.pair };
    this.#pivots.replaceChildren(...this.#pivotMarks());
    const centers = state.parts.flatMap(({ motion }) => (motion.type === "revolute" ? [this.viewport.toScreen(motion.center)] : []));
    this.#names.draw(this.viewport, this.#seen, state.placements, pair, centers);
    this.#measure.draw();
    const marks: SVGElement[] = [];
    if (pair) {
      const frame = this.#session.axes ? IDENTITY : (state.placements[pair.fixed] ?? IDENTITY);
      for (const touch of this.#touches) {
        const at = this.viewport.toScreen(apply(frame, { x: touch.at[0], y: touch.at[1] }));
        const n = rotate({ x: touch.normal[0], y: touch.normal[1] }, frame.theta);
        const tip = { x: at.x + NORMAL_ARROW * n.x, y: at.y - NORMAL_ARROW * n.y };
        const back = { x: tip.x - 9 * n.x, y: tip.y + 9 * n.y };
        const side = { x: 4 * n.y, y: 4 * n.x };
        marks.push(
          svg("path", { class: "normal", d: `M${at.x} ${at.y}L${back.x} ${back.y}` }),
          svg("path", { class: "normal-tip", d: `M${tip.x} ${tip.y}L${back.x + side.x} ${back.y + side.y}L${back.x - side.x} ${back.y - side.y}Z` }),
          svg("circle", { class: "contact", cx: at.x, cy: at.y, r: 4 }),
        );
      }
    }
    this.#marks.replaceChildren(...marks);
    // They are drawn anew: the one that has the focus keeps it.
    const focused = this.#handles.contains(document.activeElement);
    this.#handles.replaceChildren(...(this.#editor?.handles(this.viewport) ?? []));
    if (focused) this.#handles.querySelector<SVGElement>(".chosen")?.focus();
  }

  #pivotMarks(): SVGElement[] {
    const { state, scene } = this.#session;
    const marks: SVGElement[] = [];
    const pivot = (at: Place, kind: string, name: string) => {
      const { x, y } = this.viewport.toScreen(at);
      const d = `M${x - PIVOT} ${y}a${PIVOT} ${PIVOT} 0 1 0 ${2 * PIVOT} 0a${PIVOT} ${PIVOT} 0 1 0 ${-2 * PIVOT} 0M${x - PIVOT - 4} ${y}h${2 * PIVOT + 8}M${x} ${y - PIVOT - 4}v${2 * PIVOT + 8}`;
      marks.push(svg("path", { class: kind, d }, svg("title", {}, name)));
    };
    state.parts.forEach((part, i) => {
      if (part.motion.type === "revolute") pivot(part.motion.center, "pivot", `pivot of ${part.name}`);
      if (part.motion.type === "prismatic") {
        const at = this.viewport.toScreen(apply(state.placements[i] ?? IDENTITY, centerOf(boxOf(part.loops))));
        const d = unit(part.motion.direction);
        marks.push(svg("path", { class: "pivot", d: `M${at.x - 22 * d.x} ${at.y + 22 * d.y}L${at.x + 22 * d.x} ${at.y - 22 * d.y}` }, svg("title", {}, `slides: ${part.name}`)));
      }
    });
    for (const joint of scene.joints) {
      pivot(apply(state.placements[joint.parts[0]] ?? IDENTITY, joint.at), "pivot joint", `${joint.type} joint`);
    }
    return marks;
  }

  #grab(at: Place, event: PointerEvent): Drag | null {
    const measured = this.#measure.grab(at);
    if (measured) return measured;
    const edited = this.#editor?.grab(at, this.viewport, event.altKey);
    if (edited) return edited;
    const part = partOf(event.target);
    const pair = this.#session.pair;
    if (part !== null && this.#session.state.traced === "next") {
      this.#session.store.change({ traced: { part, at: apply(inverse(this.#session.state.placements[part] ?? IDENTITY), at) } });
      return { move: () => {} };
    }
    if (part !== null && this.#hand && this.#session.state.whole) {
      return this.#session.state.parts[part]?.motion.type === "fixed" ? null : this.#hand.grab(part, at);
    }
    if (part === null || !pair || (part !== pair.fixed && part !== pair.moving)) return null;
    const start = this.#session.state.placements[part] ?? IDENTITY;
    const motion = this.#session.state.parts[part]?.motion ?? { type: "planar" };
    if (motion.type === "fixed") return null;
    const store = this.#session.store;
    store.change({ dragging: true, playing: false });
    const end = () => store.change({ dragging: false });
    const hinge = part === pair.moving ? lowerHinge(this.#session) : null;
    if (motion.type === "revolute" || hinge) {
      const center = hinge ?? (motion.type === "revolute" ? motion.center : at);
      // Angles are followed from move to move, so that several turns can be made.
      let angle = Math.atan2(at.y - center.y, at.x - center.x);
      let turned = 0;
      const from = start.theta;
      return {
        move: (to) => {
          const now = Math.atan2(to.y - center.y, to.x - center.x);
          turned += shortestTurn(angle, now);
          angle = now;
          const placement = motion.type === "revolute" ? ofMotion(motion, from + turned) : { ...start, theta: from + turned };
          this.#session.dragPart(part, placement);
        },
        end,
      };
    }
    let last = at;
    const moving = part === pair.moving;
    // What turns is the moving part, also while the other is dragged.
    const goal = new DragGoal(start, () => (moving ? this.#session.turnedBy : 0));
    return {
      move: (to, moved) => {
        if (motion.type === "planar" && moved.shiftKey) {
          const by = ((to.y - last.y) / this.viewport.pixel.y) * RADIANS_PER_PIXEL;
          if (moving) goal.turn(by);
          else this.#session.turn(by);
        } else {
          goal.moveBy(to.x - last.x, to.y - last.y);
        }
        const wanted = goal.placement;
        if (moving || !moved.shiftKey) this.#session.dragPart(part, motion.type === "prismatic" ? ofMotion(motion, coordinateOf(motion, wanted)) : wanted);
        last = to;
      },
      end,
    };
  }

  /** Two fingers turn the moving part, on a part that can turn. */
  #twist(): ((by: number, about: Place) => void) | null {
    const { pair, state } = this.#session;
    const motion = pair && state.parts[pair.moving]?.motion.type;
    if (!pair || state.editing || state.measuring || state.whole || (motion !== "planar" && motion !== "revolute")) return null;
    return (by, about) => this.#session.turn(by, apply(inverse(this.#session.state.placements[pair.moving] ?? IDENTITY), about));
  }

  #wheel(at: Place, event: WheelEvent): boolean {
    const { state, pair } = this.#session;
    const part = partOf(event.target);
    if (!pair || !(state.dragging || event.shiftKey || part === pair.moving)) return false;
    const moving = state.parts[pair.moving];
    if (!moving) return false;
    const placement = state.placements[pair.moving] ?? IDENTITY;
    const motion = moving.motion;
    if (motion.type === "prismatic") this.#session.nudge(0, wheelSlide(event) * this.viewport.pixel.x);
    else if (motion.type === "revolute") this.#session.turn(wheelAngle(event));
    else if (state.dragging) this.#session.turn(wheelAngle(event));
    else this.#session.turn(wheelAngle(event), apply(inverse(placement), event.shiftKey ? apply(placement, centerOf(boxOf(moving.loops))) : at));
    return true;
  }
}

function lowerHinge({ pair, state }: Session): Place | null {
  const pivot = pair && lowerPair(pair)?.pivot;
  return pair && pivot ? apply(state.placements[pair.fixed] ?? IDENTITY, pivot) : null;
}

/** A placement as a transform of SVG. */
export function matrix(p: Placement): string {
  const [c, s] = [Math.cos(p.theta), Math.sin(p.theta)];
  return `matrix(${c} ${s} ${-s} ${c} ${p.x} ${p.y})`;
}

function partOf(target: EventTarget | null): number | null {
  const group = target instanceof Element ? target.closest("[data-part]") : null;
  return group ? Number(group.getAttribute("data-part")) : null;
}

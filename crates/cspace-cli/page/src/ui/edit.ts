/** Editing: vertices, arcs, pivots and clearances of parts are dragged, parameters are set, and the pair's space is computed again meanwhile. */

import type { Kernel } from "../kernel/api.js";
import type { Place, ScenePair, SceneSetting } from "../scene.js";
import { Handles, isSame, type Edited, type Handle, type VertexHandle } from "./edit-handles.js";
import { addVertex, bend, moveVertex, removeVertex, setRadius, type Loop } from "./edit-shape.js";
import { gridStep, snapped } from "./grid.js";
import { loopsAt } from "./heights.js";
import { isAxes } from "./mechanism.js";
import { arcOf, edgeOf } from "./outline.js";
import { IDENTITY, apply, inverse } from "./placement.js";
import { regionChanges } from "./region-changes.js";
import type { Fetcher, Session } from "./session.js";
import type { Drag, Viewport } from "./viewport.js";
import { UNCHANGED, WorkError, type EditAnswer, type Edits, type ModelText, type PartEdit, type Workshop } from "./workshop.js";

export interface EditReport {
  /** Of the last answer: the space alone, and until it was here (s). */
  seconds: number;
  roundTrip: number;
  /** Regions that opened or closed. */
  changes: string;
  error: string | null;
}

/** All that can be undone: parts as they are edited, and values of parameters. */
interface Shape {
  parts: readonly Edited[];
  set: readonly SceneSetting[];
}

/** A computation that takes longer is ended once the shape has changed again (ms). */
const PATIENCE = 1000;

export class Editor {
  /** Those who are told of each answer. */
  readonly listeners: ((report: EditReport) => void)[] = [];
  readonly onSelect: (() => void)[] = [];
  selected: Handle | null = null;
  /** Gets pairs of the model as it was opened. */
  readonly #opener: Fetcher;
  #shape: Shape;
  #undo: Shape[] = [];
  #redo: Shape[] = [];
  /** The changes that are saved, as JSON. */
  #saved = "";
  /** Counts changes by the user. */
  #version = 0;
  readonly #fetching = new Map<number, Promise<ScenePair>>();
  /** When the computation that is at work began (ms). */
  #begun: number | null = null;
  #waiting = false;

  constructor(private readonly session: Session, private readonly workshop: Workshop, opener: Fetcher) {
    this.#opener = opener;
    this.#shape = { parts: session.scene.parts.map(({ loops, motion }) => ({ loops, motion, offset: 0, byHand: false })), set: [] };
    session.fetcher = (pair) => {
      // A pair that is selected again waits for the answer that is on its way.
      const coming = this.#fetching.get(pair) ?? this.#fetch(pair).finally(() => this.#fetching.delete(pair));
      this.#fetching.set(pair, coming);
      return coming;
    };
  }

  /** It is another after each change, whoever made it. */
  get version(): number {
    return this.#version;
  }

  get canUndo(): boolean {
    return this.#undo.length > 0;
  }

  get canRedo(): boolean {
    return this.#redo.length > 0;
  }

  offsetOf(part: number): number {
    return this.#shape.parts[part]?.offset ?? 0;
  }

  /** Values of parameters that were set here. */
  get set(): readonly SceneSetting[] {
    return this.#shape.set;
  }

  /** All that differs from the opened model. */
  get edits(): Edits {
    const { parts, set } = this.#shape;
    const edited = parts.flatMap(({ loops, motion, offset, byHand }, index): PartEdit[] => (byHand ? [{ index, loops, motion, offset }] : []));
    return { set, parts: edited };
  }

  /** Whether all changes are in a file or an address. */
  get isSaved(): boolean {
    return [this.#saved, JSON.stringify(UNCHANGED)].includes(JSON.stringify(this.edits));
  }

  markSaved(): void {
    this.#saved = JSON.stringify(this.edits);
  }

  /** Takes all changes from elsewhere, as one that can be undone; fails, and changes nothing, where they are none of this model. */
  async restore(edits: Edits): Promise<void> {
    const index = this.session.state.pair;
    const answer = await this.workshop.edit(index, edits);
    this.#remember();
    const parts = this.#shape.parts.map((e, i) => {
      const edited = edits.parts.find((p) => p.index === i);
      return { ...e, offset: 0, ...edited, byHand: edited !== undefined };
    });
    this.#shape = { set: edits.set, parts };
    this.#version += 1;
    this.#take(answer, index);
    this.#select(this.selected);
  }

  async #fetch(pair: number): Promise<ScenePair> {
    for (;;) {
      const version = this.#version;
      const edits = this.edits;
      const answer = edits.parts.length === 0 && edits.set.length === 0 ? await this.#opener(pair) : (await this.workshop.edit(pair, edits)).pair;
      // Parts that were edited meanwhile have another space.
      if (version === this.#version) return answer;
    }
  }

  model(): Promise<ModelText> {
    return this.workshop.model(this.edits);
  }

  undo(): void {
    this.#swap(this.#undo, this.#redo);
  }

  redo(): void {
    this.#swap(this.#redo, this.#undo);
  }

  #swap(from: Shape[], to: Shape[]): void {
    const taken = from.pop();
    if (!taken) return;
    to.push(this.#shape);
    this.#shape = taken;
    this.#changed();
  }

  /** Before the first change of a drag. */
  #remember(): void {
    this.#undo.push(this.#shape);
    this.#redo = [];
  }

  #change(part: number, by: (e: Edited) => Edited): void {
    this.#shape = { ...this.#shape, parts: this.#shape.parts.map((e, i) => (i === part ? { ...by(e), byHand: true } : e)) };
    this.#changed();
  }

  /** Gives parameters values; all of a drag is one change, of which the first is remembered. */
  setParameters(values: readonly SceneSetting[], isFirst: boolean): void {
    if (isFirst) this.#remember();
    const others = this.#shape.set.filter((s) => !values.some((v) => v.name === s.name));
    this.#shape = { ...this.#shape, set: [...others, ...values] };
    this.#changed();
  }

  #changed(): void {
    this.#version += 1;
    const parts = this.session.state.parts.map((part, i) => {
      const e = this.#shape.parts[i];
      // A part that is offset, or follows parameters, is shown as it is answered.
      return !e || e.offset !== 0 || !e.byHand ? part : { ...part, loops: e.loops, motion: e.motion };
    });
    this.session.store.change({ parts });
    this.#send();
    this.#select(this.selected);
  }

  #send(): void {
    if (this.#begun !== null) {
      this.#waiting = true;
      // What takes long is of a shape that is no longer drawn.
      if (performance.now() - this.#begun > PATIENCE) this.workshop.cancel();
      return;
    }
    void this.#request();
  }

  async #request(): Promise<void> {
    const begin = performance.now();
    this.#begun = begin;
    this.#waiting = false;
    const index = this.session.state.pair;
    const asked = await this.workshop.edit(index, this.edits).then((answer) => ({ answer }), (error: unknown) => ({ error }));
    const roundTrip = (performance.now() - begin) / 1000;
    // The worker goes on while the answer is shown.
    this.#begun = null;
    if (this.#waiting) void this.#request();
    try {
      if ("error" in asked) throw asked.error;
      const before = { pair: this.session.pair, kernel: this.session.kernel };
      this.#take(asked.answer, index);
      this.#report({ seconds: asked.answer.pair.seconds, roundTrip, changes: index === this.session.state.pair ? this.#changesSince(before) : "", error: null });
    } catch (error) {
      if (error instanceof WorkError && error.cancelled) return;
      this.session.store.change({ outdated: true });
      this.#report({ seconds: NaN, roundTrip, changes: "", error: error instanceof Error ? error.message : String(error) });
    }
  }

  #take(answer: EditAnswer, index: number): void {
    const parts = answer.parts.map((part, i) => {
      const now = this.#shape.parts[i];
      // The shape under the hand has gone on.
      return now?.byHand && now.offset === 0 ? { ...part, loops: now.loops, motion: now.motion } : part;
    });
    // Edits by hand begin with the outline that parameters gave the part.
    this.#shape = {
      ...this.#shape,
      parts: this.#shape.parts.map((e, i) => {
        const part = answer.parts[i];
        return e.byHand || !part ? e : { ...e, loops: part.loops, motion: part.motion };
      }),
    };
    this.session.replaceParts(parts, answer.design, index, answer.pair);
    // A part on a pivot that was moved is elsewhere by the same angle.
    const { configuration } = this.session.state;
    if (isAxes(configuration)) this.session.setConfiguration(configuration);
    this.session.store.change({ outdated: false });
  }

  #changesSince(before: { pair: ScenePair | undefined; kernel: Kernel | null }): string {
    const { pair, kernel } = this.session;
    if (!before.pair || !before.kernel || !pair || !kernel) return "";
    return regionChanges({ ...before.pair, kernel: before.kernel }, { ...pair, kernel });
  }

  #report(report: EditReport): void {
    for (const listener of this.listeners) listener(report);
  }

  // Handles.

  get #handles(): Handles {
    const { pair, state } = this.session;
    const loops = state.parts.map((part) => new Set(loopsAt(part, this.session.interval)));
    return new Handles(this.#shape.parts, state.placements, pair && state.editing ? [pair.fixed, pair.moving] : [], loops);
  }

  handles(viewport: Viewport): SVGElement[] {
    const focused = (handle: Handle) => isSame(handle, this.selected) || this.#select(handle);
    return this.#handles.drawn(viewport, this.selected, this.session.state.parts.map((p) => p.name), focused);
  }

  /** Moves what is selected, in the assembly; all on a grid of a step. */
  nudge(dx: number, dy: number, step: number): void {
    const handle = this.selected;
    const at = handle && this.#handles.placeOf(handle);
    const before = handle && this.#shape.parts[handle.part];
    if (!handle || !at || !before) return;
    this.#remember();
    this.#moveTo(handle, before, { x: at.x + dx, y: at.y + dy }, step);
  }

  #select(handle: Handle | null): void {
    this.selected = handle;
    for (const told of this.onSelect) told();
  }

  /** With Alt a vertex is removed. */
  grab(at: Place, viewport: Viewport, alt: boolean): Drag | null {
    const handle = this.#handles.nearest(at, viewport);
    this.#select(handle);
    if (!handle) return null;
    if (alt && this.removeSelected()) return { move: () => {} };
    const { store } = this.session;
    // All of a drag is from the shape at its beginning: radii that gave way come back.
    const before = this.#shape.parts[handle.part];
    let begun = false;
    return {
      move: (to, { altKey }) => {
        if (!begun) this.#remember();
        begun = true;
        store.change({ dragging: true });
        if (before) this.#moveTo(handle, before, to, altKey ? null : gridStep(viewport));
      },
      end: () => store.change({ dragging: false }),
    };
  }

  /** Vertices go to whole steps of their part's coordinates, pivots of the assembly's; a bent edge goes where it is wanted. */
  #moveTo(handle: Handle, e: Edited, to: Place, step: number | null): void {
    const free = apply(inverse(this.session.state.placements[handle.part] ?? IDENTITY), to);
    const own = step !== null && handle.kind === "vertex" ? snapped(free, step) : free;
    if (step !== null && handle.kind === "pivot") to = snapped(to, step);
    this.#change(handle.part, () => {
      if (handle.kind === "pivot") return e.motion.type === "revolute" ? { ...e, motion: { ...e.motion, center: to } } : e;
      return withLoop(e, handle.loop, (loop) => (handle.kind === "vertex" ? moveVertex : bend)(loop, handle.index, own)) ?? e;
    });
  }

  /** Adds a vertex to the edge at a place; whether there is one. */
  addAt(at: Place, viewport: Viewport): boolean {
    const edge = this.#handles.edgeAt(at, viewport);
    return edge !== null && this.#reshape(edge.of, (loop, index) => addVertex(loop, index, edge.own), 1);
  }

  /** Removes the vertex that is selected; whether one was. */
  removeSelected(): boolean {
    const handle = this.selected;
    return handle?.kind === "vertex" && this.session.state.editing && this.#reshape(handle, removeVertex, null);
  }

  /** Changes a loop, and selects the vertex that comes so many after the handle. */
  #reshape(handle: VertexHandle, by: (loop: Loop, index: number) => Loop | null, select: number | null): boolean {
    const e = this.#shape.parts[handle.part];
    const next = e && withLoop(e, handle.loop, (loop) => by(loop, handle.index));
    if (!next) return false;
    this.selected = select === null ? null : { ...handle, index: handle.index + select };
    this.#remember();
    this.#change(handle.part, () => next);
    return true;
  }

  // What is typed.

  /** The values of what is selected that can be typed; a straight edge has no radius yet. */
  fields(): { name: string; value: number | null; change(value: number): void }[] {
    const handle = this.selected;
    const e = handle ? this.#shape.parts[handle.part] : undefined;
    if (!handle || !e) return [];
    const typed = (by: (e: Edited, value: number) => Edited | null) => (value: number) => {
      const next = by(e, value);
      if (!next) {
        this.#report({ seconds: NaN, roundTrip: NaN, changes: "", error: "no arc of this radius reaches from one end of the edge to the other" });
        return;
      }
      this.#remember();
      this.#change(handle.part, () => next);
    };
    if (handle.kind === "pivot") {
      if (e.motion.type !== "revolute") return [];
      const motion = e.motion;
      return (["x", "y"] as const).map((k) => ({
        name: `pivot ${k}`,
        value: motion.center[k],
        change: typed((was, value) => ({ ...was, motion: { ...motion, center: { ...motion.center, [k]: value } } })),
      }));
    }
    const edge = edgeOf(e.loops[handle.loop] ?? [], handle.index);
    if (!edge) return [];
    if (handle.kind === "vertex") {
      return (["x", "y"] as const).map((k) => ({ name: k, value: edge.from[k], change: typed((was, value) => withLoop(was, handle.loop, (loop) => moveVertex(loop, handle.index, { ...edge.from, [k]: value }))) }));
    }
    return [
      {
        name: "radius",
        value: arcOf(edge)?.radius ?? null,
        change: typed((was, value) => withLoop(was, handle.loop, (loop) => setRadius(loop, handle.index, value))),
      },
    ];
  }

  /** Grows or shrinks the outline of a part. */
  setOffset(part: number, offset: number): void {
    this.#remember();
    this.#change(part, (e) => ({ ...e, offset }));
  }
}

/** A part with one of its loops changed; null if that cannot be. */
function withLoop(e: Edited, index: number, by: (loop: Loop) => Loop | null): Edited | null {
  const loop = e.loops[index];
  const changed = loop && by(loop);
  return changed ? { ...e, loops: e.loops.map((was, l) => (l === index ? [...changed] : was)) } : null;
}

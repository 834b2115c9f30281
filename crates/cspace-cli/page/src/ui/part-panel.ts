/** In the side panel: the model's parts by their names, and the next part, which is drawn where it goes before it is added. Each change is a step that Undo takes back. */

import { Model } from "../../build/kernel/cspace.js";
import type { Place, Scene, SceneMotion, SceneVertex } from "../scene.js";
import { button, byId, fileName, html, say, set, svg } from "./dom.js";
import { typedNumber } from "./edit-panel.js";
import type { Editor } from "./edit.js";
import { showScene } from "./entries.js";
import { sceneOf, showModel } from "./files.js";
import { gridStep, snapped } from "./grid.js";
import { failure } from "./message.js";
import { lengthStep } from "./numbers.js";
import { boxOf, centerOf, outlinePath, type Box } from "./outline.js";
import { unhurried } from "./unhurried.js";
import { SHAPES, withName, withPart, withoutPart, wrongPart, wrongPartName, type NewPart, type Shape } from "./part-text.js";
import type { Session } from "./session.js";
import type { Viewport } from "./viewport.js";

/** Dimensions of a new part, in steps of which a model has some ten. */
const SIZES: Record<Shape, readonly number[]> = { rectangle: [3, 2], circle: [1], slot: [4, 1], polygon: [6, 1] };
const STEPS = 10;
/** Of a model without parts such a step is so long (its unit). */
const USUAL_STEP = 10;

/** Beside the parts so much of their extent is seen, into which the next one is dragged. */
const ROOM = 0.3;

/** Of a model whose text is not here, or cannot take what was edited by hand; told so much after the last edit (ms). */
const TOLD = 300;
const LOST = "A change here writes the model anew, with numbers alone: without its parameters, requirements and comments.";

/** What a motion is called, and what the two numbers are that it takes. */
const MOTIONS: Record<SceneMotion["type"], [string, string | null]> = {
  fixed: ["is fixed", null],
  planar: ["is free", null],
  revolute: ["turns about a pin", "pin"],
  prismatic: ["slides", "along"],
};

/** Whether a model has no parts yet. */
export const isBlank = ({ parts }: Pick<Scene, "parts">): boolean => parts.length === 0;

/** Asks for a name and a unit of a model without parts, or which one to begin with. */
export function newModel(failed: (error: unknown) => void): void {
  const name = html("input", { type: "text", value: "new model", maxlength: 200, spellcheck: "false" });
  const unit = html("input", { type: "text", value: "mm", maxlength: 20, spellcheck: "false" });
  const chosen = (text: string, shown: () => Promise<void>) =>
    button(text, () => {
      dialog.close();
      shown().catch(failed);
    });
  const blank = chosen("Blank", () => showScene(sceneOf(Model.blank(name.value.trim() || "new model", unit.value.trim() || null))));
  const templates = JSON.parse(Model.templates()) as [string, string, string][];
  const others = templates.map(([file, title, text]) => chosen(title, () => showModel(text, file)));
  const buttons = html("div", { class: "buttons" }, blank, button("Cancel", () => dialog.close()));
  const dialog = html("dialog", { class: "new", "aria-label": "New model" }, html("label", {}, "Name", name), html("label", {}, "Unit", unit), buttons, html("h2", {}, "Or begin with"), ...others);
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  name.select();
}

export class PartPanel {
  readonly #outline = svg("path", { class: "drafted" });
  /** A point of no length, as wide as its stroke. */
  readonly #pin = svg("path", { class: "pin" });
  readonly #drawn = svg("g", { class: "part new" }, this.#outline, this.#pin);
  readonly #wrong = html("p", { class: "bad", role: "alert" });
  readonly #lost = html("p", { class: "faint" });
  readonly #fields = html("div");
  readonly #add = button("Add part", () => this.#change((text) => withPart(text, this.#part)));
  #part: NewPart;
  /** Its outline; none while it is wrong. */
  #loops: SceneVertex[][] = [];

  constructor(private readonly session: Session, private readonly editor: Editor | null, private readonly viewport: Viewport, private readonly failed: (error: unknown) => void) {
    const names = this.#names;
    let n = names.length + 1;
    while (names.includes(`part ${n}`)) n += 1;
    const at = { x: 0, y: 0 };
    this.#part = { name: `part ${n}`, shape: "rectangle", sizes: [], at, motion: { type: names.length === 0 ? "fixed" : "planar" } };
    this.#setShape("rectangle");
    const shape = this.#choice("shape", Object.keys(SHAPES).map((of) => [of, of]), this.#part.shape, (of) => this.#setShape(of as Shape));
    const motion = this.#choice("motion", Object.entries(MOTIONS).map(([of, [text]]) => [of, text]), this.#part.motion.type, (of) => this.#setMotion(of as SceneMotion["type"]));
    const name = this.#text("name", this.#part.name, (text) => this.#set({ name: text }));
    const hint = html("p", { class: "faint" }, "Drag its outline to where it goes; with Alt it does not snap to the grid. Its dimensions become parameters of the model.");
    byId("making").append(html("h2", {}, "Parts"), this.#lost, ...names.map((of) => this.#row(of)), html("h2", {}, "Next part"));
    byId("making").append(shape, name, this.#fields, motion, hint, this.#wrong, html("div", { class: "buttons" }, this.#add));
    viewport.world.append(this.#drawn);
    this.#follow(this.#outline, () => this.#part.at, (to) => this.#moveTo(to));
    this.#follow(this.#pin, () => this.#place ?? at, (to) => this.#setPlace(to));
    const tellLost = unhurried(() => editor?.model().then(({ isWhole }) => say(this.#lost, isWhole ? "" : LOST), () => {}), TOLD);
    session.store.subscribe((changed, { making }) => {
      if (making && (changed.has("parts") || changed.has("making"))) tellLost();
      if (!changed.has("making")) return;
      byId("making").hidden = !making;
      set(this.#drawn, { visibility: making ? null : "hidden" });
      if (making) viewport.fit(this.#box(true), ROOM);
    });
  }

  get #names(): string[] {
    return this.session.scene.parts.map((p) => p.name);
  }

  /** The pin, or the direction. */
  get #place(): Place | null {
    const { motion } = this.#part;
    return motion.type === "revolute" ? motion.center : motion.type === "prismatic" ? motion.direction : null;
  }

  /** Of all parts, with the next one or without. */
  #box(withNext: boolean): Box {
    return boxOf([...this.session.state.parts.flatMap((p) => p.loops), ...(withNext ? this.#loops : [])]);
  }

  /** How long a step of dimensions is. */
  get #step(): number {
    const { x0, y0, x1, y1 } = this.#box(false);
    return x1 > x0 ? lengthStep(Math.max(x1 - x0, y1 - y0) / STEPS) : USUAL_STEP;
  }

  /** Moves the part, with its pin. */
  #moveTo(at: Place): void {
    const { at: was, motion } = this.#part;
    this.#set({ at });
    if (motion.type === "revolute") this.#setPlace({ x: motion.center.x + at.x - was.x, y: motion.center.y + at.y - was.y });
  }

  /** Puts the part beside the others. */
  #put(): void {
    const box = this.#box(false);
    if (!(box.x1 > box.x0)) return;
    const step = this.#step;
    const { x0, x1 } = boxOf(this.#loops);
    this.#moveTo(snapped({ x: box.x1 + step + (x1 - x0) / 2, y: centerOf(box).y }, step / 2));
  }

  #setShape(shape: Shape): void {
    const step = this.#step;
    // How many sides there are is no length.
    const sizes = Object.keys(SHAPES[shape].sizes).map((what, i) => (SIZES[shape][i] ?? 1) * (what === "sides" ? 1 : step));
    this.#set({ shape, sizes });
    this.#put();
    this.#drawFields();
  }

  #setMotion(type: SceneMotion["type"]): void {
    const { at } = this.#part;
    const [revolute, prismatic] = [{ type: "revolute", center: at, range: null }, { type: "prismatic", direction: { x: 1, y: 0 }, range: null }] as const;
    this.#set({ motion: type === "revolute" ? revolute : type === "prismatic" ? prismatic : { type } });
    this.#drawFields();
  }

  #setPlace(to: Place): void {
    const { motion } = this.#part;
    if (motion.type === "revolute") this.#set({ motion: { ...motion, center: to } });
    if (motion.type === "prismatic") this.#set({ motion: { ...motion, direction: to } });
  }

  #set(part: Partial<NewPart>): void {
    this.#part = { ...this.#part, ...part };
    const wrong = this.#read() ?? wrongPart(this.#part, this.#names);
    say(this.#wrong, wrong ?? "");
    this.#add.disabled = wrong !== null;
    set(this.#outline, { d: outlinePath(this.#loops) });
    const { motion } = this.#part;
    set(this.#pin, { d: motion.type === "revolute" ? `M${motion.center.x} ${motion.center.y}h0` : "" });
  }

  /** Has the kernel read the outline; what is wrong with it, and null if nothing is. */
  #read(): string | null {
    this.#loops = [];
    const wrong = wrongPart({ ...this.#part, name: "-" }, []);
    if (wrong !== null) return wrong;
    try {
      this.#loops = sceneOf(Model.read(withPart("", this.#part), "the next part")).parts[0]?.loops ?? [];
      return null;
    } catch (error) {
      return failure(error)?.text ?? null;
    }
  }

  #drawFields(): void {
    const { shape, sizes, at, motion } = this.#part;
    const unit = this.session.scene.unit ? ` (${this.session.scene.unit})` : "";
    const number = (name: string, value: number, change: (value: number) => void) => this.#text(name, String(value), (text) => change(typedNumber(text) ?? NaN), "number");
    const both = (name: string, p: Place, change: (to: Partial<Place>) => void) => (["x", "y"] as const).map((k) => number(`${name} ${k}`, p[k], (to) => change({ [k]: to })));
    const dimensions = Object.keys(SHAPES[shape].sizes).map((what, i) =>
      number(what === "sides" ? what : `${what}${unit}`, sizes[i] ?? NaN, (to) => this.#set({ sizes: this.#part.sizes.map((s, k) => (k === i ? to : s)) })),
    );
    const [, of] = MOTIONS[motion.type];
    const place = this.#place;
    const more = of !== null && place ? both(of, place, (to) => this.#setPlace({ ...(this.#place ?? place), ...to })) : [];
    this.#fields.replaceChildren(...dimensions, ...both("at", at, (to) => this.#set({ at: { ...this.#part.at, ...to } })), ...more);
  }

  /** Follows the pointer that drags an element. */
  #follow(element: SVGElement, from: () => Place, to: (place: Place) => void): void {
    element.addEventListener("pointerdown", (down) => {
      down.stopPropagation();
      element.setPointerCapture(down.pointerId);
      const [begin, at] = [this.viewport.toWorld(down), from()];
      const move = (event: PointerEvent) => {
        const now = this.viewport.toWorld(event);
        const place = { x: at.x + now.x - begin.x, y: at.y + now.y - begin.y };
        to(event.altKey ? place : snapped(place, gridStep(this.viewport)));
        this.#drawFields();
      };
      element.addEventListener("pointermove", move);
      element.addEventListener("lostpointercapture", () => element.removeEventListener("pointermove", move), { once: true });
    });
  }

  #text(name: string, value: string, change: (text: string) => void, type = "text"): HTMLElement {
    const input = html("input", { type, value, step: "any", spellcheck: "false" });
    input.addEventListener("input", () => change(input.value));
    return html("label", {}, name, input);
  }

  #choice(name: string, options: readonly (readonly [string, string])[], chosen: string, change: (value: string) => void): HTMLElement {
    const select = html("select", {}, ...options.map(([value, text]) => html("option", { value }, text)));
    select.value = chosen;
    select.addEventListener("change", () => change(select.value));
    return html("label", {}, name, select);
  }

  #row(name: string): HTMLElement {
    const input = html("input", { type: "text", value: name, maxlength: 200, spellcheck: "false", "aria-label": `Name of ${name}` });
    input.addEventListener("change", () => {
      if (input.value.trim() === name) return;
      const wrong = wrongPartName(input.value, this.#names);
      if (wrong !== null) this.failed(wrong);
      else this.#change((text) => withName(text, name, input.value));
    });
    const remove = button("✕", () => this.#change((text) => withoutPart(text, name)), { class: "small", title: `Remove ${name}` });
    return html("label", {}, input, remove);
  }

  /** Shows the model with a change of its text. */
  #change(by: (text: string) => string): void {
    const { name, unit, source, parts } = this.session.scene;
    const file = source?.design?.file.replace(/\.json$/i, ".toml") ?? fileName(name, "toml");
    const changed = async () => {
      const text = this.editor ? (await this.editor.model()).text : `name = ${JSON.stringify(name)}\n${unit ? `unit = ${JSON.stringify(unit)}\n` : ""}`;
      const to = by(text);
      // A file has one part at least.
      if (parts.length === 1 && !to.includes("[[part]]")) await showScene(sceneOf(Model.blank(name, unit)), true);
      else await showModel(to, file, true);
    };
    changed().catch(this.failed);
  }
}

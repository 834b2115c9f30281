/** In the side panel while parts are edited: the selected handle's numbers, clearance, and the budget. */

import type { Actions } from "./actions.js";
import { button, byId, html, say, set } from "./dom.js";
import type { EditReport, Editor } from "./edit.js";
import { LARGEST_NUMBER, isUsable } from "./numbers.js";
import type { Session } from "./session.js";

/** A space that is there within this time keeps up with the hand: 30 in a second (ms). */
const BUDGET = 33;

export class EditPanel {
  readonly #fields = html("div");
  readonly #offset = html("input", { type: "number", step: "any", id: "edit-offset" });
  readonly #meter = html("meter", { min: 0, max: 2 * BUDGET, high: BUDGET, optimum: 0, value: 0, "aria-label": "Time of the last computation" });
  readonly #time = html("p", {}, "nothing computed yet");
  readonly #said = html("p", { class: "said" });
  readonly #refused = html("p", { class: "bad", role: "alert", hidden: "" });
  readonly #remove: HTMLButtonElement;

  constructor(private readonly session: Session, private readonly editor: Editor, actions: Actions) {
    this.#remove = button("Remove vertex", actions.removeVertex, { title: "Remove the selected vertex (Delete, or Alt-click on it)" });
    this.#offset.addEventListener("change", () => {
      const value = typedNumber(this.#offset.value);
      const moving = session.pair?.moving;
      if (moving === undefined) return;
      // What is wrong stays, with what is said of it, until it is mended: leaving the field is no change.
      set(this.#offset, { "aria-invalid": value === null ? "true" : null });
      this.#refused.hidden = value !== null;
      if (value === null) say(this.#refused, refusal("clearance"));
      // More clearance is less material.
      else if (value !== (-editor.offsetOf(moving) || 0)) editor.setOffset(moving, -value);
    });
    const unit = session.scene.unit ? ` (${session.scene.unit})` : "";
    const clearance = html("label", { for: "edit-offset", title: "The moving part is shrunk by this all round" }, `clearance${unit}`, this.#offset);
    byId("edit").append(
      html("p", {}, "Drag squares (vertices), dots (edges) and rings (pivots). Double-click an edge to add a vertex, Alt-click one to remove it. Vertices snap to a grid, finer when zoomed in; with Alt they do not. Tab and arrow keys do the same."),
      this.#fields,
      clearance,
      this.#refused,
      this.#said,
      html("div", { class: "buttons" }, this.#remove),
      html("details", {}, html("summary", {}, "Details"), this.#meter, this.#time),
    );
    editor.listeners.push((report) => this.#report(report));
    editor.onSelect.push(() => this.#draw());
    session.store.subscribe((changed, state) => {
      if (changed.has("editing")) byId("edit").hidden = !state.editing;
      if (changed.has("pair")) {
        set(this.#offset, { "aria-invalid": null });
        this.#refused.hidden = true;
      }
      if (changed.has("pair") || changed.has("editing")) this.#draw();
    });
  }

  #report({ seconds, roundTrip, changes, error }: EditReport): void {
    set(this.#said, { class: error ? "said bad" : "said" });
    if (error) say(this.#said, error);
    else {
      const [space, all] = [seconds, roundTrip].map((s) => (s * 1000).toFixed(0));
      this.#meter.value = roundTrip * 1000;
      say(this.#time, `${all} ms of ${BUDGET} ms for a picture, ${space} ms for the space`);
      say(this.#said, changes);
      if (changes) say(byId("announce"), changes);
    }
    this.#draw();
  }

  #refuse(name: string): void {
    set(this.#said, { class: "said bad" });
    say(this.#said, refusal(name));
  }

  #draw(): void {
    this.#remove.disabled = this.editor.selected?.kind !== "vertex";
    const moving = this.session.pair?.moving ?? -1;
    if (document.activeElement !== this.#offset && this.#refused.hidden) this.#offset.value = String(-this.editor.offsetOf(moving) || 0);
    // A number that is being typed stays.
    if (this.#fields.contains(document.activeElement)) return;
    this.#fields.replaceChildren(
      ...this.editor.fields().map(({ name, value, change }) => {
        const input = html("input", { type: "number", step: "any", placeholder: value === null ? "straight" : "" });
        input.value = value === null ? "" : String(value);
        input.addEventListener("change", () => {
          const typed = typedNumber(input.value);
          input.blur();
          if (typed === null) {
            this.#refuse(name);
            this.#draw();
          } else if (typed !== value) change(typed);
        });
        return html("label", {}, name, input);
      }),
    );
  }
}

function refusal(name: string): string {
  return `${name}: type a number of at most ${LARGEST_NUMBER}; nothing is changed`;
}

/** What is typed into a field for numbers, which is empty where it is none. */
export function typedNumber(text: string): number | null {
  const value = text.trim() === "" ? NaN : Number(text);
  return isUsable(value) ? value : null;
}

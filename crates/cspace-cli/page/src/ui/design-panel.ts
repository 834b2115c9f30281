/** The parameters of the model as sliders, and its requirements as they are met, each with a strip over a parameter. */

import type { SceneParameter, SceneSetting } from "../scene.js";
import { byId, html, say, set } from "./dom.js";
import type { Editor } from "./edit.js";
import { LARGEST_NUMBER, degrees, isUsable, rounded, short } from "./numbers.js";
import { Requirements } from "./requirements.js";
import type { Session } from "./session.js";
import type { Workshop } from "./workshop.js";

/** A slider has so many steps. */
const STEPS = 400;
const DEGREE = Math.PI / 180;

interface Row {
  parameter: SceneParameter;
  slider: HTMLInputElement;
  field: HTMLInputElement;
  /** Whether it may change when a contact is dragged. */
  free: HTMLInputElement;
}

export class DesignPanel {
  readonly #session: Session;
  readonly #editor: Editor;
  readonly #rows: Row[];
  readonly #following = html("p", { class: "faint" });
  /** What became of the last value: regions that opened or closed, or why there is no such model. */
  readonly #said = html("p", { class: "said", "aria-live": "polite" });
  readonly #requirements: Requirements | null;
  /** The slider that is in a hand. */
  #held: HTMLInputElement | null = null;

  /** `checks` computes requirements, apart from what the hand waits for. */
  constructor(session: Session, editor: Editor, checks: () => Workshop) {
    this.#session = session;
    this.#editor = editor;
    const design = session.scene.design;
    const parameters = design?.parameters ?? [];
    this.#rows = parameters.filter((p) => p.expression === null).map((p) => this.#row(p));
    const element = byId("design");
    element.hidden = !design;
    const head = html("h2", {}, "Parameters");
    if (parameters.length > 0) element.append(head, ...this.#rows.map((row) => this.#draw(row)), this.#following, this.#said);
    this.#requirements = design && design.requirements.length > 0 ? new Requirements(element, session, editor, checks) : null;
    editor.listeners.push(({ error, changes }) => this.#say(error ?? changes, error !== null));
    session.store.subscribe((changed) => {
      if (changed.has("scene") || changed.has("parts")) this.#follow();
      if (changed.has("editing")) element.classList.toggle("editing", session.state.editing);
    });
  }

  /** The parameters that may change when a contact is dragged, and between which values. */
  get spans(): [string, number, number][] {
    return this.#rows.filter((r) => r.free.checked).map(({ parameter: { name, range } }) => [name, range[0], range[1]]);
  }

  #row(parameter: SceneParameter): Row {
    const { name, range, is_angle, is_count } = parameter;
    const unit = is_angle ? DEGREE : 1;
    const [lo, hi] = [range[0] / unit, range[1] / unit];
    const step = is_count ? 1 : niceStep((hi - lo) / STEPS);
    const slider = html("input", { type: "range", min: lo, max: hi, step: is_count ? 1 : "any", "aria-label": name });
    const field = html("input", { type: "number", step, "aria-label": `${name}, ${is_angle ? "degrees" : "number"}` });
    const free = html("input", { type: "checkbox", "aria-label": `${name} may change when a contact is dragged`, title: "May change when a contact is dragged" });
    free.checked = !is_count;
    slider.addEventListener("input", () => {
      // A slider has places for pixels: numbers with few digits are as good.
      const value = is_count ? Number(slider.value) : rounded(Math.round(Number(slider.value) / step) * step, 12);
      this.#set(parameter, value, this.#held !== slider);
      this.#held = slider;
    });
    for (const end of ["change", "pointerup", "pointercancel", "blur"]) slider.addEventListener(end, () => (this.#held = null));
    field.addEventListener("change", () => {
      const value = field.value.trim() === "" ? NaN : Number(field.value);
      set(field, { "aria-invalid": isUsable(value) ? null : "true" });
      if (isUsable(value)) this.#set(parameter, value, true);
      else this.#say(`${name}: type a number of at most ${LARGEST_NUMBER}`, true);
    });
    return { parameter, slider, field, free };
  }

  #draw({ parameter, slider, field, free }: Row): HTMLElement {
    const unit = html("span", { class: "faint" }, parameter.is_angle ? "°" : "");
    return html("div", { class: "parameter" }, html("span", { class: "name", title: parameter.name }, parameter.name), slider, html("span", { class: "value" }, field, unit), free);
  }

  #say(text: string, isWrong: boolean): void {
    set(this.#said, { class: isWrong ? "said bad" : "said" });
    say(this.#said, text);
  }

  #set({ name, is_angle }: SceneParameter, value: number, isFirst: boolean): void {
    this.#editor.setParameters([{ name, value: is_angle ? `${value}deg` : String(value) }], isFirst);
    this.#requirements?.over(name);
  }

  /** Shows the values as they were answered; what is in a hand stays as it is. */
  #follow(): void {
    const now = this.#session.scene.design?.parameters ?? [];
    const given: ReadonlyMap<string, SceneSetting> = new Map(this.#editor.set.map((s) => [s.name, s]));
    for (const { parameter, slider, field } of this.#rows) {
      const answered = now.find((p) => p.name === parameter.name)?.value ?? parameter.value;
      const setting = given.get(parameter.name)?.value;
      // What is set is shown before it is answered; an angle is a number of degrees.
      const shown = setting === undefined ? answered / (parameter.is_angle ? DEGREE : 1) : shownOf(setting, parameter);
      const text = String(rounded(shown, 9));
      if (this.#held !== slider) slider.value = text;
      if (document.activeElement === field) continue;
      field.value = text;
      set(field, { "aria-invalid": null });
    }
    const following = now.filter((p) => p.expression !== null).map((p) => `${p.name} = ${p.is_angle ? degrees(p.value, 5) : short(rounded(p.value, 5))}`);
    say(this.#following, following.length > 0 ? `Computed from these: ${following.join(", ")}` : "");
  }
}

function shownOf(setting: string, { is_angle }: SceneParameter): number {
  const value = Number.parseFloat(setting);
  return is_angle && !setting.endsWith("deg") ? value / DEGREE : value;
}

/** A step that people count in, about so large. */
function niceStep(about: number): number {
  const power = 10 ** Math.floor(Math.log10(about));
  return power * (about / power < 2 ? 1 : about / power < 5 ? 2 : 5);
}

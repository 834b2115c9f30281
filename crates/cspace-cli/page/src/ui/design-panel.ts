/** The parameters of the model as sliders, and its requirements as they are met, each with a strip over a parameter. */

import type { SceneParameter, SceneSetting } from "../scene.js";
import { button, byId, html, say, set } from "./dom.js";
import type { Editor } from "./edit.js";
import { commentOf } from "./file-comments.js";
import { LARGEST_NUMBER, degrees, isUsable, rounded, short } from "./numbers.js";
import { widened } from "./ranges.js";
import { Requirements } from "./requirements.js";
import type { Session } from "./session.js";
import { Thresholds, type Found, type Mark } from "./thresholds.js";
import { unhurried } from "./unhurried.js";
import type { Workshop } from "./workshop.js";

/** A slider has so many steps. */
const STEPS = 400;
const DEGREE = Math.PI / 180;
/** A parameter is played from end to end in this time (ms), or as fast as its models are computed. */
const PLAYED = 8000;
/** Marks are sought so much after the last change (ms). */
const PAUSE = 300;
/** Digits of a mark in a sentence; the slider is set to all of them. */
const TOLD = 7;

interface Row {
  parameter: SceneParameter;
  /** From where to where the slider goes, in the parameter's own unit. */
  range: [number, number];
  play: HTMLButtonElement;
  /** Values at which something changes, beside the slider and in words. */
  marks: HTMLElement;
  found: HTMLElement;
  slider: HTMLInputElement;
  field: HTMLInputElement;
  /** Whether it may change when a contact is dragged. */
  free: HTMLInputElement;
}

export class DesignPanel {
  readonly #rows: Row[];
  readonly #following = html("p", { class: "faint" });
  /** What became of the last value: regions that opened or closed, or why there is no such model. */
  readonly #said = html("p", { class: "said", "aria-live": "polite" });
  readonly #requirements: Requirements | null;
  readonly #thresholds: Thresholds;
  readonly #seekLater = unhurried(() => this.#seek(), PAUSE);
  /** The parameter that was touched last. */
  #touched: Row | null = null;
  /** The parameter that is played, since when (ms). */
  #played: { row: Row; begin: number; first: boolean } | null = null;
  /** The slider that is in a hand. */
  #held: HTMLInputElement | null = null;

  /** `work` starts a worker for requirements, and one for marks, apart from what the hand waits for. */
  constructor(private readonly session: Session, private readonly editor: Editor, work: () => Workshop) {
    const design = session.scene.design;
    const parameters = design?.parameters ?? [];
    this.#rows = parameters.filter((p) => p.expression === null).map((p) => this.#row(p));
    const element = byId("design");
    element.hidden = !design;
    const head = html("h2", {}, "Parameters");
    if (parameters.length > 0) element.append(head, ...this.#rows.flatMap((row) => [this.#draw(row), row.found]), this.#following, this.#said);
    let checks: Workshop | null = null;
    const rangeOf = (name: string) => this.#rows.find((r) => r.parameter.name === name)?.range ?? [0, 0];
    this.#requirements = design && design.requirements.length > 0 ? new Requirements(element, session, editor, () => (checks ??= work()), rangeOf) : null;
    this.#thresholds = new Thresholds(session, editor, work, (found) => this.#show(found));
    editor.listeners.push(({ error, changes }) => {
      this.#say(error ?? changes, error !== null);
      requestAnimationFrame((now) => this.#playOn(now));
    });
    document.addEventListener("keydown", ({ key }) => key === "Escape" && this.#play(null));
    session.store.subscribe((changed) => {
      if (changed.has("scene") || changed.has("pair")) this.#seekLater();
      if (changed.has("scene") || changed.has("parts")) this.#follow();
      if (changed.has("editing")) element.classList.toggle("editing", session.state.editing);
    });
  }

  /** The parameters that may change when a contact is dragged, and between which values. */
  get spans(): [string, number, number][] {
    return this.#rows.filter((r) => r.free.checked).map(({ parameter: { name }, range }) => [name, ...range]);
  }

  #row(parameter: SceneParameter): Row {
    const { name, range, is_angle, is_count } = parameter;
    const comment = commentOf(this.session.scene.source?.design?.text ?? "", name);
    const words = `${name}${comment ? `, ${comment}` : ""}`;
    const unit = is_angle ? DEGREE : 1;
    const step = is_count ? 1 : niceStep((range[1] - range[0]) / unit / STEPS);
    const slider = html("input", { type: "range", step: is_count ? 1 : "any", "aria-label": name, title: words });
    const field = html("input", { type: "number", step, "aria-label": `${name}, ${is_angle ? "degrees" : "number"}`, title: words });
    const free = html("input", { type: "checkbox", "aria-label": `${name} may change when a contact is dragged`, title: "May change when a contact is dragged" });
    free.checked = !is_count;
    const play = button("▶", () => this.#play(row), { class: "small", title: `Play ${name} from end to end` });
    const marks = html("div", { class: "marks" });
    const row: Row = { parameter, range: [...range], play, marks, found: html("p", { class: "found faint", hidden: "" }), slider, field, free };
    slider.addEventListener("input", () => {
      // A slider has places for pixels: numbers with few digits are as good.
      const value = is_count ? Number(slider.value) : rounded(Math.round(Number(slider.value) / step) * step, 12);
      this.#play(null);
      this.#set(row, value, this.#held !== slider);
      this.#held = slider;
    });
    slider.addEventListener("change", () => this.#reach(row, Number(slider.value) * unit));
    slider.addEventListener("focus", () => this.#touch(row));
    for (const end of ["change", "pointerup", "pointercancel", "blur"]) slider.addEventListener(end, () => (this.#held = null));
    field.addEventListener("change", () => {
      const value = field.value.trim() === "" ? NaN : Number(field.value);
      set(field, { "aria-invalid": isUsable(value) ? null : "true" });
      if (isUsable(value)) this.#set(row, value, true);
      else this.#say(`${name}: type a number of at most ${LARGEST_NUMBER}`, true);
    });
    this.#stretch(row);
    return row;
  }

  #draw({ parameter, slider, field, free, play, marks }: Row): HTMLElement {
    const unit = html("span", { class: "faint" }, parameter.is_angle ? "°" : "");
    const name = html("span", { class: "name", title: slider.title }, html("b", {}, parameter.name), html("span", { class: "faint" }, slider.title.slice(parameter.name.length)));
    return html("div", { class: "parameter" }, name, play, html("div", { class: "slid" }, slider, marks), html("span", { class: "value" }, field, unit), free);
  }

  /** Lets the slider go where its range does. */
  #stretch({ parameter: { is_angle }, range, slider }: Row): void {
    const [min = 0, max = 0] = range.map((x) => rounded(x / (is_angle ? DEGREE : 1), 12));
    set(slider, { min, max });
  }

  /** A value at or beyond an end widens the range. */
  #reach(row: Row, value: number): void {
    if (row.range[0] < value && value < row.range[1]) return;
    row.range = widened(row.range, value, row.parameter.is_count);
    this.#stretch(row);
    this.#requirements?.measure();
    this.#seekLater();
  }

  #touch(row: Row): void {
    this.#touched = row;
    this.#requirements?.over(row.parameter.name);
    this.#seekLater();
  }

  #seek(): void {
    const row = this.#touched;
    if (row && !this.#played) this.#thresholds.seek(row.parameter.name, row.range);
  }

  #show({ name, marks, text, isRunning }: Found): void {
    for (const row of this.#rows) {
      const { parameter, range: [lo, hi], marks: scale, found } = row;
      const shown = parameter.name === name ? marks : [];
      found.hidden = parameter.name !== name;
      scale.replaceChildren(...shown.map(({ at }) => html("i", { style: `left: ${(100 * (at - lo)) / (hi - lo)}%` })));
      const mark = ({ at, text }: Mark) => {
        const value = at / (parameter.is_angle ? DEGREE : 1);
        const from = parameter.is_angle ? degrees(at, TOLD) : short(rounded(at, TOLD));
        return button(`from ${from} on: ${text}`, () => this.#set(row, value, true), { class: "small", title: `Set ${name} to ${value}` });
      };
      const end = isRunning ? [button("Cancel", () => this.#thresholds.cancel(), { class: "small" })] : [];
      found.replaceChildren(...shown.map(mark), text, ...end);
    }
  }

  /** Plays a parameter from end to end, or ends that. */
  #play(row: Row | null): void {
    const was = this.#played?.row;
    this.#played = null;
    if (was) say(was.play, "▶");
    if (was && (row === was || row === null)) this.#touch(was);
    if (!row || row === was) return;
    this.#touch(row);
    say(row.play, "❚❚");
    this.#played = { row, begin: performance.now(), first: true };
    this.#playOn(performance.now());
  }

  /** Sets the value for the time; the next once this one is answered. */
  #playOn(now: number): void {
    if (!this.#played) return;
    const { row, begin, first } = this.#played;
    const [lo, hi] = row.range;
    const share = Math.min(1, Math.max(0, now - begin) / PLAYED);
    const value = (lo + share * (hi - lo)) / (row.parameter.is_angle ? DEGREE : 1);
    this.#played = share < 1 ? { ...this.#played, first: false } : null;
    this.editor.setParameters([settingOf(row.parameter, row.parameter.is_count ? Math.round(value) : rounded(value, 6))], first);
    if (this.#played) return;
    say(row.play, "▶");
    this.#touch(row);
  }

  #say(text: string, isWrong: boolean): void {
    set(this.#said, { class: isWrong ? "said bad" : "said" });
    say(this.#said, text);
  }

  /** Sets a value, of an angle in degrees. */
  #set(row: Row, value: number, isFirst: boolean): void {
    this.editor.setParameters([settingOf(row.parameter, value)], isFirst);
    if (this.#touched !== row) this.#touch(row);
  }

  /** Shows the values as they were answered; what is in a hand stays as it is. */
  #follow(): void {
    const now = this.session.scene.design?.parameters ?? [];
    const given: ReadonlyMap<string, SceneSetting> = new Map(this.editor.set.map((s) => [s.name, s]));
    for (const row of this.#rows) {
      const { parameter, slider, field, range } = row;
      const answered = now.find((p) => p.name === parameter.name)?.value ?? parameter.value;
      const setting = given.get(parameter.name)?.value;
      // What is set is shown before it is answered; an angle is a number of degrees.
      const shown = setting === undefined ? answered / (parameter.is_angle ? DEGREE : 1) : shownOf(setting, parameter);
      const value = shown * (parameter.is_angle ? DEGREE : 1);
      // While it is in a hand, or played, its ends stay.
      if (this.#held !== slider && this.#played?.row !== row && Number.isFinite(value) && (value < range[0] || value > range[1])) this.#reach(row, value);
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

function settingOf({ name, is_angle }: SceneParameter, value: number): SceneSetting {
  return { name, value: is_angle ? `${value}deg` : String(value) };
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

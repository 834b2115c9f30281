/** The requirements of the model: values, whether they are met, and how they go with a parameter. */

import type { SceneParameter } from "../scene.js";
import { html, say, set, svg } from "./dom.js";
import type { Editor } from "./edit.js";
import { degrees, rounded, short } from "./numbers.js";
import { requirementMark, requirementText } from "./requirement-text.js";
import type { Session } from "./session.js";
import { HEIGHT, WIDTH, axes, shareAt, stretched } from "./strip-plot.js";
import { unhurried } from "./unhurried.js";
import { WorkError, type CheckRow, type Edits, type Workshop } from "./workshop.js";

/** Requirements are measured so much after the last change (ms). */
const PAUSE = 150;
/** A strip has values at so many steps of the parameter, and one more: a power of 2. */
const INTERVALS = 32;
/** Above and below what is drawn, as a share. */
const MARGIN = 0.08;
/** A band of limits is at least so thick, of {@link HEIGHT}. */
const LEAST_BAND = 7;

interface Item {
  name: string;
  mark: HTMLElement;
  value: HTMLElement;
  plot: HTMLElement;
}

/** Values over a parameter, as far as they are known. */
interface Strip {
  parameter: SceneParameter;
  /** The values of the parameter; of a count whole numbers. */
  values: number[];
  /** What is measured at each of them. */
  rows: (CheckRow[] | undefined)[];
  /** All that is edited beside the parameter: along the strip it stays, and so does what is measured. */
  key: string;
}

export class Requirements {
  readonly #session: Session;
  readonly #editor: Editor;
  readonly #checks: () => Workshop;
  readonly #items: Item[];
  /** From where to where the slider of a parameter goes. */
  readonly #rangeOf: (name: string) => readonly [number, number];
  readonly #failure = html("p", { class: "bad", role: "alert", hidden: "" });
  readonly #choice = html("select", { id: "strip-over" });
  readonly #checkLater = unhurried(() => void this.#check(), PAUSE);
  #strip: Strip | null = null;
  /** Answers of earlier questions are dropped. */
  #asked = 0;

  constructor(parent: HTMLElement, session: Session, editor: Editor, checks: () => Workshop, rangeOf: (name: string) => readonly [number, number]) {
    this.#session = session;
    this.#editor = editor;
    this.#checks = checks;
    const design = session.scene.design;
    this.#rangeOf = rangeOf;
    this.#items = (design?.requirements ?? []).map((name) => ({ name, mark: html("span", { class: "mark" }, "…"), value: html("output"), plot: html("div", { class: "plot", hidden: "" }) }));
    const free = design?.parameters.filter((p) => p.expression === null) ?? [];
    this.#choice.append(html("option", { value: "" }, "–"), ...free.map((p) => html("option", { value: p.name }, p.name)));
    this.#choice.addEventListener("change", () => {
      this.#strip = null;
      void this.#check();
    });
    const over = free.length > 0 ? [html("label", { class: "faint", for: "strip-over" }, "drawn over ", this.#choice)] : [];
    parent.append(
      html("h2", {}, "Requirements"),
      ...over,
      this.#failure,
      ...this.#items.map((item) => html("div", { class: "requirement strip" }, html("div", { class: "strip-head" }, item.mark, html("b", {}, item.name), item.value), item.plot)),
    );
    for (const { plot } of this.#items) plot.addEventListener("click", (event) => this.#choose(event, plot));
    // Of values without a model nothing is measured.
    editor.listeners.push(({ error }) => {
      if (error === null) return;
      this.#asked += 1;
      this.#forget();
    });
    session.store.subscribe((changed) => {
      if (!changed.has("scene")) return;
      session.store.change({ checked: null });
      this.#checkLater();
    });
  }

  /** The parameter that is in hand: strips are over it. */
  over(name: string): void {
    if (this.#choice.value === name) return;
    this.#choice.value = name;
    this.#strip = null;
    this.#checkLater();
  }

  /** Measures again: a range has grown. */
  measure(): void {
    this.#checkLater();
  }

  async #check(): Promise<void> {
    const asked = (this.#asked += 1);
    const checks = this.#checks();
    // What is at work is of values that are no longer set.
    checks.cancel();
    const edits = this.#editor.edits;
    const rows = await this.#measured(checks, edits);
    if (asked !== this.#asked) return;
    this.#failure.hidden = typeof rows !== "string";
    if (typeof rows === "string") {
      say(this.#failure, rows);
      this.#forget();
      return;
    }
    this.#session.store.change({ checked: rows });
    for (const item of this.#items) this.#say(item, rows.find((r) => r.name === item.name));
    await this.#measureStrip(asked, checks, edits, rows);
  }

  #forget(): void {
    for (const { mark, value } of this.#items) {
      mark.className = "mark";
      say(mark, "–");
      say(value, "");
    }
  }

  /** The rows, or why there are none. */
  async #measured(checks: Workshop, edits: Edits): Promise<CheckRow[] | string> {
    try {
      return await checks.check(edits);
    } catch (error) {
      return error instanceof WorkError ? error.message : String(error);
    }
  }

  #say(item: Item, row: CheckRow | undefined): void {
    if (!row) return;
    const mark = requirementMark(row);
    item.mark.replaceWith(mark);
    item.mark = mark;
    const ask = row.limits ? row.limits.map((x) => this.#text(row, x)).join(" to ") : row.equals !== undefined ? this.#text(row, row.equals) : null;
    say(item.value, `${this.#text(row, row.value)}${ask === null ? "" : `, is to be ${ask}`}`);
  }

  #text(row: CheckRow, value: number | boolean | null): string {
    return requirementText(row, value, this.#session.scene.unit);
  }

  /** Measures along the parameter, every other step first, and draws what is known. */
  async #measureStrip(asked: number, checks: Workshop, edits: Edits, now: CheckRow[]): Promise<void> {
    const name = this.#choice.value;
    const parameter = this.#session.scene.design?.parameters.find((p) => p.name === name);
    for (const { plot } of this.#items) plot.hidden = !parameter;
    if (!parameter) return;
    const range = this.#rangeOf(name);
    const key = JSON.stringify({ ...edits, name, range, set: edits.set.filter((s) => s.name !== name) });
    const strip = this.#strip?.key === key ? this.#strip : { parameter, values: valuesOf(range, parameter.is_count), rows: [], key };
    this.#strip = strip;
    this.#drawStrip(strip, now, parameter.value);
    for (let stride = INTERVALS; stride >= 1; stride /= 2) {
      for (let i = 0; i < strip.values.length; i += stride) {
        const value = strip.values[i];
        if (strip.rows[i] || value === undefined) continue;
        const set = [...edits.set.filter((s) => s.name !== name), { name, value: String(value) }];
        const rows = await this.#measured(checks, { ...edits, set });
        if (asked !== this.#asked) return;
        strip.rows[i] = typeof rows === "string" ? [] : rows;
        this.#drawStrip(strip, now, parameter.value);
      }
    }
  }

  #drawStrip({ parameter, values: xs, rows }: Strip, now: CheckRow[], at: number): void {
    const [lo, hi] = [xs[0] ?? 0, xs.at(-1) ?? 1];
    const shareOf = (x: number) => (hi > lo ? (x - lo) / (hi - lo) : 0);
    const shown = (x: number) => (parameter.is_angle ? degrees(x, 4) : short(rounded(x, 4)));
    for (const { name, plot } of this.#items) {
      const known = rows.map((all) => all?.find((r) => r.name === name));
      const values = known.map((r) => (typeof r?.value === "boolean" ? Number(r.value) : (r?.value ?? null)));
      const limits = now.find((r) => r.name === name)?.limits ?? null;
      const present = values.filter((v): v is number => typeof v === "number");
      const [low, high] = extent([...present, ...(limits ?? [])]);
      const y = (v: number) => (1 - MARGIN - ((1 - 2 * MARGIN) * (v - low)) / (high - low)) * HEIGHT;
      let d = "";
      let pen = false;
      for (const [i, x] of xs.entries()) {
        // What is not measured yet is drawn over; where there is no value the line has a gap.
        if (!rows[i]) continue;
        const v = values[i];
        const place = typeof v === "number" ? `${shareOf(x) * WIDTH} ${y(v)}` : null;
        // A value alone is a dot: a line of no length with a round end.
        if (place) d += pen ? `L${place}` : `M${place}L${place}`;
        pen = place !== null;
      }
      const [from, to] = limits ? [y(limits[1]), y(limits[0])] : [0, 0];
      const thick = Math.max(LEAST_BAND, to - from);
      const band = limits ? [svg("rect", { class: "limits", x: 0, width: WIDTH, y: (from + to - thick) / 2, height: thick })] : [];
      const row = now.find((r) => r.name === name);
      const text = (v: number) => (row ? this.#text(row, row.dimension === "truth" ? v > 0.5 : v) : "");
      const ends = present.length > 0 ? [text(high), text(low)] : ["", ""];
      plot.replaceChildren(...stretched(...band, svg("path", { d })), ...axes([shown(lo), parameter.name, shown(hi)], ends));
      set(plot, {
        style: `--at: ${100 * Math.min(1, Math.max(0, shareOf(at)))}%`,
        role: "img",
        "aria-label": `${name} over ${parameter.name} from ${shown(lo)} to ${shown(hi)}: ${ends.join(" at most, ")} at least`,
        title: "Click to set the parameter",
      });
    }
  }

  /** A click on a strip sets the parameter. */
  #choose(event: MouseEvent, plot: HTMLElement): void {
    const strip = this.#strip;
    if (!strip) return;
    const { parameter, values } = strip;
    const [lo, hi] = [values[0] ?? 0, values.at(-1) ?? 0];
    const value = lo + shareAt(plot, event) * (hi - lo);
    this.#editor.setParameters([{ name: parameter.name, value: String(parameter.is_count ? Math.round(value) : rounded(value, 4)) }], true);
  }
}

/** The values of a strip: evenly over the range of the slider; of a count all whole numbers, if they are not too many. */
function valuesOf([lo, hi]: readonly [number, number], isCount: boolean): number[] {
  const even = Array.from({ length: INTERVALS + 1 }, (_, i) => lo + ((hi - lo) * i) / INTERVALS);
  return isCount ? [...new Set(hi - lo <= INTERVALS ? Array.from({ length: hi - lo + 1 }, (_, i) => lo + i) : even.map(Math.round))] : even;
}

function extent(values: readonly number[]): [number, number] {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  if (!Number.isFinite(low)) return [0, 1];
  return high > low ? [low, high] : [low - 1, high + 1];
}

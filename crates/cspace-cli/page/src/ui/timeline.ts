/** Planned ways, assemblies that come apart and simulations are played here. */

import { button, html, say, set } from "./dom.js";
import { isAxes } from "./mechanism.js";
import { failure } from "./message.js";
import { short } from "./numbers.js";
import { pathAt, stateAt, stretches, timeAt, type PlayableRecord } from "./playable.js";
import { RecordError } from "./record-json.js";
import { readRecord, readRecordText } from "./records.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { atOnce, numbers } from "./strip-plot.js";
import { UNCHANGED, type Edits } from "./workshop.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4] as const;
/** So many ticks can be told apart by screen readers and pointers; more are drawn without a name. */
const NAMED_TICKS = 400;

/** Of which model a record is: its edits as JSON, and how it is computed again of another; null if it is not the page's. */
interface Origin {
  edits: string;
  again: (() => Promise<void>) | null;
}

export class Timeline {
  readonly #play: HTMLButtonElement;
  readonly #scrub = html("input", { type: "range", min: 0, max: 1, step: "any", value: 0, "aria-label": "Time" });
  readonly #ticks = html("div", { class: "ticks" });
  readonly #track: HTMLElement;
  readonly #loop: HTMLButtonElement;
  readonly #trace: HTMLButtonElement;
  readonly #text = html("output", { class: "time-text" });
  readonly #choice = html("select", { "aria-label": "Record" });
  readonly #again = html("button", { type: "button", class: "again", hidden: "" });
  readonly #records = new Map<PlayableRecord, Origin>();
  #last = 0;

  constructor(private readonly element: HTMLElement, private readonly session: Session, private readonly edits: () => Edits) {
    const { store } = session;
    this.#choice.addEventListener("change", () => {
      this.#choose([...this.#records.keys()][this.#choice.selectedIndex] ?? null);
      this.showStart();
    });
    this.#play = button("▶", () => this.toggle(), { class: "play" });
    this.#scrub.addEventListener("input", () => store.change({ time: Number(this.#scrub.value), playing: false }));
    this.#track = html("div", { class: "track" }, this.#ticks, this.#scrub);
    const pressed = (b: HTMLElement, on: boolean) => set(b, { "aria-pressed": String(on) });
    this.#loop = button("Loop", () => pressed(this.#loop, !this.#isLoop), { class: "small", "aria-pressed": "false", title: "Play again and again" });
    this.#trace = button("Trace", () => store.change({ traced: store.state.traced ? null : "next" }), { class: "small", title: "Then click a point of a part: the path that it takes is drawn" });
    store.subscribe((changed, { traced }) => changed.has("traced") && pressed(this.#trace, traced !== null));
    const speed = html("select", { "aria-label": "Speed" }, ...SPEEDS.map((s) => html("option", { value: s }, `${s}×`)));
    speed.value = "1";
    speed.addEventListener("change", () => store.change({ speed: Number(speed.value) }));
    this.#again.addEventListener("click", () => {
      const { record } = session.state;
      const again = record && this.#records.get(record)?.again;
      if (!again) return;
      this.#records.delete(record);
      this.#choose(null);
      again().catch((error: unknown) => store.change({ message: failure(error) }));
    });
    const close = button("✕", () => this.#choose(null), { "aria-label": "Close the record" });
    element.append(this.#choice, this.#play, this.#track, speed, this.#loop, this.#trace, this.#text, this.#again, close);
    for (const { name, record } of session.scene.records) this.#keep(() => readRecord(name, record));
    store.subscribe((changed) => this.#update(changed));
    const all = [...this.#records.keys()];
    const first = all.find((record) => this.#mismatch(record) === null) ?? all[0];
    if (first) this.#choose(first);
  }

  /** Places the parts as the chosen record begins. */
  showStart(): void {
    const { record, time } = this.session.state;
    if (record && !this.session.state.stale) this.#show(record, time);
  }

  /** Reads a file that the user opens or drops. */
  async open(file: File): Promise<void> {
    const packed = file.name.toLowerCase().endsWith(".gz");
    const bytes = packed ? file.stream().pipeThrough(new DecompressionStream("gzip")) : file;
    const text = await new Response(bytes).text().catch(() => null);
    this.#open(() => {
      if (text === null) throw new RecordError(`${file.name}: what is compressed in it cannot be read`);
      return readRecordText(file.name, text);
    });
  }

  /** Plays what the page has computed itself, of a model with edits. */
  play(name: string, text: string, edits: Edits, again: Origin["again"]): void {
    this.#open(() => readRecordText(name, text), edits, again);
    const { record, stale } = this.session.state;
    if (record?.name === name) this.session.store.change({ playing: !stale });
  }

  /** Takes a record that the user opens, and plays it; one that is none of this model is told and forgotten. */
  #open(read: () => PlayableRecord, edits = this.edits(), again: Origin["again"] = null): void {
    this.#told(() => {
      const record = read();
      const problem = this.#mismatch(record);
      if (problem) throw new RecordError(problem);
      this.#records.set(record, { edits: JSON.stringify(edits), again });
      this.session.store.change({ message: null });
      this.#choose(record);
      this.showStart();
    });
  }

  /** Takes a record of the page, which is of the model as in its file. A path may be of a pair that is selected later. */
  #keep(read: () => PlayableRecord): void {
    this.#told(() => {
      const record = read();
      const problem = record.kind === "simulation" ? this.#mismatch(record) : null;
      if (problem) throw new RecordError(problem);
      this.#records.set(record, { edits: JSON.stringify(UNCHANGED), again: null });
    });
  }

  #told(take: () => void): void {
    try {
      take();
    } catch (error) {
      if (!(error instanceof RecordError)) throw error;
      this.session.store.change({ message: failure(error) });
    }
  }

  #choose(record: PlayableRecord | null): void {
    const problem = record ? this.#mismatch(record) : null;
    if (problem) {
      this.session.store.change({ message: failure(problem) });
      // The list shows the record that is played, and not the one that cannot be.
      this.#drawRecord(this.session.state.record);
      return;
    }
    this.session.store.change({ record, time: 0, playing: false });
    this.#compare();
  }

  /** Why a record is none of this model. */
  #mismatch(record: PlayableRecord): string | null {
    const { scene, pair } = this.session;
    if (record.kind === "simulation") {
      const names = new Set(scene.parts.map((p) => p.name));
      const unknown = record.parts.find((p) => !names.has(p));
      return unknown === undefined ? null : `${record.name}: the model has no part "${unknown}"`;
    }
    const first = record.steps[0]?.at;
    if (!pair || !first || isAxes(first) === (pair.class === "fixed-axes")) return null;
    return `${record.name}: the path is in ${isAxes(first) ? "(u, v)" : "(x, y, theta)"}, which the selected pair is not: select the pair it was planned for first`;
  }

  get #isLoop(): boolean {
    return this.#loop.ariaPressed === "true";
  }

  toggle(): void {
    const { record, playing, time, stale } = this.session.state;
    if (!record || stale) return;
    this.session.store.change({ playing: !playing, time: !playing && time >= record.duration ? 0 : time });
  }

  #update(changed: ReadonlySet<Key>): void {
    const { state } = this.session;
    const record = state.record;
    // A way belongs to the pair it was planned for.
    if (changed.has("pair") && !changed.has("record") && record?.kind === "plan") this.#choose(null);
    if (changed.has("record")) this.#drawRecord(record);
    if (changed.has("scene") || changed.has("parts")) this.#compare();
    if (changed.has("stale") || changed.has("record")) this.#drawStale();
    if (changed.has("playing")) {
      say(this.#play, state.playing ? "❚❚" : "▶");
      set(this.#play, { "aria-label": state.playing ? "Pause" : "Play" });
      if (state.playing) {
        this.#last = performance.now();
        requestAnimationFrame((now) => this.#tick(now));
      }
    }
    if (!record || this.session.state.stale || !(["time", "record", "stale"] as Key[]).some((k) => changed.has(k))) return;
    this.#scrub.value = String(state.time);
    const told = [...record.ticks].reverse().find((t) => t.t <= state.time);
    const [now, end] = [timeAt(record, state.time), timeAt(record, record.duration)];
    say(this.#text, `${short(Number(now.toFixed(3)))} s of ${short(end)} s · ${told ? told.text : record.summary}`);
    set(this.#text, { title: this.#text.textContent });
    if (changed.has("time")) this.#show(record, state.time);
  }

  /** A record of the model before it was changed is not played: parts go elsewhere. The same edits are the same model. */
  #compare(): void {
    const { record, playing } = this.session.state;
    const stale = record !== null && this.#records.get(record)?.edits !== JSON.stringify(this.edits());
    this.session.store.change({ stale, playing: playing && !stale });
  }

  #drawStale(): void {
    const { record, stale } = this.session.state;
    document.body.classList.toggle("stale", stale);
    this.#play.disabled = this.#scrub.disabled = stale;
    this.#again.hidden = !stale || !(record && this.#records.get(record)?.again);
    say(this.#again, record?.kind === "plan" ? "Plan again" : "Compute again");
    if (stale) say(this.#text, "of the model before the change");
  }

  #tick(now: number): void {
    const { state, store } = this.session;
    if (!state.playing || !state.record) return;
    let time = state.time + ((now - this.#last) / 1000) * state.speed;
    this.#last = now;
    if (this.#isLoop && time >= state.record.duration) time = 0;
    const over = time >= state.record.duration && !this.#isLoop;
    store.change({ time: Math.min(time, state.record.duration), playing: !over });
    if (!over) requestAnimationFrame((next) => this.#tick(next));
  }

  #show(record: PlayableRecord, time: number): void {
    if (record.kind === "simulation") {
      const state = stateAt(record, time);
      if (state) this.session.setPlacements(this.session.placementsBy(state.parts));
      return;
    }
    const c = pathAt(record, time);
    if (c) this.session.setConfiguration(c);
  }

  #drawRecord(record: PlayableRecord | null): void {
    this.element.hidden = !record;
    this.#choice.replaceChildren(...[...this.#records.keys()].map((r) => html("option", {}, r.name)));
    if (!record) return;
    this.#choice.selectedIndex = [...this.#records.keys()].indexOf(record);
    set(this.#scrub, { max: record.duration });
    this.#track.querySelector(".time-axis")?.remove();
    this.#track.append(numbers(record));
    const named = record.ticks.length <= NAMED_TICKS;
    const share = (t: number) => (record.duration > 0 ? (100 * t) / record.duration : 0);
    this.#ticks.replaceChildren(
      ...stretches(record).map(([from, to]) => html("b", { title: atOnce, style: `left: ${share(from)}%; width: ${share(to - from)}%` })),
      ...record.ticks.map(({ t, text }) => {
        const tick = html("i", named ? { title: text } : {});
        tick.style.left = `${share(t)}%`;
        return tick;
      }),
    );
  }
}

/** The orientation: a slider whose ticks are the critical orientations, with the current band marked. */

import { button, html, say, set } from "./dom.js";
import { isPlanar } from "./mechanism.js";
import { lowerPair } from "./lower.js";
import { degrees, length, within } from "./numbers.js";
import { TURN, wrap } from "./placement.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";

/** Space at both ends (pixels), so that the knob stays inside. */
const MARGIN = 12;
/** A part that slides without limits is moved within this many of the unit. */
const UNLIMITED = 100;

export class ThetaSlider {
  readonly #session: Session;
  readonly #slider: HTMLElement;
  readonly #canvas: HTMLCanvasElement;
  readonly #text: HTMLElement;
  readonly #name: HTMLElement;
  readonly #bands: HTMLButtonElement[];

  constructor(parent: HTMLElement, session: Session) {
    this.#session = session;
    this.#canvas = html("canvas", { "aria-hidden": "true" });
    this.#slider = html("div", { class: "theta-slider", role: "slider", tabindex: 0, "aria-label": "Orientation" }, this.#canvas);
    this.#text = html("output", { class: "band-text" });
    this.#name = html("span", { class: "theta-name" }, "θ");
    const step = (text: string, label: string, by: 1 | -1) => button(text, () => session.stepBand(by), { "aria-label": label, title: label });
    this.#bands = [step("◀", "Previous band (Page Down)", -1), step("▶", "Next band (Page Up)", 1)];
    parent.append(this.#name, ...this.#bands.slice(0, 1), this.#slider, ...this.#bands.slice(1), this.#text);
    this.#listen();
    new ResizeObserver(() => this.#draw()).observe(this.#slider);
    session.store.subscribe((changed) => {
      if ((["configuration", "space", "theme", "pair", "view"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#draw());
  }

  /** What can be chosen from, and whether it goes round. */
  #range(): { lo: number; hi: number; round: boolean; value: number; angle: boolean } | null {
    const { planar, pair, state } = this.#session;
    const c = state.configuration;
    if (!isPlanar(c) || !pair) return null;
    if (planar) {
      const { lo, hi, fullTurn } = planar.window;
      return { lo, hi, round: fullTurn, value: fullTurn ? wrap(c.theta, lo) : c.theta, angle: true };
    }
    const lower = lowerPair(pair);
    if (!lower) return null;
    const angle = lower.type === "revolute";
    const [lo, hi] = lower.limits ?? (angle ? [-Math.PI, Math.PI] : [-UNLIMITED, UNLIMITED]);
    const value = lower.coordinate(c);
    const round = angle && !lower.limits;
    return { lo, hi, round, value: round ? wrap(value, lo) : value, angle };
  }

  #set(value: number): void {
    const { planar, pair } = this.#session;
    const range = this.#range();
    if (!range || !pair) return;
    const held = range.round ? value : Math.min(range.hi, Math.max(range.lo, value));
    if (planar) {
      // The turn in which the orientation is now is kept.
      const c = this.#session.aimed;
      if (isPlanar(c)) this.#session.setTheta(range.round ? c.theta + wrap(held - c.theta, -Math.PI) : held);
      return;
    }
    const at = lowerPair(pair)?.at(held);
    if (at) this.#session.aim(at);
  }

  #listen(): void {
    const at = (event: PointerEvent) => {
      const r = this.#slider.getBoundingClientRect();
      const range = this.#range();
      if (!range) return;
      const f = (event.clientX - r.left - MARGIN) / Math.max(1, r.width - 2 * MARGIN);
      this.#set(range.lo + Math.min(1, Math.max(0, f)) * (range.hi - range.lo));
    };
    const { store } = this.#session;
    this.#slider.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      this.#slider.setPointerCapture(event.pointerId);
      store.change({ dragging: true, playing: false });
      at(event);
    });
    this.#slider.addEventListener("pointermove", (event) => {
      if (this.#slider.hasPointerCapture(event.pointerId)) at(event);
    });
    const up = () => store.change({ dragging: false });
    this.#slider.addEventListener("lostpointercapture", up);
    this.#slider.addEventListener("keydown", (event) => {
      const range = this.#range();
      if (!range) return;
      const step = (range.angle ? Math.PI / 180 : (range.hi - range.lo) / 200) * (event.shiftKey ? 0.1 : 1);
      const by = { ArrowRight: step, ArrowUp: step, ArrowLeft: -step, ArrowDown: -step }[event.key];
      if (by !== undefined) this.#set(range.value + by);
      else if (event.key === "Home") this.#set(range.lo);
      else if (event.key === "End") this.#set(range.hi);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  #draw(): void {
    const range = this.#range();
    const { planar, scene, state } = this.#session;
    this.#slider.parentElement?.classList.toggle("unused", !range);
    // What changes between orientations is told beside the surface.
    const banded = planar && state.view === "space";
    for (const b of this.#bands) b.hidden = !banded;
    if (!range) return;
    const span = range.hi - range.lo;
    const text = range.angle ? degrees(range.value, 6, span) : length(within(range.value, span), scene.unit);
    set(this.#slider, { "aria-valuemin": range.lo, "aria-valuemax": range.hi, "aria-valuenow": range.value, "aria-valuetext": text });
    say(this.#name, planar ? "θ" : "joint");

    const { width, height } = this.#slider.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    this.#canvas.width = Math.round(width * ratio);
    this.#canvas.height = Math.round(height * ratio);
    const g = this.#canvas.getContext("2d");
    if (!g) return;
    g.scale(ratio, ratio);
    const style = getComputedStyle(this.#slider);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    const x = (value: number) => MARGIN + ((value - range.lo) / (range.hi - range.lo)) * (width - 2 * MARGIN);
    const middle = height / 2;
    g.fillStyle = colour("--line");
    g.fillRect(MARGIN, middle - 2, width - 2 * MARGIN, 4);
    if (banded && isPlanar(state.configuration)) {
      const index = planar.bandAt(state.configuration.theta);
      const band = planar.bands[index];
      g.fillStyle = colour("--accent");
      if (band) {
        // A band may run over the end of a full turn.
        for (const turn of [-TURN, 0, TURN]) {
          const [a, b] = [Math.max(range.lo, band[0] + turn), Math.min(range.hi, band[1] + turn)];
          if (a < b) g.fillRect(x(a), middle - 5, Math.max(2, x(b) - x(a)), 10);
        }
      }
      g.fillStyle = colour("--tick");
      for (const theta of planar.criticalOrientations) g.fillRect(x(range.round ? wrap(theta, range.lo) : theta) - 0.5, middle - 9, 1, 18);
      const ends = band ? `, ${band.map((end) => degrees(end, 4, band[1] - band[0])).join(" to ")}` : "";
      say(this.#text, `${text} · band ${index + 1} of ${planar.bands.length}${ends}`);
    } else {
      say(this.#text, text);
    }
    g.fillStyle = colour("--text");
    g.beginPath();
    g.arc(x(range.value), middle, 7, 0, TURN);
    g.fill();
    g.fillStyle = colour("--panel");
    g.beginPath();
    g.arc(x(range.value), middle, 3, 0, TURN);
    g.fill();
  }
}

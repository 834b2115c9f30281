/** The question and its answer, over all views. */

import type { Configuration, Kernel } from "../kernel/api.js";
import { cageOf } from "./cage.js";
import { byId, html, say, set } from "./dom.js";
import { firstPair } from "./first-pair.js";
import { lowerPair } from "./lower.js";
import { isAxes } from "./mechanism.js";
import { playOf } from "./play.js";
import { heldOneWay, pushesOf } from "./pushes.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { cagedIn, details, headline, regionOf, standing } from "./verdict.js";
import { unhurried } from "./unhurried.js";
import type { Told } from "./verdict.js";

/** Play is told so much later than the headline (ms): it is found by motions. */
const PAUSE = 120;

/** Of what stops a mechanism so many are listed. */
const LISTED = 3;

export class VerdictView {
  readonly #session: Session;
  readonly #element: HTMLElement;
  readonly #question = html("h2", { id: "question" });
  readonly #headline = html("p", { class: "headline", "aria-live": "polite" });
  readonly #order = html("p", {});
  readonly #details = byId("play");
  /** What becomes of pushed parts at a configuration. */
  #pushed: { kernel: Kernel; at: Configuration; pushes: Told["pushes"] } | null = null;
  readonly #held = html("div", { class: "held", "aria-live": "polite" });
  readonly #tellLater = unhurried(() => this.#tell(), PAUSE);

  constructor(parent: HTMLElement, session: Session) {
    this.#session = session;
    this.#element = parent;
    parent.append(this.#question, html("div", { id: "verdict" }, this.#headline, this.#order, this.#held));
    const first = firstPair(session.scene);
    session.store.subscribe((changed, state) => {
      if (changed.has("pair")) {
        this.#element.style.minHeight = this.#details.style.minHeight = "";
        say(this.#question, (state.pair === first && session.scene.show.question) || "");
      }
      if (changed.has("held")) this.#sayHeld();
      if (changed.has("order")) say(this.#order, state.order ?? "");
      if ((["where", "space", "pair", "parts", "displaced", "whole", "dragging", "playing"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
  }

  #draw(): void {
    const { pair, state } = this.#session;
    const told = this.#told();
    const touches = state.where.classification === "contact" || state.where.fits;
    set(document.body, { "data-standing": told && standing(told) });
    set(this.#element, { class: touches ? "touching" : null });
    this.#light(told);
    if (told) say(this.#headline, headline(told));
    else if (state.space.state === "loading") say(this.#headline, "Computing …");
    else say(this.#headline, pair && lowerPair(pair) ? "Joined: the parts always touch." : "No configuration space.");
    this.#tellLater();
  }

  /** What stopped the last drag of the mechanism, which parts overlap, and which are smaller than drawn. */
  #sayHeld(): void {
    const { stopped, overlapping, gaps } = this.#session.state.held ?? { stopped: [], overlapping: [], gaps: [] };
    const lines = overlapping.map(([a, b]) => `${a} and ${b} overlap: drag them apart.`);
    if (stopped.length > 0) lines.push(`Stopped: ${stopped.slice(0, LISTED).join("; ")}${stopped.length > LISTED ? ` and ${stopped.length - LISTED} more` : ""}.`);
    lines.push(...gaps.map((gap) => `${gap}.`));
    this.#show(this.#held, lines);
  }

  #told(): Told | null {
    const { pair, kernel, state, scene, axes } = this.#session;
    if (!pair || !kernel || kernel.class === "lower") return null;
    const name = (part: number) => scene.parts[part]?.name ?? "?";
    const region = cagedIn(this.#session);
    const named = new Set(Object.values(state.parts[pair.fixed]?.feature_names ?? {}));
    const cage = region === null ? [] : cageOf(kernel, region).filter((feature) => named.has(feature));
    const pushes = this.#isPushed ? (this.#pushed?.pushes ?? null) : null;
    return { pair, kernel, pushes, cage, where: state.where, fixed: name(pair.fixed), moving: name(pair.moving), axes: axes ? [axes.u, axes.v] : null, others: scene.parts.length > 2, whole: state.whole, displaced: state.displaced, unit: scene.unit };
  }

  /** What the verdict rests on is lit in the drawing: what cages the part, or what holds the one that turns one way only. */
  #light(told: Told | null): void {
    const { kernel, store } = this.#session;
    const region = cagedIn(this.#session);
    const held = told?.pushes && (heldOneWay(told.pushes.u) ?? heldOneWay(told.pushes.v));
    const touching = held ? held.push.touching : [];
    const reason = { fixed: region !== null && kernel ? cageOf(kernel, region) : touching.map((t) => t.fixed), moving: touching.map((t) => t.moving) };
    if (JSON.stringify(reason) !== JSON.stringify(store.state.reason)) store.change({ reason });
  }

  /** Whether pushes are known here: how far they go depends on where the parts are, and that nothing holds them does not. */
  get #isPushed(): boolean {
    const { kernel, state } = this.#session;
    if (this.#pushed?.kernel !== kernel) return false;
    const { u, v } = this.#pushed?.pushes ?? { u: null, v: null };
    return this.#pushed?.at === state.configuration || [u?.back, u?.forth, v?.back, v?.forth].every((push) => !push || push.gone === Infinity);
  }

  #tell(): void {
    const { kernel, axes, state } = this.#session;
    const c = state.configuration;
    if (axes && kernel && isAxes(c) && !state.dragging && !state.playing && !this.#isPushed && regionOf({ where: state.where, kernel }) !== null) {
      this.#pushed = { kernel, at: c, pushes: pushesOf(axes, c) };
      this.#draw();
      return;
    }
    const told = this.#told();
    const free = state.where.classification === "free" || state.where.classification === "contact";
    const lines = told && kernel ? details(told, free ? playOf(kernel, state.configuration) : []) : [];
    this.#show(this.#details, lines);
  }

  /** What took room once keeps it: what is below stays in its place. */
  #show(element: HTMLElement, lines: readonly string[]): void {
    element.replaceChildren(...lines.map((line) => html("p", {}, line)));
    for (const e of [this.#element, this.#details]) e.style.minHeight = `${e.offsetHeight}px`;
  }
}

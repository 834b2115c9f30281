/** The verdict at the top of the side panel. */

import { html, say, set } from "./dom.js";
import { lowerPair } from "./lower.js";
import { playOf } from "./play.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { details, headline, standing } from "./verdict.js";
import { unhurried } from "./unhurried.js";
import type { Told } from "./verdict.js";

/** Play is told so much later than the headline (ms): it is found by motions. */
const PAUSE = 120;

/** Of what stops a mechanism so many are listed. */
const LISTED = 3;

export class VerdictView {
  readonly #session: Session;
  readonly #element: HTMLElement;
  readonly #headline = html("p", { class: "headline", "aria-live": "polite" });
  readonly #details = html("div", { class: "detail" });
  readonly #held = html("div", { class: "held", "aria-live": "polite" });
  readonly #tellLater = unhurried(() => this.#tell(), PAUSE);

  constructor(parent: HTMLElement, session: Session) {
    this.#session = session;
    this.#element = parent;
    parent.append(html("div", { class: "pinned" }, this.#headline, this.#held), this.#details);
    session.store.subscribe((changed) => {
      if (changed.has("pair")) this.#element.style.minHeight = "";
      if (changed.has("held")) this.#sayHeld();
      if ((["where", "space", "pair", "parts", "displaced", "whole"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
  }

  #draw(): void {
    const { pair, state } = this.#session;
    const told = this.#told();
    const touches = state.where.classification === "contact" || state.where.fits;
    set(this.#element, { "data-standing": told && standing(told), class: touches ? "touching" : null });
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
    return { pair, kernel, where: state.where, fixed: name(pair.fixed), moving: name(pair.moving), axes: axes ? [axes.u, axes.v] : null, others: scene.parts.length > 2, whole: state.whole, displaced: state.displaced, unit: scene.unit };
  }

  #tell(): void {
    const told = this.#told();
    const { kernel, state } = this.#session;
    const free = state.where.classification === "free" || state.where.classification === "contact";
    const lines = told && kernel ? details(told, free ? playOf(kernel, state.configuration) : []) : [];
    this.#show(this.#details, lines);
  }

  /** What took room once keeps it: what is below stays in its place. */
  #show(element: HTMLElement, lines: readonly string[]): void {
    element.replaceChildren(...lines.map((line) => html("p", {}, line)));
    this.#element.style.minHeight = `${this.#element.offsetHeight}px`;
  }
}

/** The verdict at the top of the side panel. */

import { html, say, set } from "./dom.js";
import { lowerPair } from "./lower.js";
import { playOf } from "./play.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { details, headline } from "./verdict.js";
import { unhurried } from "./unhurried.js";
import type { Told } from "./verdict.js";

/** Play is told so much later than the headline (ms): it is found by motions. */
const PAUSE = 120;

export class VerdictView {
  readonly #session: Session;
  readonly #element: HTMLElement;
  readonly #headline = html("p", { class: "headline", "aria-live": "polite" });
  readonly #details = html("div", { class: "detail" });
  readonly #tellLater = unhurried(() => this.#tell(), PAUSE);

  constructor(parent: HTMLElement, session: Session) {
    this.#session = session;
    this.#element = parent;
    parent.append(this.#headline, this.#details);
    session.store.subscribe((changed) => {
      if ((["where", "space", "pair", "parts"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
  }

  #draw(): void {
    const { pair, state } = this.#session;
    const told = this.#told();
    set(this.#element, { "data-class": told ? state.where.classification : null });
    if (told) say(this.#headline, headline(told));
    else if (state.space.state === "loading") say(this.#headline, "Computing …");
    else say(this.#headline, pair && lowerPair(pair) ? "Joined: the parts always touch." : "No configuration space.");
    this.#tellLater();
  }

  #told(): Told | null {
    const { pair, kernel, state, scene } = this.#session;
    if (!pair || !kernel || kernel.class === "lower") return null;
    const name = (part: number) => scene.parts[part]?.name ?? "?";
    return { pair, kernel, where: state.where, fixed: name(pair.fixed), moving: name(pair.moving), unit: scene.unit };
  }

  #tell(): void {
    const told = this.#told();
    const { kernel, state } = this.#session;
    const free = state.where.classification === "free" || state.where.classification === "contact";
    const lines = told && kernel ? details(told, free ? playOf(kernel, state.configuration) : []) : [];
    this.#details.replaceChildren(...lines.map((line) => html("p", {}, line)));
  }
}

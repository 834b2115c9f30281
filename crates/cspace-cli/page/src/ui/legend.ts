/** What the colours mean. Regions can be hidden, and gone to. */

import type { Configuration, PatchKind } from "../kernel/api.js";
import { KINDS, KIND_NAMES, TOUCHING, regionColour } from "./colours.js";
import { button, html } from "./dom.js";
import { regionName } from "./region-names.js";
import type { Session } from "./session.js";
import type { Key } from "./state.js";
import { regionOf } from "./verdict.js";

/** A space may have thousands of regions: as many are listed. */
const LISTED = 40;

export class Legend {

  /** `fit` shows a region as large as the views allow. */
  constructor(private readonly element: HTMLElement, private readonly session: Session, private readonly fit: (region: number) => void) {
    session.store.subscribe((changed) => {
      if ((["space", "colouring", "hidden", "pair"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
  }

  #draw(): void {
    const { state, pair, kernel } = this.session;
    const focused = document.activeElement?.id ?? "";
    const items: HTMLElement[] = [];
    if (pair && kernel && kernel.class !== "lower") {
      const byKind = state.colouring === "kind";
      if (byKind) items.push(...(Object.keys(KINDS) as PatchKind[]).map((kind) => html("li", {}, swatch(KINDS[kind]), html("span", {}, KIND_NAMES[kind]))));
      items.push(...pair.regions.slice(0, LISTED).map((region, i) => this.#region(i, regionName(pair, i), region.sample, byKind)));
      if (pair.regions.length > LISTED) items.push(html("li", {}, `and ${pair.regions.length - LISTED} more regions`));
      items.push(html("li", {}, swatch(TOUCHING), html("span", {}, "touching")));
    }
    this.element.replaceChildren(...(items.length > 0 ? [html("ul", {}, ...items)] : []));
    this.element.hidden = items.length === 0;
    if (focused) document.getElementById(focused)?.focus();
  }

  #region(index: number, name: string, sample: number[], byKind: boolean): HTMLElement {
    const { store } = this.session;
    const id = `region-${index}`;
    const box = html("input", { type: "checkbox", id });
    box.checked = !this.session.state.hidden.has(index);
    box.addEventListener("change", () => {
      const hidden = new Set(this.session.state.hidden);
      if (box.checked) hidden.delete(index);
      else hidden.add(index);
      store.change({ hidden });
    });
    const label = html("label", { for: id }, ...(byKind ? [] : [swatch(regionColour(index))]), name);
    const go = button("→", () => this.session.setConfiguration(configurationOf(sample)), { class: "small", title: "Go to a configuration in it", "aria-label": `Go to ${name}` });
    const show = () => {
      if (regionOf({ where: this.session.state.where, kernel: this.session.kernel }) !== index) go.click();
      store.flush();
      this.fit(index);
    };
    const fit = button("Fit", show, { class: "small", title: "Show all of it, as large as the views allow", "aria-label": `Fit to ${name}` });
    return html("li", {}, box, label, go, fit);
  }
}

function swatch(colour: string): HTMLElement {
  const element = html("i", { class: "swatch", "aria-hidden": "true" });
  element.style.background = colour;
  return element;
}

function configurationOf([a = 0, b = 0, c]: readonly number[]): Configuration {
  return c === undefined ? { u: a, v: b } : { x: a, y: b, theta: c };
}

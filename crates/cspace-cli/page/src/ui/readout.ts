/** The configuration in numbers, where it is, and what touches. */

import type { AxisInfo, Touch } from "../kernel/api.js";
import { html, say, set } from "./dom.js";
import { isAxes } from "./mechanism.js";
import { degrees, length, short, within } from "./numbers.js";
import { TURN } from "./placement.js";
import { regionName } from "./region-names.js";
import type { Session } from "./session.js";
import { sliceExtent } from "./slice-extent.js";
import type { Key } from "./state.js";
import { regionOf } from "./verdict.js";

/** As many touching features are listed. */
const LISTED = 8;

export class Readout {
  readonly #session: Session;
  readonly #outdated: HTMLElement;
  readonly #configuration: HTMLElement;
  readonly #class: HTMLElement;
  readonly #region: HTMLElement;
  readonly #nearest: HTMLElement;
  readonly #touching: HTMLElement;
  /** What experts ask for: what the pair is, and features as the command calls them. */
  readonly #pairClass = html("div", { id: "pair-class" });
  readonly #details = html("div", { class: "touching-list" });

  constructor(parent: HTMLElement, session: Session) {
    this.#session = session;
    const entry = (name: string, room: string, ...classes: string[]) => {
      const value = html("dd", { class: classes.join(" ") });
      parent.append(html("div", { class: room }, html("dt", {}, name), value));
      return value;
    };
    this.#outdated = html("div", { class: "outdated-note", role: "status" });
    parent.append(this.#outdated);
    this.#configuration = entry("configuration", "", "number");
    this.#class = entry("is", "short", "class");
    this.#region = entry("region", "short");
    this.#nearest = entry("nearest", "tall", "number");
    this.#touching = entry("touching", "", "touching-list");
    parent.append(html("details", { id: "details" }, html("summary", {}, "Details"), this.#pairClass, this.#details));
    this.#class.setAttribute("aria-live", "polite");
    session.store.subscribe((changed) => {
      if ((["where", "configuration", "space", "scene", "outdated"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
  }

  #draw(): void {
    const { state, scene, axes, kernel } = this.#session;
    const { classification, region, nearest, touching } = state.where;
    const c = state.configuration;
    // A shape that crosses itself has no space.
    this.#outdated.hidden = !state.outdated;
    say(this.#outdated, state.outdated ? "of the last valid shape:" : "");
    const extent = sliceExtent(state);
    const at = (value: number) => length(within(value, extent), scene.unit);
    if (isAxes(c)) {
      const text = (value: number, info: AxisInfo | undefined) => (info?.kind === "length" ? at(value) : info?.kind === "still" ? "still" : degrees(value, 6, TURN));
      const name = (part: number | undefined) => scene.parts[part ?? -1]?.name ?? "";
      const { pair } = this.#session;
      say(this.#configuration, `${name(pair?.fixed)} ${text(c.u, axes?.u)}, ${name(pair?.moving)} ${text(c.v, axes?.v)}`);
    } else {
      say(this.#configuration, `x ${at(c.x)}, y ${at(c.y)}, θ ${degrees(c.theta, 6, TURN)}`);
    }
    const outside = kernel && kernel.class !== "lower" ? "outside of the window" : "–";
    say(this.#class, classification ?? outside);
    set(this.#class, { "data-class": classification ?? "" });
    // A configuration in contact bounds the region of the patch it is on.
    const bounds = region === null ? regionOf({ where: state.where, kernel }) : null;
    const { pair } = this.#session;
    const name = (index: number) => (pair ? regionName(pair, index) : String(index));
    say(this.#region, region !== null ? name(region) : bounds !== null ? `edge of ${name(bounds)}` : "–");
    const known = pair?.resolution ?? 0;
    const words = ({ fixed, moving }: Touch) => `${kernel?.words(fixed, false)} | ${kernel?.words(moving, true)}`;
    say(this.#nearest, nearest ? `${distanceText(nearest.distance, known, scene.unit)}: ${words(nearest)}` : "–");
    const list = (element: HTMLElement, text: (touch: Touch) => string) => {
      // Two features may be called the same.
      const lines = [...new Set(touching.slice(0, LISTED).map(text))];
      if (lines.length === 0) lines.push("nothing");
      if (touching.length > LISTED) lines.push(`and ${touching.length - LISTED} more`);
      element.replaceChildren(...lines.map((line) => html("div", {}, line)));
    };
    list(this.#touching, words);
    const { fixed = 0, moving = 0 } = pair?.features ?? {};
    say(this.#pairClass, pair ? `${pair.class} pair, ${fixed} + ${moving} features, ${kernel?.patchCount ?? 0} patches` : "");
    list(this.#details, (t) => touchText(t, known, scene.unit));
  }
}

/** A distance that is less than what contacts are known to is none. */
function distanceText(distance: number, resolution: number, unit: string | null): string {
  return length(Math.abs(distance) < resolution ? 0 : distance, unit);
}

function touchText(touch: Touch, resolution: number, unit: string | null): string {
  return `${touch.fixed} | ${touch.moving}, distance ${distanceText(touch.distance, resolution, unit)}, normal (${short(round(touch.normal[0]))}, ${short(round(touch.normal[1]))})`;
}

/** Components of normals are shown to this many decimals. */
function round(component: number): number {
  return Math.round(component * 1e5) / 1e5;
}

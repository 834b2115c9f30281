/** The configuration in numbers, where it is, and what touches. */

import type { AxisInfo, Touch } from "../kernel/api.js";
import { html, say, set } from "./dom.js";
import { isAxes } from "./mechanism.js";
import { degrees, length, short } from "./numbers.js";
import { regionName } from "./region-names.js";
import type { Session } from "./session.js";
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
    this.#nearest = entry("nearest features", "tall", "number");
    this.#touching = entry("touching", "", "touching-list");
    this.#class.setAttribute("aria-live", "polite");
    session.store.subscribe((changed) => {
      if ((["where", "configuration", "space", "outdated"] as Key[]).some((k) => changed.has(k))) this.#draw();
    });
  }

  #draw(): void {
    const { state, scene, axes, kernel } = this.#session;
    const { classification, region, nearest, touching } = state.where;
    const c = state.configuration;
    // A shape that crosses itself has no space.
    this.#outdated.hidden = !state.outdated;
    say(this.#outdated, state.outdated ? "of the last valid shape:" : "");
    if (isAxes(c)) {
      const text = (value: number, info: AxisInfo | undefined) => (info?.kind === "length" ? length(value, scene.unit) : info?.kind === "still" ? "still" : degrees(value));
      say(this.#configuration, `u ${text(c.u, axes?.u)}, v ${text(c.v, axes?.v)}`);
    } else {
      say(this.#configuration, `x ${length(c.x, scene.unit)}, y ${length(c.y, scene.unit)}, θ ${degrees(c.theta)}`);
    }
    const outside = kernel && kernel.class !== "lower" ? "outside of the window" : "–";
    say(this.#class, classification ?? outside);
    set(this.#class, { "data-class": classification ?? "" });
    // A configuration in contact bounds the region of the patch it is on.
    const bounds = region === null ? regionOf({ where: state.where, kernel }) : null;
    const pair = this.#session.pair;
    const name = (index: number) => (pair ? regionName(pair, index) : String(index));
    say(this.#region, region !== null ? name(region) : bounds !== null ? `edge of ${name(bounds)}` : "–");
    const known = this.#session.pair?.resolution ?? 0;
    say(this.#nearest, nearest ? `${distanceText(nearest.distance, known, scene.unit)}: ${nearest.fixed} | ${nearest.moving}` : "–");
    if (touching.length === 0) say(this.#touching, "nothing");
    else {
      const lines = touching.slice(0, LISTED).map((t) => html("div", {}, touchText(t, known, scene.unit)));
      if (touching.length > LISTED) lines.push(html("div", {}, `and ${touching.length - LISTED} more`));
      this.#touching.replaceChildren(...lines);
    }
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

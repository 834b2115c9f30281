/** What becomes of two parts on axes where one is pushed alone: contacts move the other, without friction, and nothing else does. */

import type { AxesConfiguration, AxesKernel } from "../kernel/api.js";
import { TURN } from "./placement.js";

/** A push that comes no farther by this share of a turn is held: contacts are known to much less. */
const NO_FARTHER = 1e-9;
/** A push is followed through so many rests, at which the other part is elsewhere; what goes on then is not known. */
const RESTS = 64;

/** A part that is pushed one way. */
export interface Push {
  /** How far it turns (radians); infinite for a whole turn. */
  gone: number;
  /** Where it is held. */
  at: AxesConfiguration;
}

/** Both ways, clockwise first, of a part that turns without limits of its own; null of others, and of what is not known. */
export type Pushes = { back: Push; forth: Push } | null;

/** Of both parts, from a configuration. */
export function pushesOf(kernel: AxesKernel, c: AxesConfiguration): { u: Pushes; v: Pushes } {
  const of = (name: "u" | "v"): Pushes => {
    if (kernel[name].kind !== "angle" || !kernel[name].round) return null;
    const [back, forth] = [-1, 1].map((way) => pushed(kernel, c, name, way));
    return back && forth ? { back, forth } : null;
  };
  return { u: of("u"), v: of("v") };
}

function pushed(kernel: AxesKernel, from: AxesConfiguration, name: "u" | "v", way: number): Push | null {
  const to = from[name] + way * TURN;
  let at = from;
  for (let rests = 0; rests < RESTS; rests += 1) {
    // As near as it comes with the other part as it is then: it may be held by that alone.
    const next = kernel.slide(at, { ...at, [name]: to }).at;
    if (Math.abs(to - next[name]) <= NO_FARTHER * TURN) return { gone: Infinity, at: next };
    if (way * (next[name] - at[name]) <= NO_FARTHER * TURN) return { gone: Math.abs(next[name] - from[name]), at: next };
    at = next;
  }
  return null;
}

/** Which way alone a part turns: which way it is held, and by how much it turns that way. */
export function heldOneWay(pushes: Pushes): { way: "clockwise" | "counter-clockwise"; push: Push } | null {
  if (!pushes || Number.isFinite(pushes.back.gone) === Number.isFinite(pushes.forth.gone)) return null;
  const { back, forth } = pushes;
  return Number.isFinite(back.gone) ? { way: "clockwise", push: back } : { way: "counter-clockwise", push: forth };
}

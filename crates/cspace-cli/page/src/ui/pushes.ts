/** What becomes of two parts on axes where one is pushed alone: the other gives way to contacts without friction, and otherwise stays. */

import type { AxesConfiguration, AxesKernel, Touch } from "../kernel/api.js";
import { TURN } from "./placement.js";

/** A push that comes no farther by this share of a turn is held: contacts are known to much less. */
const NO_FARTHER = 1e-9;
/** A push aims at so much more than a whole turn, that to have come round is beyond doubt. */
const BEYOND = 1.1;
/** A push is followed through so many rests, at which the other part is elsewhere; what goes on then is not known. */
const RESTS = 12;

/** A part that is pushed one way. */
export interface Push {
  /** How far it turns until it meets the other part, and until that holds it (radians); infinite for a whole turn. */
  met: number;
  gone: number;
  /** What holds it. */
  touching: Touch[];
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
  const to = from[name] + way * BEYOND * TURN;
  const gone = (c: AxesConfiguration) => (way * (c[name] - from[name]) >= TURN ? Infinity : way * (c[name] - from[name]));
  const first = kernel.advance(from, { ...from, [name]: to });
  let at = from;
  for (let rests = 0; rests < RESTS; rests += 1) {
    // As near as it comes with the other part as it is then: it may be held by that alone.
    const next = kernel.slide(at, { ...at, [name]: to }).at;
    if (gone(next) === Infinity) return { met: gone(first.at), gone: Infinity, touching: [] };
    if (way * (next[name] - at[name]) <= NO_FARTHER * TURN) {
      const touching = kernel.touching(next);
      const met = first.stopped === null ? null : kernel.patch(first.stopped);
      // What is let go of on the way, such as one pallet of two, and caught by something else, depends on where the other part is then.
      const isHeld = touching.some((t) => t.fixed === met?.fixed && t.moving === met.moving);
      return isHeld ? { met: gone(first.at), gone: gone(next), touching } : null;
    }
    at = next;
  }
  return null;
}

/** Which way alone a part is held. */
export function heldOneWay(pushes: Pushes): { way: "clockwise" | "counter-clockwise"; push: Push } | null {
  if (!pushes || Number.isFinite(pushes.back.gone) === Number.isFinite(pushes.forth.gone)) return null;
  const { back, forth } = pushes;
  return Number.isFinite(back.gone) ? { way: "clockwise", push: back } : { way: "counter-clockwise", push: forth };
}

/** A record that is played, and what it shows at any time. */

import type { Configuration } from "../kernel/api.js";
import { onLeg } from "./legs.js";
import type { Placement } from "./placement.js";

export interface Tick {
  t: number;
  text: string;
}

export type PlayableRecord =
  | { kind: "plan"; name: string; duration: number; ticks: Tick[]; summary: string; about: [number, number]; steps: { t: number; at: Configuration }[] }
  | { kind: "simulation"; name: string; duration: number; ticks: Tick[]; summary: string; parts: string[]; steps: Sample[] };

export interface Sample {
  /** When it is played, in seconds. */
  t: number;
  /** When it was: what goes from one balance to another at once is played in some time. */
  time: number;
  /** Coordinates by the names of parts: a placement, or the motion of a part with one degree of freedom. */
  parts: Map<string, Placement | number>;
}

/** Index of the last step that is not after `t`, and how much of the way to the next has gone. */
function between(steps: readonly { t: number }[], t: number): [number, number] {
  let [lo, hi] = [0, steps.length - 1];
  while (lo < hi) {
    const middle = Math.ceil((lo + hi) / 2);
    if ((steps[middle]?.t ?? Infinity) <= t) lo = middle;
    else hi = middle - 1;
  }
  const [a, b] = [steps[lo]?.t ?? 0, steps[lo + 1]?.t];
  return [lo, b === undefined || b <= a ? 0 : Math.min(1, Math.max(0, (t - a) / (b - a)))];
}

/** The configuration of a planned path at a time. */
export function pathAt(record: PlayableRecord & { kind: "plan" }, t: number): Configuration | null {
  const [i, f] = between(record.steps, t);
  const a = record.steps[i]?.at;
  const b = record.steps[i + 1]?.at ?? a;
  return a && b ? onLeg(a, b, record.about, f) : null;
}

/** The last state of a simulation that is not after a time of its playing: between states nothing is known, and a straight line between two
 * would lead through parts. */
export function stateAt(record: PlayableRecord & { kind: "simulation" }, t: number): Sample | null {
  return record.steps[between(record.steps, t)[0]] ?? null;
}

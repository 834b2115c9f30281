/** A record that is played, and what it shows at any time. */

import type { Configuration } from "../kernel/api.js";
import { gridLines, lineText } from "./grid.js";
import { onLeg } from "./legs.js";
import { lengthStep } from "./numbers.js";
import type { Placement } from "./placement.js";

export interface Tick {
  t: number;
  text: string;
}

export type PlayableRecord =
  | { kind: "plan"; name: string; duration: number; ticks: Tick[]; summary: string; about: [number, number]; steps: { t: number; at: Configuration }[] }
  | { kind: "simulation"; name: string; duration: number; ticks: Tick[]; summary: string; parts: string[]; steps: Sample[]; drives: Load[] };

/** What a drive gives over the time of playing: a torque, or a force. */
export interface Load {
  part: string;
  unit: string;
  times: number[];
  values: number[];
}

export interface Sample {
  /** When it is played, in seconds. */
  t: number;
  /** When it was: what goes from one balance to another at once is played in some time. */
  time: number;
  /** Coordinates by the names of parts: a placement, or the motion of a part with one degree of freedom. */
  parts: Map<string, Placement | number>;
}

/** Index of the last of ascending times that is not after `t`, or of the first. */
export function lastAt(count: number, timeOf: (index: number) => number | undefined, t: number): number {
  let [lo, hi] = [0, count - 1];
  while (lo < hi) {
    const middle = Math.ceil((lo + hi) / 2);
    if ((timeOf(middle) ?? Infinity) <= t) lo = middle;
    else hi = middle - 1;
  }
  return lo;
}

/** Index of the last step that is not after `t`, and how much of the way to the next has gone. */
function between(steps: readonly { t: number }[], t: number): [number, number] {
  const lo = lastAt(steps.length, (i) => steps[i]?.t, t);
  const [a, b] = [steps[lo]?.t ?? 0, steps[lo + 1]?.t];
  return [lo, b === undefined || b <= a ? 0 : Math.min(1, Math.max(0, (t - a) / (b - a)))];
}

/** When a time of the motion is played: what happens at once begins then. */
export function playedAt(steps: readonly Sample[], time: number): number {
  let [lo, hi] = [0, steps.length];
  while (lo < hi) {
    const middle = (lo + hi) >> 1;
    if ((steps[middle]?.time ?? Infinity) < time) lo = middle + 1;
    else hi = middle;
  }
  const [before, at] = [steps[lo - 1], steps[lo]];
  if (at?.time === time) return at.t;
  return time + (before ? before.t - before.time : 0);
}

/** The time of the motion at a time of its playing; a planned path has none, and is told by its playing. */
export function timeAt(record: PlayableRecord, t: number): number {
  if (record.kind === "plan") return t;
  const [i] = between(record.steps, t);
  const [a, b] = [record.steps[i], record.steps[i + 1]];
  return !a || b?.time === a.time ? (a?.time ?? 0) : a.time + Math.max(0, t - a.t);
}

/** From when to when, while it is played, that lasts which happens at once. */
export function stretches(record: PlayableRecord): [number, number][] {
  const all: [number, number][] = [];
  if (record.kind === "plan") return all;
  record.steps.forEach(({ t, time }, i) => {
    const before = record.steps[i - 1];
    if (!before || before.time !== time || before.t === t) return;
    const last = all.at(-1);
    if (last?.[1] === before.t) last[1] = t;
    else all.push([before.t, t]);
  });
  return all;
}

/** About so many numbers are on the axis of time. */
const NUMBERS = 6;

/** The numbers of the axis of time, and when they are played; none of a planned path, which has no times. */
export function timeNumbers(record: PlayableRecord): Tick[] {
  if (record.kind === "plan") return [];
  const [from, to] = [record.steps[0]?.time ?? 0, record.steps.at(-1)?.time ?? 0];
  if (!(to > from)) return [];
  const step = lengthStep((to - from) / NUMBERS);
  return gridLines(from, to, step).map(({ value }) => ({ t: playedAt(record.steps, value), text: lineText(value, step) }));
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

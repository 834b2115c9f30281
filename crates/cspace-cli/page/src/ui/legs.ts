/** Legs between two configurations: how long they are, and what is on the way. */

import type { Configuration } from "../kernel/api.js";
import { apply, rotate } from "./placement.js";

/** How long legs are relative to each other; a radian counts as a unit of length, which only sets the pace. */
export function distance(a: Configuration, b: Configuration): number {
  const [p, q] = [numbersOf(a), numbersOf(b)];
  return Math.hypot(...p.map((x, i) => (q[i] ?? x) - x));
}

export function numbersOf(c: Configuration): number[] {
  return "u" in c ? [c.u, c.v] : [c.x, c.y, c.theta];
}

const mix = (a: number, b: number, f: number) => (f === 0 ? a : a + f * (b - a));

/** The configuration at a share of a leg. The point of the part that legs are about goes straight. */
export function onLeg(a: Configuration, b: Configuration, [x, y]: readonly [number, number], f: number): Configuration | null {
  if ("u" in a && "u" in b) return { u: mix(a.u, b.u, f), v: mix(a.v, b.v, f) };
  if (!("x" in a && "x" in b)) return null;
  const about = { x, y };
  const [from, to] = [apply(a, about), apply(b, about)];
  const theta = mix(a.theta, b.theta, f);
  const arm = rotate(about, theta);
  return { x: mix(from.x, to.x, f) - arm.x, y: mix(from.y, to.y, f) - arm.y, theta };
}

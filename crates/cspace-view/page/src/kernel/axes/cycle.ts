/**
 * Lines, circles and points as one kind of thing, of which nothing is large where a circle is.
 *
 * A cycle has a weight λ and a size ρ: κ and 1 for a circle of curvature κ told by a point s and the normal n there, 1 and r for one told by
 * its centre. Seen from o, with d = s − o, its arm is λ d − n and its moment λ d²/2 − n·d − [n = 0] ρ²/2. Two touch from outside where
 * F = λ₁ m₂ + λ₂ m₁ − a₁·a₂ − ρ₁ ρ₂ vanishes; it is positive where they are apart.
 */

import { add, dot, left, sub, times, type Point } from "../plane.js";
import { movedPoint, movedVector, type AxisMotion } from "./axis-motion.js";
import type { Cycle } from "./data.js";

export function isCentred(c: Cycle): boolean {
  return c.normal.x === 0 && c.normal.y === 0;
}

export function movedCycle(c: Cycle, m: AxisMotion, t: number): Cycle {
  return { through: movedPoint(m, t, c.through), normal: movedVector(m, t, c.normal), weight: c.weight, size: c.size };
}

export function armOf(c: Cycle, from: Point): Point {
  return sub(times(sub(c.through, from), c.weight), c.normal);
}

function ownMoment(c: Cycle): number {
  return isCentred(c) ? -0.5 * c.size * c.size : 0;
}

export function momentOf(c: Cycle, from: Point): number {
  const d = sub(c.through, from);
  return 0.5 * c.weight * dot(d, d) - dot(c.normal, d) + ownMoment(c);
}

export function total(a: Cycle, b: Cycle): number {
  return a.weight * b.size + b.weight * a.size;
}

export function between(a: Cycle, b: Cycle): number {
  const d = sub(b.through, a.through);
  let still: number;
  if (isCentred(a) || isCentred(b)) {
    still = b.weight * ownMoment(a) + a.weight * ownMoment(b) - a.size * b.size;
  } else {
    // 1 + n₁·n₂, without the cancelling.
    const sum = add(a.normal, b.normal);
    still = -0.5 * dot(sum, sum);
  }
  return 0.5 * a.weight * b.weight * dot(d, d) + dot(sub(times(a.normal, b.weight), times(b.normal, a.weight)), d) + still;
}

export function level(a: Cycle, b: Cycle, moments: readonly [number, number]): number {
  return b.weight * moments[0] + a.weight * moments[1] - a.size * b.size;
}

export function room(a: Cycle, b: Cycle, moments: readonly [number, number]): number {
  const skew = b.weight * moments[0] - a.weight * moments[1];
  return 2 * total(a, b) * (moments[0] * b.size + moments[1] * a.size) - skew * skew;
}

export function cycleDistance(a: Cycle, b: Cycle): number {
  const f = between(a, b);
  const k = total(a, b);
  const square = k * k + 2 * a.weight * b.weight * f;
  return (2 * f) / (k + Math.sqrt(Math.max(square, 0)));
}

/** λ₁ λ₂ times the way between the centres, if they have them. */
export function centres(a: Cycle, b: Cycle): Point {
  const way = times(sub(b.through, a.through), a.weight * b.weight);
  return sub(add(way, times(a.normal, b.weight)), times(b.normal, a.weight));
}

/** The derivatives of F by the two motions. */
export function slopes(a: Cycle, first: AxisMotion, b: Cycle, second: AxisMotion): [number, number] {
  const slope = (p: Cycle, q: Cycle, m: AxisMotion): number => {
    switch (m.kind) {
      case "still":
        return 0;
      case "turn":
        return -dot(armOf(p, m.center), left(armOf(q, m.center)));
      case "slide":
        return dot(m.direction, centres(p, q));
    }
  };
  return [slope(b, a, first), slope(a, b, second)];
}

/** F along a direction of the second: half the square of the way times the first, and the second, and the third. */
export function along(a: Cycle, b: Cycle, direction: Point): [number, number, number] {
  return [a.weight * b.weight, dot(direction, centres(a, b)), between(a, b)];
}

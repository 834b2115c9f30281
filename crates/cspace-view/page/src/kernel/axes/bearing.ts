/** The direction of what one part carries, seen from the other part's pivot, without jumps by whole turns. */

import { add, angleOf, cross, dot, left, sub, TAU, times, turnBy, turned, type Point } from "../plane.js";
import { movedPoint, type AxisMotion } from "./axis-motion.js";
import { armOf, isCentred } from "./cycle.js";
import type { Cycle } from "./data.js";

const ORIGIN: Point = { x: 0, y: 0 };

export class Bearing {
  private readonly angle: number;

  private constructor(
    private readonly motion: AxisMotion,
    private readonly point: Point,
    private readonly center: Point,
    private readonly about: Point,
    private readonly turning: boolean,
  ) {
    this.angle = angleOf(about);
  }

  static of(motion: AxisMotion, point: Point, center: Point): Bearing {
    switch (motion.kind) {
      case "still":
        return new Bearing(motion, point, center, sub(point, center), false);
      case "turn": {
        // c₁ − c₂ + R p: the longer of the two never lies a quarter turn or more from their sum.
        const between = sub(motion.center, center);
        const arm = sub(point, motion.center);
        const turning = !(dot(arm, arm) < dot(between, between));
        return new Bearing(motion, point, center, turning ? arm : between, turning);
      }
      case "slide": {
        const side = left(motion.direction);
        const about = dot(side, sub(point, center)) < 0 ? times(side, -1) : side;
        return new Bearing(motion, point, center, about, false);
      }
    }
  }

  /** Arms are as many times smaller than what they stand for as the weight says, and so are ways. */
  static ofArm(motion: AxisMotion, cycle: Cycle, center: Point): Bearing {
    if (isCentred(cycle)) return Bearing.of(motion, cycle.through, center);
    if (motion.kind === "turn") {
      const own = times(sub(motion.center, center), cycle.weight);
      return Bearing.of({ kind: "turn", center: own }, add(own, armOf(cycle, motion.center)), ORIGIN);
    }
    const arm = armOf(cycle, center);
    const slower: AxisMotion =
      motion.kind === "slide" ? { kind: "slide", direction: times(motion.direction, cycle.weight) } : motion;
    // It turns by little: to a quarter turn it is as far as to the centre.
    return new Bearing(slower, arm, ORIGIN, arm, false);
  }

  vector(x: number): Point {
    return sub(movedPoint(this.motion, x, this.point), this.center);
  }

  /** The angle of v at x, and on by the angle of (c, s) on the side of the sign. */
  turned(x: number, v: Point, c: number, size: number, sign: number): number {
    const about = this.turning ? turned(turnBy(x), this.about) : this.about;
    const angle = this.turning ? this.angle + x : this.angle;
    const alongIt = dot(about, v);
    const aside = cross(about, v);
    const s = sign * size;
    const sum = Math.atan2(aside * c + alongIt * s, alongIt * c - aside * s);
    return angle + (sign * sum < -0.5 * Math.PI ? sum + sign * TAU : sum);
  }
}

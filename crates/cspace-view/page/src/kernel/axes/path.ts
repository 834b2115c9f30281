/** A motion of two parts at constant rates on their axes, and contact conditions along it. In the pair's frame. */

import type { Sample } from "../march.js";
import { distance, length, sub, type Point } from "../plane.js";
import { movedPoint, type AxisMotion } from "./axis-motion.js";
import type { Condition } from "./condition.js";

/** x = x₀ + a t and y = y₀ + b t for t from 0 to 1. */
export class AxesPath {
  constructor(
    readonly from: Point,
    readonly by: Point,
  ) {}

  at(t: number): Point {
    return { x: this.from.x + this.by.x * t, y: this.from.y + this.by.y * t };
  }

  sample(condition: Condition, t: number, until: number): Sample {
    const p = this.at(t);
    const [byX, byY] = condition.gradient(p.x, p.y);
    const value = condition.value(p.x, p.y);
    return { value, slope: byX * this.by.x + byY * this.by.y, ...this.bounds(condition, t, until) };
  }

  /** Bounds from the way between a point of each feature, how fast it changes and is bent, and how fast the features turn. */
  private bounds(condition: Condition, t: number, until: number): Omit<Sample, "value" | "slope"> {
    const { first, second } = condition.motions;
    const c = condition.carriers;
    const p = this.at(t);
    const [q1, q2] = pointsOf(c);
    const [a, b] = [Math.abs(this.by.x), Math.abs(this.by.y)];
    const [speed1, speed2] = [a * reach(first, q1), b * reach(second, q2)];
    const speed = speed1 + speed2;
    const [turn1, turn2] = [first.kind === "turn" ? a : 0, second.kind === "turn" ? b : 0];
    const curl = turn1 * speed1 + turn2 * speed2;
    const now = length(sub(movedPoint(second, p.y, q2), movedPoint(first, p.x, q1)));
    const far = now + speed * (until - t);
    const along = (turning: number, arm: number): Omit<Sample, "value" | "slope"> => {
      const bend = curl + 2 * turning * speed + turning * turning * arm;
      return { sinking: bend, rising: bend, speed: speed + turning * arm };
    };
    switch (c.kind) {
      case "first-line":
        return along(turn1, far);
      case "second-line":
        return along(turn2, far);
      case "circles": {
        const least = now - speed * (until - t);
        // The distance of centres bends up only, but for what bends their way; near zero it has an edge.
        const bent = least > 0 ? curl + (speed * speed) / least : Infinity;
        return c.radius > 0 ? { sinking: curl, rising: bent, speed } : { sinking: bent, rising: curl, speed };
      }
      case "cycles": {
        const moved = speed + (turn1 + turn2) * far;
        const { sinking } = along(turn1 + turn2, far);
        const curvature = (w: { weight: number; normal: Point }) => (w.normal.x === 0 && w.normal.y === 0 ? 0 : Math.abs(w.weight));
        const bend = sinking + 2 * moved * moved * (curvature(c.first) + curvature(c.second));
        return { sinking: bend, rising: bend, speed: 2 * moved };
      }
    }
  }
}

function pointsOf(c: Condition["carriers"]): [Point, Point] {
  switch (c.kind) {
    case "first-line":
      return [c.through, c.point];
    case "second-line":
      return [c.point, c.through];
    case "circles":
      return [c.first, c.second];
    case "cycles":
      return [c.first.through, c.second.through];
  }
}

/** How far a point moves per unit of the coordinate. */
function reach(m: AxisMotion, p: Point): number {
  return m.kind === "turn" ? distance(p, m.center) : m.kind === "slide" ? length(m.direction) : 0;
}


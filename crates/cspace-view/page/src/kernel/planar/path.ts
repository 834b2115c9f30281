/** A motion of the moving part at constant rates, and contact functions along it. All in the pair's frame. */

import type { ContactFunctionData, PatchData } from "../../scene.js";
import { gradientOf, turningOf, valueOf } from "../contact-function.js";
import type { Sample } from "../march.js";
import { add, dot, left, length, sub, times, turnBy, turned, type Point } from "../plane.js";

/** p(t) = q + t v + R_θ m, θ(t) = θ₀ + ω t, for t from 0 to 1. */
export class Path {
  constructor(
    readonly q: Point,
    readonly v: Point,
    readonly m: Point,
    readonly theta0: number,
    readonly omega: number,
  ) {}

  theta(t: number): number {
    return this.theta0 + this.omega * t;
  }

  base(t: number): Point {
    return add(this.q, times(this.v, t));
  }

  at(t: number): Point {
    return add(this.base(t), turned(turnBy(this.theta(t)), this.m));
  }

  /** How fast the position moves at t. */
  rate(t: number): Point {
    return add(this.v, times(left(turned(turnBy(this.theta(t)), this.m)), this.omega));
  }

  /** The function of a patch at t, with bounds from there to `until`; `turn` is what the patch's orientations are less. */
  sample(patch: PatchData, t: number, until: number): Sample {
    const f = patch.function;
    const turn = turnBy(this.theta(t));
    const p = add(this.base(t), turned(turn, this.m));
    const { normal, byTheta } = gradientOf(f, p, turn);
    const value = valueOf(f, p, turn);
    const slope = dot(normal, this.rate(t)) + this.omega * byTheta;
    const { bend, speed } = this.bounds(f, t, until, value);
    return { value, slope, bend, speed };
  }

  private bounds(f: ContactFunctionData, t: number, until: number, value: number): { bend: number; speed: number } {
    const w = Math.abs(this.omega);
    const v = length(this.v);
    const spiral = f.kind === "circle" ? f.center : f.through;
    const turning = turningOf(spiral);
    const arm = length(sub(this.m, turning));
    // Of the way from the point that turns with the part to the one that stays: so fast it is at most, and so fast it is bent.
    const speed = v + w * arm;
    const curl = w * w * arm;
    if (f.kind === "fixed-line") return { bend: curl, speed };
    const swing = spiral.swing?.arm ?? { x: 0, y: 0 };
    const from = add(spiral.u, swing);
    const far = length(sub(this.base(t), from)) + v * (until - t);
    if (f.kind === "moving-line") return { bend: w * w * far + 2 * w * v, speed: v + w * far };
    if (f.kind === "circle") {
      const outside = f.radius > 0 && value > 0;
      if (outside) return { bend: curl, speed };
      const way = sub(this.base(t), from);
      const now = length(add(way, turned(turnBy(this.theta(t)), sub(this.m, turning))));
      const least = now - speed * (until - t);
      // Near the centre the distance has an edge.
      return { bend: least > 0 ? curl + (speed * speed) / least : Infinity, speed };
    }
    const moved = f.turns ? v + w * far : speed;
    const straight = f.turns ? w * w * far + 2 * w * v : curl;
    const bent = (2 * moved * moved) / Math.abs(f.radius);
    return { bend: straight + bent, speed: 2 * moved };
  }
}

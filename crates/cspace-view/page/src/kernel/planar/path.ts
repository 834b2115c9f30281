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

  /** What all of the motion may come to. */
  reach(): Reach {
    return new Reach(this);
  }

  /** The function of a patch at t, with bounds from there to `until`; `turn` is what the patch's orientations are less. */
  sample(patch: PatchData, t: number, until: number): Sample {
    const f = patch.function;
    const turn = turnBy(this.theta(t));
    const p = add(this.base(t), turned(turn, this.m));
    const { normal, byTheta } = gradientOf(f, p, turn);
    const value = valueOf(f, p, turn);
    const slope = dot(normal, this.rate(t)) + this.omega * byTheta;
    return { value, slope, ...this.bounds(f, t, until) };
  }

  /** Bounds of how fast a function changes and how it bends from t to `until`: by how fast its points move and turn, and how far they are apart. */
  private bounds(f: ContactFunctionData, t: number, until: number): Omit<Sample, "value" | "slope"> {
    const w = Math.abs(this.omega);
    const v = length(this.v);
    const spiral = f.kind === "circle" ? f.center : f.through;
    const turning = turningOf(spiral);
    const arm = length(sub(this.m, turning));
    // Of the way from the point that turns with the part to the one that stays: so fast it is at most, and so fast it is bent.
    const speed = v + w * arm;
    const curl = w * w * arm;
    if (f.kind === "fixed-line") return both(curl, speed);
    const swing = spiral.swing?.arm ?? { x: 0, y: 0 };
    const from = add(spiral.u, swing);
    const far = length(sub(this.base(t), from)) + v * (until - t);
    if (f.kind === "moving-line") return both(w * w * far + 2 * w * v, v + w * far);
    if (f.kind === "circle") {
      const way = sub(this.base(t), from);
      const now = length(add(way, turned(turnBy(this.theta(t)), sub(this.m, turning))));
      const least = now - speed * (until - t);
      // The distance from a centre bends up only, but for what bends the way; near the centre it has an edge.
      const bent = least > 0 ? curl + (speed * speed) / least : Infinity;
      return f.radius > 0 ? { sinking: curl, rising: bent, speed } : { sinking: bent, rising: curl, speed };
    }
    const moved = f.turns ? v + w * far : speed;
    const straight = f.turns ? w * w * far + 2 * w * v : curl;
    const bent = (2 * moved * moved) / Math.abs(f.radius);
    return both(straight + bent, 2 * moved);
  }
}

function both(bend: number, speed: number): Omit<Sample, "value" | "slope"> {
  return { sinking: bend, rising: bend, speed };
}

/** Which contact functions cannot vanish along a motion, by their values where it begins: without making anything, for there are many. */
class Reach {
  private readonly x: number;
  private readonly y: number;
  private readonly cos: number;
  private readonly sin: number;
  private readonly v: number;
  private readonly w: number;
  private readonly m: number;

  constructor(path: Path) {
    const p = path.at(0);
    const turn = turnBy(path.theta0);
    [this.x, this.y, this.cos, this.sin] = [p.x, p.y, turn.cos, turn.sin];
    [this.v, this.w, this.m] = [length(path.v), Math.abs(path.omega), length(path.m)];
  }

  /** False if it is not known. */
  isAway(f: ContactFunctionData, within: number): boolean {
    if (f.kind === "flat-circle") return false;
    const s = f.kind === "circle" ? f.center : f.through;
    if (s.swing) return false;
    const { cos, sin } = this;
    const dx = this.x - (s.u.x + (cos * s.w.x - sin * s.w.y));
    const dy = this.y - (s.u.y + (sin * s.w.x + cos * s.w.y));
    const arm = this.m + Math.sqrt(s.w.x * s.w.x + s.w.y * s.w.y);
    const moved = this.v + this.w * arm;
    if (f.kind === "circle") return Math.abs(Math.sqrt(dx * dx + dy * dy) - Math.abs(f.radius)) > moved + within;
    const n = f.normal;
    if (f.kind === "fixed-line") return Math.abs(n.x * dx + n.y * dy) > moved + within;
    const value = (cos * n.x - sin * n.y) * dx + (sin * n.x + cos * n.y) * dy;
    // The line turns about what is seen from the moving part: as far as the way to its point, and that grows.
    const far = Math.sqrt(dx * dx + dy * dy) + moved;
    return Math.abs(value) > moved + this.w * far + within;
  }
}

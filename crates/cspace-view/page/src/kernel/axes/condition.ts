/** Contact conditions of two features on their axes: what must vanish where they touch, and y where it does at a given x. */

import { angleOf, cross, distance, dot, length, signum, sub, times, unit, type Point } from "../plane.js";
import { angleAt, movedPoint, movedVector, velocity, type Motions } from "./axis-motion.js";
import { Bearing } from "./bearing.js";
import { along, armOf, centres, cycleDistance, level, momentOf, movedCycle, room, slopes } from "./cycle.js";
import type { CarriersData, Cycle, LineCarrier } from "./data.js";

type Carriers =
  | ({ kind: "first-line" } & LineCarrier)
  | ({ kind: "second-line" } & LineCarrier)
  | { kind: "circles"; first: Point; second: Point; radius: number }
  | { kind: "cycles"; first: Cycle; second: Cycle };

function carriersOf(data: CarriersData): Carriers {
  if ("FirstLine" in data) return { kind: "first-line", ...data.FirstLine };
  if ("SecondLine" in data) return { kind: "second-line", ...data.SecondLine };
  if ("Circles" in data) return { kind: "circles", ...data.Circles };
  return { kind: "cycles", ...data.Cycles };
}

function rootOf(square: number): number {
  return Math.sqrt(Math.max(square, 0));
}

export class Condition {
  readonly carriers: Carriers;
  private readonly bearing: Bearing;
  private readonly angle: number;
  private readonly arm: number;
  private readonly offset: number;

  constructor(
    data: CarriersData,
    readonly motions: Motions,
  ) {
    const c = (this.carriers = carriersOf(data));
    const pivot = motions.second.kind === "turn" ? motions.second.center : { x: 0, y: 0 };
    let carried: Point;
    switch (c.kind) {
      case "first-line": {
        const w = sub(c.point, pivot);
        carried = c.point;
        [this.angle, this.arm, this.offset] = [angleOf(c.normal) - angleOf(w), length(w), 0];
        break;
      }
      case "second-line":
        carried = c.point;
        [this.angle, this.arm, this.offset] = [-angleOf(c.normal), 0, c.radius + dot(c.normal, sub(c.through, pivot))];
        break;
      case "circles": {
        const w = sub(c.second, pivot);
        carried = c.first;
        [this.angle, this.arm, this.offset] = [-angleOf(w), length(w), 0];
        break;
      }
      case "cycles": {
        const arm = armOf(c.second, pivot);
        carried = c.first.through;
        [this.angle, this.arm, this.offset] = [-angleOf(arm), length(arm), momentOf(c.second, pivot)];
        break;
      }
    }
    this.bearing =
      c.kind === "cycles" ? Bearing.ofArm(motions.first, c.first, pivot) : Bearing.of(motions.first, carried, pivot);
  }

  /** How far the features are apart along their normal (length of the frame). */
  value(x: number, y: number): number {
    const { first, second } = this.motions;
    const c = this.carriers;
    switch (c.kind) {
      case "first-line": {
        const n = movedVector(first, x, c.normal);
        return dot(n, sub(movedPoint(second, y, c.point), movedPoint(first, x, c.through))) - c.radius;
      }
      case "second-line": {
        const n = movedVector(second, y, c.normal);
        return dot(n, sub(movedPoint(first, x, c.point), movedPoint(second, y, c.through))) - c.radius;
      }
      case "circles": {
        const apart = distance(movedPoint(second, y, c.second), movedPoint(first, x, c.first));
        return (apart - Math.abs(c.radius)) * signum(c.radius);
      }
      case "cycles":
        return cycleDistance(movedCycle(c.first, first, x), movedCycle(c.second, second, y));
    }
  }

  gradient(x: number, y: number): [number, number] {
    const { first, second } = this.motions;
    const c = this.carriers;
    switch (c.kind) {
      case "first-line": {
        const n = movedVector(first, x, c.normal);
        const q = movedPoint(second, y, c.point);
        return [-dot(n, velocity(first, q)), dot(n, velocity(second, q))];
      }
      case "second-line": {
        const n = movedVector(second, y, c.normal);
        const p = movedPoint(first, x, c.point);
        return [dot(n, velocity(first, p)), -dot(n, velocity(second, p))];
      }
      case "circles": {
        const p = movedPoint(first, x, c.first);
        const q = movedPoint(second, y, c.second);
        const n = times(unit(sub(q, p)), signum(c.radius));
        return [-dot(n, velocity(first, p)), dot(n, velocity(second, q))];
      }
      case "cycles": {
        const a = movedCycle(c.first, first, x);
        const b = movedCycle(c.second, second, y);
        const [byX, byY] = slopes(a, first, b, second);
        const rate = length(centres(a, b));
        return [byX / rate, byY / rate];
      }
    }
  }

  /** y at x on a root: 0 with free space above, 1 below. NaN where the condition does not depend on y. */
  y(x: number, root: number): number {
    const { first, second } = this.motions;
    const c = this.carriers;
    // Root 0 is φ − acos for lines and concave circles, φ + acos for convex ones.
    const sign = root === 0 ? 1 : -1;
    if (second.kind === "still") return NaN;
    if (second.kind === "turn") {
      const pivot = second.center;
      switch (c.kind) {
        case "first-line": {
          const n = movedVector(first, x, c.normal);
          const offset = dot(n, sub(movedPoint(first, x, c.through), pivot)) + c.radius;
          const middle = angleAt(first, x) + this.angle;
          return middle - sign * Math.atan2(rootOf((this.arm - offset) * (this.arm + offset)), offset);
        }
        case "second-line": {
          const v = this.bearing.vector(x);
          const m = length(v);
          return this.angle + this.bearing.turned(x, v, this.offset, rootOf((m - this.offset) * (m + this.offset)), -sign);
        }
        case "circles": {
          const v = this.bearing.vector(x);
          const m = length(v);
          const q = this.arm;
          const r = Math.abs(c.radius);
          // Heron: (2 m q)² − (m² + q² − r²)² = ((m + q)² − r²) (r² − (m − q)²).
          const square = (m + q - r) * (m + q + r) * (r - m + q) * (r + m - q);
          return this.angle + this.bearing.turned(x, v, m * m + (q - r) * (q + r), rootOf(square), sign * signum(c.radius));
        }
        case "cycles": {
          const moments = [momentOf(movedCycle(c.first, first, x), pivot), this.offset] as const;
          const v = this.bearing.vector(x);
          const size = rootOf(room(c.first, c.second, moments));
          return this.angle + this.bearing.turned(x, v, level(c.first, c.second, moments), size, sign);
        }
      }
    }
    const d = second.direction;
    switch (c.kind) {
      case "first-line": {
        const n = movedVector(first, x, c.normal);
        const l = movedPoint(first, x, c.through);
        return (c.radius + dot(n, sub(l, c.point))) / dot(n, d);
      }
      case "second-line": {
        const p = movedPoint(first, x, c.point);
        return (dot(c.normal, sub(p, c.through)) - c.radius) / dot(c.normal, d);
      }
      case "circles": {
        const v = sub(movedPoint(first, x, c.first), c.second);
        const aside = cross(d, v);
        const r = Math.abs(c.radius);
        return dot(d, v) + sign * signum(c.radius) * rootOf((r - aside) * (r + aside));
      }
      case "cycles": {
        const [square, slope, still] = along(movedCycle(c.first, first, x), c.second, d);
        const rate = sign * rootOf(slope * slope - 2 * square * still);
        // Of two forms that are equal the one in which nothing cancels.
        return slope < 0 === rate < 0 ? (-2 * still) / (slope + rate) : (rate - slope) / square;
      }
    }
  }
}

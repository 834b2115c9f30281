/** How a part moves on its axis, in the frame of the pair. */

import { add, left, sub, times, turnBy, turned, type Point } from "../plane.js";
import type { MotionData } from "./data.js";

export type AxisMotion = { kind: "still" } | { kind: "turn"; center: Point } | { kind: "slide"; direction: Point };

export function axisMotion(data: MotionData): AxisMotion {
  if (data === "Still") return { kind: "still" };
  return "Turn" in data ? { kind: "turn", center: data.Turn.center } : { kind: "slide", direction: data.Slide.direction };
}

export interface Motions {
  first: AxisMotion;
  second: AxisMotion;
}

export function movedPoint(m: AxisMotion, t: number, p: Point): Point {
  switch (m.kind) {
    case "still":
      return p;
    case "turn":
      return add(m.center, turned(turnBy(t), sub(p, m.center)));
    case "slide":
      return add(p, times(m.direction, t));
  }
}

export function movedVector(m: AxisMotion, t: number, v: Point): Point {
  return m.kind === "turn" ? turned(turnBy(t), v) : v;
}

export function angleAt(m: AxisMotion, t: number): number {
  return m.kind === "turn" ? t : 0;
}

/** How a place of the part moves per unit of the coordinate. */
export function velocity(m: AxisMotion, p: Point): Point {
  switch (m.kind) {
    case "still":
      return { x: 0, y: 0 };
    case "turn":
      return left(sub(p, m.center));
    case "slide":
      return m.direction;
  }
}

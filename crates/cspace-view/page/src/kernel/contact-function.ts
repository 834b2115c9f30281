/** Contact functions in the pair's frame: zero where two features touch, positive where they are apart. */

import type { ContactFunctionData, SpiralData } from "../scene.js";
import type { Carrier } from "./carrier.js";
import { flatDistance, type FlatArc } from "./flat-arc.js";
import { add, distance, dot, left, length, signum, sub, times, turnBy, turned, unit, type Point, type Turn } from "./plane.js";

/** A point that moves with orientation, p(θ) = u + R_θ w + (1 − R_{θ−rest}) arm. */
export function spiralAt(s: SpiralData, t: Turn): Point {
  const w = turned(t, s.w);
  const p = { x: s.u.x + w.x, y: s.u.y + w.y };
  if (!s.swing || (s.swing.arm.x === 0 && s.swing.arm.y === 0)) return p;
  const { arm, rest } = s.swing;
  // With φ = θ − rest: (1 − cos φ) a − sin φ left(a); 1 − cos φ from the sine, so that it is as exact as that is.
  const st = Math.sin(rest);
  const ct = Math.cos(rest);
  const c = t.cos * ct + t.sin * st;
  const sin = t.sin * ct - t.cos * st;
  const less = (sin * sin) / (1 + c);
  return { x: p.x + (arm.x * less + arm.y * sin), y: p.y + (arm.y * less - arm.x * sin) };
}

/** All of a spiral that turns: it moves by left(R v) per radian. */
export function turningOf(s: SpiralData): Point {
  if (!s.swing || (s.swing.arm.x === 0 && s.swing.arm.y === 0)) return s.w;
  return sub(s.w, turned(turnBy(-s.swing.rest), s.swing.arm));
}

export function carrierOf(f: ContactFunctionData, t: Turn): Carrier {
  switch (f.kind) {
    case "fixed-line":
      return { kind: "line", normal: f.normal, through: spiralAt(f.through, t) };
    case "moving-line":
      return { kind: "line", normal: turned(t, f.normal), through: spiralAt(f.through, t) };
    case "circle":
      return { kind: "circle", center: spiralAt(f.center, t), radius: f.radius };
    case "flat-circle":
      return {
        kind: "flat",
        normal: f.turns ? turned(t, f.normal) : f.normal,
        through: spiralAt(f.through, t),
        curvature: 1 / f.radius,
      };
  }
}

export function valueOf(f: ContactFunctionData, p: Point, t: Turn): number {
  switch (f.kind) {
    case "fixed-line":
      return dot(f.normal, sub(p, spiralAt(f.through, t)));
    case "moving-line":
      return dot(turned(t, f.normal), sub(p, spiralAt(f.through, t)));
    case "circle":
      return (distance(p, spiralAt(f.center, t)) - Math.abs(f.radius)) * signum(f.radius);
    case "flat-circle":
      return flatDistance(carrierOf(f, t) as FlatArc, p);
  }
}

/** The gradient by position, and by orientation at a position that stays in the pair's frame. */
export interface Gradient {
  normal: Point;
  byTheta: number;
}

export function gradientOf(f: ContactFunctionData, p: Point, t: Turn): Gradient {
  switch (f.kind) {
    case "fixed-line":
      return { normal: f.normal, byTheta: -dot(f.normal, left(turned(t, turningOf(f.through)))) };
    case "moving-line": {
      const n = turned(t, f.normal);
      const v = sub(p, spiralAt(f.through, t));
      return { normal: n, byTheta: dot(left(n), v) - dot(n, left(turned(t, turningOf(f.through)))) };
    }
    case "circle": {
      const n = times(unit(sub(p, spiralAt(f.center, t))), signum(f.radius));
      return { normal: n, byTheta: -dot(n, left(turned(t, f.center.w))) };
    }
    case "flat-circle": {
      const axis = f.turns ? turned(t, f.normal) : f.normal;
      const d = sub(p, spiralAt(f.through, t));
      const n = add(axis, times(d, 1 / f.radius));
      const drift = f.turns ? dot(left(axis), d) : 0;
      const byTheta = drift - dot(n, left(turned(t, turningOf(f.through))));
      const size = length(n);
      return { normal: times(n, 1 / size), byTheta: byTheta / size };
    }
  }
}

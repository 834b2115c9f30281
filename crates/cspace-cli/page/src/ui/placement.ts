/** Where a part is in the assembly: q goes to (x, y) + R_θ q. */

import type { Place, SceneMotion } from "../scene.js";

export interface Placement {
  x: number;
  y: number;
  theta: number;
}

export const TURN = 2 * Math.PI;

export const IDENTITY: Placement = { x: 0, y: 0, theta: 0 };

export function rotate(q: Place, theta: number): Place {
  const c = Math.cos(theta);
  const s = Math.sin(theta);
  return { x: c * q.x - s * q.y, y: s * q.x + c * q.y };
}

export function apply(p: Placement, q: Place): Place {
  const r = rotate(q, p.theta);
  return { x: p.x + r.x, y: p.y + r.y };
}

/** First `b`, then `a`. */
export function compose(a: Placement, b: Placement): Placement {
  const at = apply(a, b);
  return { x: at.x, y: at.y, theta: a.theta + b.theta };
}

export function inverse(p: Placement): Placement {
  const at = rotate({ x: -p.x, y: -p.y }, -p.theta);
  return { x: at.x, y: at.y, theta: -p.theta };
}

/** The placement of `b` as seen from `a`. */
export function relative(a: Placement, b: Placement): Placement {
  return compose(inverse(a), b);
}

/** The placement that turns about a point. */
export function turnAbout(center: Place, theta: number): Placement {
  const r = rotate(center, theta);
  return { x: center.x - r.x, y: center.y - r.y, theta };
}

/** Where a part with one degree of freedom is when it has moved by `u`; others stay where they are drawn. */
export function ofMotion(motion: SceneMotion, u: number): Placement {
  switch (motion.type) {
    case "revolute":
      return turnAbout(motion.center, u);
    case "prismatic": {
      const d = unit(motion.direction);
      return { x: u * d.x, y: u * d.y, theta: 0 };
    }
    case "fixed":
    case "planar":
      return IDENTITY;
  }
}

/** The inverse of {@link ofMotion}. */
export function coordinateOf(motion: SceneMotion, p: Placement): number {
  switch (motion.type) {
    case "revolute":
      return p.theta;
    case "prismatic": {
      const d = unit(motion.direction);
      return p.x * d.x + p.y * d.y;
    }
    case "fixed":
    case "planar":
      return 0;
  }
}

export function unit(d: Place): Place {
  const length = Math.hypot(d.x, d.y);
  return length > 0 ? { x: d.x / length, y: d.y / length } : { x: 1, y: 0 };
}

/** The orientation among `theta` + whole turns that lies in [lo, lo + turn). */
export function wrap(theta: number, lo: number): number {
  const turns = Math.floor((theta - lo) / TURN);
  return theta - turns * TURN;
}

/** The shortest turn from one direction to another (radians). */
export function turnBetween(a: Place, b: Place): number {
  return Math.atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/** The shortest turn from one orientation to another, in [−π, π). */
export function shortestTurn(from: number, to: number): number {
  return wrap(to - from, -Math.PI);
}

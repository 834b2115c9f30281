/** Points, vectors and angles of the plane. */

import type { Place } from "../scene.js";

export type Point = Place;

export const TAU = 2 * Math.PI;

/** Rotation by an angle, as its cosine and sine. */
export interface Turn {
  cos: number;
  sin: number;
}

export function turnBy(angle: number): Turn {
  return { cos: Math.cos(angle), sin: Math.sin(angle) };
}

export function turned(t: Turn, v: Point): Point {
  return { x: t.cos * v.x - t.sin * v.y, y: t.sin * v.x + t.cos * v.y };
}

export function add(a: Point, b: Point): Point {
  return { x: a.x + b.x, y: a.y + b.y };
}

export function sub(a: Point, b: Point): Point {
  return { x: a.x - b.x, y: a.y - b.y };
}

export function times(a: Point, s: number): Point {
  return { x: a.x * s, y: a.y * s };
}

export function dot(a: Point, b: Point): number {
  return a.x * b.x + a.y * b.y;
}

/** Signed area spanned with b: positive where b is to the left. */
export function cross(a: Point, b: Point): number {
  return a.x * b.y - a.y * b.x;
}

/** A quarter turn counter-clockwise. */
export function left(a: Point): Point {
  return { x: -a.y, y: a.x };
}

/** A quarter turn clockwise. */
export function right(a: Point): Point {
  return { x: a.y, y: -a.x };
}

export function length(a: Point): number {
  return Math.sqrt(a.x * a.x + a.y * a.y);
}

export function distance(a: Point, b: Point): number {
  const x = a.x - b.x;
  const y = a.y - b.y;
  return Math.sqrt(x * x + y * y);
}

/** In this direction with length one; not finite for the zero vector. */
export function unit(a: Point): Point {
  return times(a, 1 / Math.hypot(a.x, a.y));
}

export function lerp(a: Point, b: Point, s: number): Point {
  return { x: a.x + (b.x - a.x) * s, y: a.y + (b.y - a.y) * s };
}

export function angleOf(a: Point): number {
  return Math.atan2(a.y, a.x);
}

export function fromAngle(angle: number): Point {
  return { x: Math.cos(angle), y: Math.sin(angle) };
}

/** The sign of a number, with 1 for +0 and −1 for −0. */
export function signum(x: number): number {
  return x > 0 || Object.is(x, 0) ? 1 : -1;
}

/** A length with the sign of another number. */
export function withSign(x: number, sign: number): number {
  return Math.abs(x) * signum(sign);
}

/** An angle less whole turns, in [−π, π]. */
export function wrapped(angle: number): number {
  return angle - TAU * roundAway(angle / TAU);
}

/** The nearest whole number; halves go away from zero. */
export function roundAway(x: number): number {
  return signum(x) * Math.floor(Math.abs(x) + 0.5);
}

export function clamp(t: number, lo: number, hi: number): number {
  return t < lo ? lo : t > hi ? hi : t;
}

/** The first index of a sorted list at which a condition no longer holds. */
export function partitionPoint<T>(list: ArrayLike<T>, before: (item: T) => boolean): number {
  let lo = 0;
  let hi = list.length;
  while (lo < hi) {
    const mid = (lo + hi) >> 1;
    if (before(list[mid]!)) lo = mid + 1;
    else hi = mid;
  }
  return lo;
}

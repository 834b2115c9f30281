/** The heights of layers: where in a stack something begins or ends, and what of a part is at one height. */

import type { ScenePart, SceneVertex } from "../scene.js";

/** From one height to another, between which no layer begins or ends. */
export type Interval = readonly [number, number];

/** Heights are sums of thicknesses, which are rounded: what differs by less of the largest is one height. The kernel takes the same measure. */
const ROUNDING = 1.5e-11;

/** The stack of all parts, the lowest first; empty if no part has heights. */
export function intervalsOf(parts: readonly ScenePart[]): Interval[] {
  const all = parts.flatMap(({ layers }) => layers.flatMap(({ z }) => z ?? [])).sort((a, b) => a - b);
  const least = ROUNDING * all.reduce((largest, z) => Math.max(largest, Math.abs(z)), 0);
  const ends = all.filter((z, i) => i === 0 || z - (all[i - 1] ?? z) > least);
  return ends.slice(1).map((hi, i): Interval => [ends[i] ?? hi, hi]);
}

/** The interval of a height, of two that meet there the upper; null if all heights are meant, or the stack does not reach there. */
export function intervalAt(parts: readonly ScenePart[], height: number | null): Interval | null {
  if (height === null) return null;
  return intervalsOf(parts).reverse().find(([lo, hi]) => lo <= height && height <= hi) ?? null;
}

/** The height by which an interval is chosen: as far from its ends as can be. */
export function middleOf([lo, hi]: Interval): number {
  return (lo + hi) / 2;
}

/** Whether a layer from one height to another, or at every height, is in an interval; null are all heights. */
export function isAt(z: Interval | null, at: Interval | null): boolean {
  if (!z || !at) return true;
  const height = middleOf(at);
  return z[0] < height && height < z[1];
}

/** The numbers of the loops that the layers of a part have in an interval. */
export function loopsAt({ layers, loops }: ScenePart, at: Interval | null): number[] {
  return at && layers.length > 0 ? layers.flatMap((layer) => (isAt(layer.z, at) ? layer.loops : [])) : loops.map((_, l) => l);
}

/** Whether features of a loop can touch in an interval. Loops that several layers have alike are one, of the number of the first. */
export function touchesAt(part: ScenePart, loop: number, at: Interval | null): boolean {
  const there = loopsAt(part, at);
  const own = part.loops[loop] ?? [];
  return there.includes(loop) || there.some((l) => isAlike(part.loops[l] ?? [], own));
}

function isAlike(a: readonly SceneVertex[], b: readonly SceneVertex[]): boolean {
  return a.length === b.length && a.every(({ x, y, bulge }, i) => x === b[i]?.x && y === b[i]?.y && bulge === b[i]?.bulge);
}

/** A part as it is in an interval, with the loops it has there. The part itself if these are all. */
export function partAt(part: ScenePart, at: Interval | null): ScenePart {
  const there = loopsAt(part, at);
  return there.length === part.loops.length ? part : { ...part, loops: there.map((l) => part.loops[l] ?? []) };
}

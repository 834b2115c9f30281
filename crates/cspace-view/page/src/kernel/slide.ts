/**
 * A motion that is led by contact: as far as the straight way is free, then along the surface, as near to the goal as it leads.
 *
 * Positions are vectors of weighted coordinates, in which all of them count alike.
 */

export type Vec = readonly number[];

/** A contact function at a position: its value and gradient by the weighted coordinates. */
export interface Constraint {
  value: number;
  gradient: number[];
}

export interface Ground {
  /** The straight way from one position to another up to the first contact; not yet tested for whether it is blocked there. */
  advance(from: Vec, to: Vec): { at: Vec; stopped: number | null };
  /** The patches that touch at a position. */
  touching(at: Vec): number[];
  constraint(patch: number, at: Vec): Constraint;
  isBlocked(at: Vec): boolean;
  /** Positions nearer to a contact than this are in contact. */
  readonly contact: number;
  /** A step along the surface is no longer than this. */
  readonly longest: number;
}

/** So many steps along the surface are one motion of the pointer. */
const MOST_STEPS = 32;
/** A step that leads nowhere is tried again half as long, so often. */
const HALVINGS = 10;
/** A goal nearer than this share of the way is reached. */
const REACHED = 1e-4;

export function slideOn(ground: Ground, from: Vec, to: Vec): { at: Vec; stopped: number | null } {
  const first = ground.advance(from, to);
  let { at } = first;
  let stopped = first.stopped;
  if (stopped === null) return first;
  const whole = size(minus(to, from));
  for (let k = 0; k < MOST_STEPS && stopped !== null; k++) {
    const left = minus(to, at);
    if (size(left) <= REACHED * whole) break;
    const patches = new Set(ground.touching(at));
    patches.add(stopped);
    const touching = [...patches].map((patch) => ({ patch, ...ground.constraint(patch, at) })).filter((c) => c.gradient.every(Number.isFinite));
    const way = projected(left, touching.map((c) => c.gradient));
    const length = size(way);
    if (length <= Math.max(REACHED * whole, 4 * ground.contact)) break;
    const step = times(way, Math.min(1, ground.longest / length));
    const next = along(ground, at, step, touching);
    if (!next || size(minus(to, next)) >= size(left) - 1e-3 * ground.contact) break;
    const on = ground.advance(next, to);
    if (ground.isBlocked(on.at)) return { at: next, stopped };
    [at, stopped] = [on.at, on.stopped];
  }
  return { at, stopped };
}

interface Touching extends Constraint {
  patch: number;
}

/** A step along the surface, or a part of it; null if none is possible. */
function along(ground: Ground, at: Vec, whole: Vec, touching: Touching[]): Vec | null {
  let step = whole;
  for (let k = 0; k < HALVINGS; k++, step = times(step, 0.5)) {
    const length = size(step);
    // The contacts that the step follows; from others it leads away.
    const followed = touching.filter((c) => dot(c.gradient, step) <= 1e-6 * length * size(c.gradient)).map((c) => c.patch);
    const goal = onSurface(ground, plus(at, step), followed);
    if (!goal || size(minus(goal, plus(at, step))) > 2 * length) continue;
    const next = over(ground, at, goal, followed);
    if (size(minus(next, at)) >= 0.05 * length && dot(minus(next, at), step) > 0 && !ground.isBlocked(next)) return next;
  }
  return null;
}

/** From one place on the surface to another, lifted off it by as much as the surface rises between. */
function over(ground: Ground, at: Vec, goal: Vec, followed: number[]): Vec {
  const middle = times(plus(at, goal), 0.5);
  let lift = 2 * ground.contact;
  let up: number[] = at.map(() => 0);
  for (const patch of followed) {
    const { value, gradient } = ground.constraint(patch, middle);
    const steep = size(gradient);
    lift = Math.max(lift, (-1.5 * value) / steep + 2 * ground.contact);
    up = plus(up, times(gradient, 1 / steep));
  }
  const height = size(up);
  const by = height > 1e-3 ? times(up, lift / height) : up;
  const raised = ground.advance(at, plus(at, by)).at;
  const across = ground.advance(raised, plus(goal, minus(raised, at))).at;
  const down = onSurface(ground, across, followed) ?? goal;
  return ground.advance(across, down).at;
}

/** The nearest place at which the contact functions of some patches vanish, by Newton's method; null if it does not come to one. */
function onSurface(ground: Ground, from: Vec, patches: number[]): Vec | null {
  let at = from;
  for (let k = 0; k < 12; k++) {
    const all = patches.map((patch) => ground.constraint(patch, at));
    if (all.every((c) => Math.abs(c.value) <= 0.05 * ground.contact)) return at;
    const by = leastTo(all.map((c) => c.gradient), all.map((c) => -c.value));
    if (!by || !by.every(Number.isFinite)) return null;
    at = plus(at, by);
  }
  return null;
}

/** The shortest vector that has given products with some others; null if there is none. */
function leastTo(rows: number[][], values: number[]): number[] | null {
  const n = rows.length;
  if (n === 0) return null;
  const matrix = rows.map((a, i) => [...rows.map((b, j) => dot(a, b) * (i === j ? 1 + 1e-13 : 1)), values[i]!]);
  for (let i = 0; i < n; i++) {
    const pivot = matrix.slice(i).reduce((best, row, k) => (Math.abs(row[i]!) > Math.abs(matrix[best]![i]!) ? i + k : best), i);
    [matrix[i], matrix[pivot]] = [matrix[pivot]!, matrix[i]!];
    const row = matrix[i]!;
    if (Math.abs(row[i]!) < 1e-300) return null;
    for (let k = i + 1; k < n; k++) {
      const share = matrix[k]![i]! / row[i]!;
      for (let j = i; j <= n; j++) matrix[k]![j]! -= share * row[j]!;
    }
  }
  const weights = new Array<number>(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    const row = matrix[i]!;
    let sum = row[n]!;
    for (let j = i + 1; j < n; j++) sum -= row[j]! * weights[j]!;
    weights[i] = sum / row[i]!;
  }
  return rows[0]!.map((_, c) => rows.reduce((sum, row, i) => sum + weights[i]! * row[c]!, 0));
}

/** What is left of a way that may not lead against any of some gradients: the nearest such vector, by the pairs of them that hold. */
function projected(way: number[], gradients: number[][]): number[] {
  const units = gradients.map((g) => times(g, 1 / size(g)));
  const allowed = (v: Vec) => units.every((g) => dot(g, v) >= -1e-9 * size(way));
  if (allowed(way)) return way;
  let best: number[] = way.map(() => 0);
  const consider = (held: number[][]) => {
    const by = leastTo(held, held.map((g) => -dot(g, way)));
    if (!by) return;
    const v = plus(way, by);
    if (allowed(v) && dot(v, way) > dot(best, way)) best = v;
  };
  units.forEach((a, i) => {
    consider([a]);
    for (let j = i + 1; j < units.length; j++) {
      // Two that are all but one, or oppose each other, hold as one of them does.
      if (Math.abs(dot(a, units[j]!)) < 1 - 1e-12) consider([a, units[j]!]);
    }
  });
  return best;
}

export function plus(a: Vec, b: Vec): number[] {
  return a.map((x, i) => x + b[i]!);
}

export function minus(a: Vec, b: Vec): number[] {
  return a.map((x, i) => x - b[i]!);
}

export function times(a: Vec, s: number): number[] {
  return a.map((x) => x * s);
}

export function dot(a: Vec, b: Vec): number {
  return a.reduce((sum, x, i) => sum + x * b[i]!, 0);
}

export function size(a: Vec): number {
  return Math.sqrt(dot(a, a));
}

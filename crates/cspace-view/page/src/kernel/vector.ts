/** Vectors of as many coordinates as a motion has. */

import { DEPENDENT } from "./tolerance.js";

export type Vec = readonly number[];

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
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i]! * b[i]!;
  return sum;
}

export function size(a: Vec): number {
  return Math.sqrt(dot(a, a));
}

/**
 * How much of each of some vectors makes the shortest sum that has given products with them; null if they depend on each other, or all but
 * do, so that it is not known.
 */
export function weightsOf(rows: readonly Vec[], values: Vec): number[] | null {
  const n = rows.length;
  const matrix = rows.map((a, i) => [...rows.map((b) => dot(a, b)), values[i]!]);
  // No pivoting: the products of vectors with each other are positive definite.
  for (let i = 0; i < n; i++) {
    const row = matrix[i]!;
    if (!(row[i]! > DEPENDENT * dot(rows[i]!, rows[i]!))) return null;
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
  return weights;
}

export function weighted(rows: readonly Vec[], weights: Vec, from: Vec): number[] {
  return from.map((x, c) => rows.reduce((sum, row, i) => sum + weights[i]! * row[c]!, x));
}

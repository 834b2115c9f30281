/** A contact patch as triangles: at each orientation it is an arc or a segment between its two boundary curves. */

import type { PatchData } from "../../scene.js";
import { gradientOf } from "../contact-function.js";
import { curvePoint } from "../curve.js";
import { distance, dot, left, lerp, turnBy, turned, type Point } from "../plane.js";
import type { Surface } from "./surface.js";

/** So many rows or columns of a patch are as many as a picture needs. */
const MOST = 64;
/** However small an arc is, a column turns by no more than this (radians): its light is to look round. */
const WIDEST = 1;
/** Rows are halved at most so often. */
const HALVINGS = 6;

interface Row {
  theta: number;
  at(s: number): Point;
  start: Point;
  end: Point;
  sweep: number;
}

export function patchSurface(
  surface: Surface,
  patch: PatchData,
  deviation: number,
  perRadian: number,
): { positions: Float32Array; normals: Float32Array; indices: Uint32Array } {
  const row = (theta: number): Row => {
    const { curve, start, end } = surface.curve(patch, theta);
    const sweep = curve.kind === "arc" ? curve.sweep : 0;
    return { theta, start, end, sweep, at: (s) => (s <= 0 ? start : s >= 1 ? end : curvePoint(curve, s)) };
  };
  const rows = rowsOf(row, patch.lo, patch.hi, deviation);
  const columns = columnsOf(rows, deviation);
  const positions = new Float32Array(3 * rows.length * (columns + 1));
  const normals = new Float32Array(positions.length);
  let k = 0;
  for (const r of rows) {
    const turn = turnBy(r.theta);
    for (let j = 0; j <= columns; j++, k += 3) {
      const p = r.at(j / columns);
      positions[k] = p.x;
      positions[k + 1] = p.y;
      positions[k + 2] = r.theta;
      const g = gradientOf(patch.function, surface.inner(p, turn), turn);
      const drift = dot(g.normal, left(turned(turn, surface.space.frame.moving_center)));
      const byTheta = (surface.outerLength(g.byTheta) + drift) / perRadian;
      const size = Math.hypot(g.normal.x, g.normal.y, byTheta);
      normals[k] = g.normal.x / size;
      normals[k + 1] = g.normal.y / size;
      normals[k + 2] = byTheta / size;
    }
  }
  const indices = new Uint32Array(6 * (rows.length - 1) * columns);
  let i = 0;
  for (let r = 0; r + 1 < rows.length; r++) {
    for (let j = 0; j < columns; j++) {
      const a = r * (columns + 1) + j;
      const c = a + columns + 1;
      // Travel × θ points to the right of travel, where free space is.
      indices.set([a, a + 1, c, a + 1, c + 1, c], i);
      i += 6;
    }
  }
  return { positions, normals, indices };
}

/** Orientations between which the patch is straight but for a deviation: where three points of it are. */
function rowsOf(row: (theta: number) => Row, lo: number, hi: number, deviation: number): Row[] {
  const rows: Row[] = [];
  const straight = (a: Row, m: Row, b: Row): boolean =>
    [0, 0.5, 1].every((s) => distance(lerp(a.at(s), b.at(s), 0.5), m.at(s)) <= deviation);
  const halve = (a: Row, b: Row, halvings: number): void => {
    const m = row(0.5 * (a.theta + b.theta));
    // The first halving is made at all events: a curve may swing out and back.
    if (halvings > 0 && (halvings === HALVINGS || !straight(a, m, b))) {
      halve(a, m, halvings - 1);
      halve(m, b, halvings - 1);
    } else {
      rows.push(b);
    }
  };
  const first = row(lo);
  rows.push(first);
  halve(first, row(hi), HALVINGS);
  return rows;
}

/** Columns that keep all rows within a deviation of their arcs. */
function columnsOf(rows: Row[], deviation: number): number {
  let most = 1;
  for (const r of rows) {
    const rise = distance(lerp(r.start, r.end, 0.5), r.at(0.5));
    if (rise > deviation) most = Math.max(most, Math.ceil(Math.sqrt(rise / deviation)));
    most = Math.max(most, Math.ceil(Math.abs(r.sweep) / WIDEST));
  }
  return Math.min(MOST, most);
}

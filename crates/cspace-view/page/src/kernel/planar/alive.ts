/** Which patches may exist at an orientation, without a look at each of them. */

import type { PatchData, PlanarSpace } from "../../scene.js";
import { clamp, TAU } from "../plane.js";

/** Patches are listed where they begin and end by so much more (radians): more than what rounding does to orientations. */
const SLACK = 1e-9;

/** Orientations farther from zero than this (radians, some hundred turns) are rounded by more than what the slack is for. */
const FARTHEST_ORIENTATION = 1024;

/** Equal intervals of orientation, as long as patches are in the mean, with the patches that come to each in ascending order. */
export class Alive {
  private readonly lo: number;
  private readonly hi: number;
  private readonly fullTurn: boolean;
  private readonly density: number;
  private readonly lists: number[][];
  private readonly all: number[];
  private found: Uint8Array | null = null;

  constructor(window: PlanarSpace["window"], patches: readonly PatchData[]) {
    this.fullTurn = window.full_turn;
    [this.lo, this.hi] = window.full_turn ? [-Math.PI, Math.PI] : [window.lo, window.hi];
    const span = this.hi - this.lo;
    const lengths = patches.reduce((sum, p) => sum + (p.hi - p.lo), 0);
    const most = Math.max(patches.length, 1);
    const count = span > 0 && lengths > 0 ? Math.floor(clamp((most * span) / lengths, 1, most)) : 1;
    this.density = span > 0 ? count / span : 0;
    this.lists = Array.from({ length: count }, () => []);
    this.all = patches.map((_, i) => i);
    patches.forEach((p, i) => {
      for (const place of this.places(p.lo, p.hi)) this.lists[place]!.push(i);
    });
  }

  /** The intervals that orientations from lo to hi come to, each once. */
  private places(lo: number, hi: number): number[] {
    const place = (theta: number) => Math.floor((theta - this.lo) * this.density);
    const count = this.lists.length;
    let first = place(lo - SLACK);
    let last = place(hi + SLACK);
    if (this.fullTurn) {
      last = Math.min(last, first + count - 1);
    } else {
      first = clamp(first, 0, count - 1);
      last = clamp(last, 0, count - 1);
    }
    const found: number[] = [];
    for (let k = first; k <= last; k++) found.push(((k % count) + count) % count);
    return found;
  }

  /** Patches among which are all that exist at an orientation, in ascending order. */
  at(theta: number): readonly number[] {
    let from = theta - this.lo;
    if (this.fullTurn && Math.abs(theta) <= FARTHEST_ORIENTATION) {
      from -= TAU * Math.floor(from / TAU);
    } else if (this.fullTurn || theta < this.lo || theta > this.hi) {
      return this.all;
    }
    const place = Math.floor(from * this.density);
    return this.lists[Math.min(place, this.lists.length - 1)]!;
  }

  /** Patches among which are all that exist at some orientation between two, in ascending order. */
  between(lo: number, hi: number): readonly number[] {
    if (Math.max(Math.abs(lo), Math.abs(hi)) > FARTHEST_ORIENTATION) return this.all;
    const places = this.places(lo, hi);
    if (places.length === 1) return this.lists[places[0]!]!;
    const found: number[] = [];
    this.found ??= new Uint8Array(this.all.length);
    const marks = this.found;
    for (const place of places) {
      for (const i of this.lists[place]!) {
        if (marks[i]) continue;
        marks[i] = 1;
        found.push(i);
      }
    }
    for (const i of found) marks[i] = 0;
    return found.sort((a, b) => a - b);
  }
}

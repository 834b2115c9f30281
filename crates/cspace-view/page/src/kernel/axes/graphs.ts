/** Contact curves as monotone graphs y(x), and the free gaps between them. */

import { clamp, partitionPoint, TAU } from "../plane.js";
import { axisMotion, type Motions } from "./axis-motion.js";
import { Condition } from "./condition.js";
import type { AxesSpaceData, BandData, CellData, GapData, PieceData } from "./data.js";
import { Extent, type Range } from "./extent.js";

export class Graphs {
  readonly motions: Motions;
  readonly x: Extent;
  readonly y: Extent;
  private readonly conditions: Condition[];

  constructor(private readonly space: AxesSpaceData) {
    this.motions = { first: axisMotion(space.motions.first), second: axisMotion(space.motions.second) };
    this.x = new Extent(space.x);
    this.y = new Extent(space.y);
    this.conditions = space.pairs.map((p) => new Condition(p[2], this.motions));
  }

  cell(i: number): CellData {
    return this.space.cells[i]!;
  }

  piece(cell: number): PieceData {
    return this.space.pieces[this.cell(cell).piece]!;
  }

  condition(cell: number): Condition {
    return this.conditions[this.piece(cell).pair]!;
  }

  /** y of a piece at x. */
  yOf(p: PieceData, x: number): number {
    for (const end of [p.start, p.end]) if (x === end.x) return end.base + TAU * end.turns;
    return this.conditions[p.pair]!.y(x, p.root) + TAU * p.turns;
  }

  /** Where a cell is along x and along y. */
  box(cell: number): { x: Range; y: Range } {
    const c = this.cell(cell);
    const p = this.piece(cell);
    if (p.vertical) return { x: [p.start.x, p.start.x], y: [c.from, c.to] };
    const a = this.yOf(p, c.from);
    const b = this.yOf(p, c.to);
    return { x: [c.from, c.to], y: [Math.min(a, b), Math.max(a, b)] };
  }

  /** y of a cell at an x within it, or just beyond. */
  at(cell: number, x: number): number {
    const c = this.cell(cell);
    return this.yOf(this.piece(cell), clamp(x, c.from, c.to));
  }

  /** From and to of a gap at x of its band. */
  interval(gap: GapData, x: number): [number, number] {
    const from = gap.lower === null ? this.y.lo : this.at(gap.lower, x) + TAU * gap.turns[0];
    const to = gap.upper === null ? this.y.hi : this.at(gap.upper, x) + TAU * gap.turns[1];
    return [from, Math.max(to, from)];
  }

  /** Beyond what is computed nothing touches. */
  isBeyond(x: number, y: number): boolean {
    const within = (t: number, e: Extent) => e.lo <= t && t <= e.hi;
    return !(this.y.isCircle || (within(x, this.x) && within(y, this.y)));
  }

  /** The region of the free gap that holds a configuration; null if none does. */
  region(x: number, y: number): number | null {
    if (this.isBeyond(x, y)) return null;
    const { bands } = this.space;
    const band = bands[partitionPoint(bands, (b) => b.hi < x)] ?? bands[bands.length - 1];
    return band ? this.regionIn(band, x, y) : null;
  }

  private regionIn(band: BandData, x: number, y: number): number | null {
    for (let i = band.gaps.start; i < band.gaps.end; i++) {
      const gap = this.space.gaps[i]!;
      const [from, to] = this.interval(gap, x);
      const held = this.y.isCircle ? y + TAU * Math.ceil((from - y) / TAU) <= to : from <= y && y <= to;
      if (held) return gap.region;
    }
    return null;
  }
}

/** The nearest contact, one part being moved and the other held. */

import { clamp, TAU } from "../plane.js";
import type { AxesSpaceData } from "./data.js";
import type { Extent, Range } from "./extent.js";
import type { Graphs } from "./graphs.js";
import type { PlaneMap } from "./plane-map.js";
import { Slots } from "./slots.js";
import { NEAR } from "./tolerance.js";

/** Rounds of a bisection that leave nothing to halve. */
const MOST_ROUNDS = 200;
const SLOTS = 256;

export class Nearest {
  private byY: Slots | null = null;

  constructor(
    private readonly space: AxesSpaceData,
    private readonly graphs: Graphs,
    private readonly map: PlaneMap,
    private readonly byX: Slots,
  ) {}

  /** The patch that the moving part meets first, if it can move, or else the fixed one; null where nothing is met. */
  find(u: number, v: number): { patch: number; distance: number } | null {
    const p = this.map.placed(u, v);
    if (!p) return null;
    const { first, second } = this.graphs.motions;
    const swapped = this.map.isSwapped;
    const movesV = (swapped ? first : second).kind !== "still";
    const movesY = movesV !== swapped;
    const { oneLine } = this.map;
    // On one line only y less so many x counts: moving x moves that the other way.
    const rate = oneLine !== null && !movesY ? -oneLine : 1;
    const alongY = movesY || oneLine !== null;
    const [held, moved] = alongY ? [p.x, p.y] : [p.y, p.x];
    const extent = alongY ? this.graphs.y : this.graphs.x;
    const unit = movesY ? this.space.map.y_unit : this.space.map.x_unit;
    let found: { patch: number; distance: number } | null = null;
    for (const i of this.slots(alongY).near(held, NEAR)) {
      const b = this.space.branches[i]!;
      const t = this.beside(b.cell, held, moved, alongY);
      if (t === null) continue;
      const away = Math.abs((extent.apart(t, moved) / rate) * unit);
      if (!found || away < found.distance || (away === found.distance && b.patch < found.patch)) {
        found = { patch: b.patch, distance: away };
      }
    }
    return found;
  }

  private slots(byX: boolean): Slots {
    if (byX) return this.byX;
    return (this.byY ??= new Slots(this.graphs.y, SLOTS, this.space.branches.map((b) => this.graphs.box(b.cell).y)));
  }

  /** The value of the moved coordinate, nearest to the given, at which a cell has the held one. */
  private beside(cell: number, held: number, moved: number, alongY: boolean): number | null {
    const { graphs } = this;
    const box = graphs.box(cell);
    const piece = graphs.piece(cell);
    const [across, acrossExtent] = alongY ? ([box.x, graphs.x] as const) : ([box.y, graphs.y] as const);
    const [way, wayExtent] = alongY ? ([box.y, graphs.y] as const) : ([box.x, graphs.x] as const);
    const brought = acrossExtent.brought(held, across, NEAR);
    if (brought === null) return null;
    const s = clamp(brought, across[0], across[1]);
    // It stays while the other coordinate moves: the nearest of all that it has.
    if (across[1] - across[0] <= NEAR) return nearestOf(way, moved, wayExtent);
    if (alongY) return graphs.yOf(piece, s);
    return piece.vertical ? piece.start.x : this.crossingOfLevel(cell, s);
  }

  private crossingOfLevel(cell: number, level: number): number {
    const piece = this.graphs.piece(cell);
    const c = this.graphs.cell(cell);
    let [lo, hi] = [c.from, c.to];
    const y = (end: { base: number; turns: number }) => end.base + TAU * end.turns;
    const rising = y(piece.start) < y(piece.end);
    for (let k = 0; k < MOST_ROUNDS; k++) {
      const middle = 0.5 * (lo + hi);
      if (middle <= lo || middle >= hi) break;
      if (this.graphs.yOf(piece, middle) < level === rising) lo = middle;
      else hi = middle;
    }
    return 0.5 * (lo + hi);
  }
}

/** The value of a range that is nearest to the given. */
function nearestOf([lo, hi]: Range, t: number, extent: Extent): number {
  if (!extent.isCircle) return clamp(t, lo, hi);
  const brought = lo + (t - lo) - TAU * Math.floor((t - lo) / TAU);
  if (brought <= hi) return brought;
  return Math.abs(extent.apart(t, lo)) < Math.abs(extent.apart(t, hi)) ? lo : hi;
}

/** The configuration space of two parts on their axes, as the page asks it. */

import type { AxesConfiguration, AxesKernel, AxisInfo, Classification, DrawnCurve, FreePolygon, Motion, PatchInfo, Touch } from "../api.js";
import type { PairClass, ScenePair } from "../../scene.js";
import { Features, patchKind, place, rotate, touchingAt } from "../features.js";
import { Overlap } from "../overlap.js";
import { GROWTH, MOVING_GROWTH } from "../tolerance.js";
import { AxesClassifier } from "./classify.js";
import type { AxesSpaceData } from "./data.js";
import { drawCurves, drawFree } from "./draw.js";
import { Graphs } from "./graphs.js";
import { AxesMotion } from "./motion.js";
import { PlaneMap } from "./plane-map.js";

/** The nearest contact is looked for within this share of the parts' size first, and then so many times as far. */
const NEAREST = 2 ** -12;
const FARTHER = 2;

export class AxesPair implements AxesKernel {
  readonly coordinates = "axes";
  readonly class: PairClass;
  readonly patchCount: number;
  readonly u: AxisInfo;
  readonly v: AxisInfo;
  private readonly graphs: Graphs;
  private readonly map: PlaneMap;
  private readonly classifier: AxesClassifier;
  private readonly motions: AxesMotion;
  private readonly fixed: Features;
  private readonly moving: Features;
  private overlapTest: Overlap | null = null;

  constructor(
    private readonly pair: ScenePair,
    private readonly space: AxesSpaceData,
    names: { fixed: Record<string, string>; moving: Record<string, string> },
  ) {
    this.class = pair.class;
    this.patchCount = space.patches.length;
    this.graphs = new Graphs(space);
    this.map = new PlaneMap(space, this.graphs);
    this.fixed = new Features(space.fixed, names.fixed);
    this.moving = new Features(space.moving, names.moving);
    const grown = (GROWTH + MOVING_GROWTH) / space.map.frame.scale;
    const overlap = () => (this.overlapTest ??= new Overlap(space.fixed, space.moving, grown));
    this.classifier = new AxesClassifier(space, this.graphs, this.map, overlap, pair.contact_distance);
    this.motions = new AxesMotion(space, this.graphs, this.map, this.classifier, pair.contact_distance);
    [this.u, this.v] = this.axes();
  }

  private axes(): [AxisInfo, AxisInfo] {
    const { x, y, motions } = this.graphs;
    const lo = this.map.outer(x.lo, y.lo);
    const hi = this.map.outer(x.hi, y.hi);
    const kinds = { still: "still", turn: "angle", slide: "length" } as const;
    const info = (kind: keyof typeof kinds, from: number, to: number, round: boolean): AxisInfo => ({
      kind: kinds[kind],
      lo: Math.min(from, to),
      hi: Math.max(from, to),
      round,
    });
    const swapped = this.map.isSwapped;
    const ofU = swapped ? { m: motions.second, e: y } : { m: motions.first, e: x };
    const ofV = swapped ? { m: motions.first, e: x } : { m: motions.second, e: y };
    return [info(ofU.m.kind, lo.u, hi.u, ofU.e.isCircle), info(ofV.m.kind, lo.v, hi.v, ofV.e.isCircle)];
  }

  private patchAt(index: number) {
    const p = this.space.patches[index];
    if (!p) throw new RangeError(`there is no patch ${index}: the last is ${this.patchCount - 1}`);
    return p;
  }

  patch(index: number): PatchInfo {
    const p = this.patchAt(index);
    return {
      fixed: this.fixed.text(p.fixed),
      moving: this.moving.text(p.moving),
      kind: patchKind(p.fixed, p.moving),
      region: p.region,
      orientations: null,
    };
  }

  classify(c: AxesConfiguration): Classification | null {
    return this.classifier.classify(c.u, c.v);
  }

  region(c: AxesConfiguration): number | null {
    if (this.classify(c) !== "free") return null;
    return this.space.free_regions.length === 1 ? 0 : this.classifier.region(c.u, c.v);
  }

  touching(c: AxesConfiguration, within = this.pair.resolution): Touch[] {
    const found = new Map<string, Touch>();
    for (const [patch] of this.classifier.contacts(c.u, c.v, within)) {
      const touch = this.touch(patch, c);
      const key = `${touch.fixed}|${touch.moving}`;
      if (!found.has(key)) found.set(key, touch);
    }
    return [...found.values()];
  }

  /** By how far the features are apart, as `cspace contacts` has it, of those that the least motion brings together. */
  nearest(c: AxesConfiguration): Touch | null {
    const most = this.fixed.size + this.moving.size;
    for (let within = NEAREST * most; within <= most; within *= FARTHER) {
      // What is free is on the free side of the nearest.
      const first = this.classifier.contacts(c.u, c.v, within).find(([, distance]) => distance >= -this.pair.contact_distance);
      if (first) return this.touch(first[0], c);
    }
    return null;
  }

  private touch(patch: number, c: AxesConfiguration): Touch {
    const p = this.patchAt(patch);
    const { fixed, relative } = this.map.placements(c.u, c.v);
    const t = touchingAt(this.fixed.circle(p.fixed), this.moving.circle(p.moving), relative);
    const at = place(fixed, t.onFixed);
    const normal = rotate(fixed, t.normal);
    return {
      patch,
      fixed: this.fixed.text(p.fixed),
      moving: this.moving.text(p.moving),
      distance: t.gap,
      at: [at.x, at.y],
      normal: [normal.x, normal.y],
    };
  }

  curves(deviation: number): DrawnCurve[] {
    return drawCurves(this.space, this.graphs, this.map, deviation);
  }

  free(deviation: number): FreePolygon[] {
    return drawFree(this.space, this.graphs, this.map, deviation);
  }

  advance(from: AxesConfiguration, to: AxesConfiguration): Motion<AxesConfiguration> {
    return this.motions.advance(from, to);
  }

  slide(from: AxesConfiguration, to: AxesConfiguration): Motion<AxesConfiguration> {
    return this.motions.slide(from, to);
  }
}

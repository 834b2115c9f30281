/** The configuration space of two parts on their axes, as the page asks it. */

import type { AxesConfiguration, AxesKernel, AxisInfo, Classification, DrawnCurve, FreePolygon, Motion, PatchInfo, Touch } from "../api.js";
import type { PairClass, ScenePair } from "../../scene.js";
import { Features, patchKind, place, rotate, type Placement } from "../features.js";
import { NearFeatures } from "../near.js";
import { Overlap } from "../overlap.js";
import type { Point } from "../plane.js";
import { GROWTH, MOVING_GROWTH } from "../tolerance.js";
import { AxesClassifier } from "./classify.js";
import type { AxesSpaceData } from "./data.js";
import { drawCurves, drawFree } from "./draw.js";
import { Graphs } from "./graphs.js";
import { AxesMotion } from "./motion.js";
import { PlaneMap } from "./plane-map.js";

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
  private readonly features: NearFeatures;
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
    this.fixed = new Features(space.fixed, space.map.frame.fixed_center, names.fixed);
    this.moving = new Features(space.moving, space.map.frame.moving_center, names.moving);
    this.features = new NearFeatures(this.fixed, this.moving, space.map.frame, pair.resolution);
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
    const found = this.classify(c);
    if (!found) return [];
    const { fixed, relative } = this.map.placements(c.u, c.v);
    return this.features.at(relative, within, found).map((t) => placedTouch(fixed, t));
  }

  nearest(c: AxesConfiguration): Touch | null {
    const found = this.classify(c);
    if (!found) return null;
    const { fixed, relative } = this.map.placements(c.u, c.v);
    const touch = this.features.nearest(relative, found);
    return touch && placedTouch(fixed, touch);
  }

  patchesTouching(c: AxesConfiguration): number[] {
    return this.classifier.contacts(c.u, c.v, this.pair.resolution).map(([patch]) => patch);
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

/** In the assembly. */
function placedTouch(fixed: Placement, touch: Touch): Touch {
  const [at, normal] = [place(fixed, pointOf(touch.at)), rotate(fixed, pointOf(touch.normal))];
  return { ...touch, at: [at.x, at.y], normal: [normal.x, normal.y] };
}

function pointOf([x, y]: [number, number]): Point {
  return { x, y };
}

/** The configuration space of two parts in the plane, as the page asks it. */

import type { Classification, DrawnCurve, Motion, PatchInfo, PlanarConfiguration, PlanarKernel, Touch } from "../api.js";
import type { PairClass, PlanarSpace, ScenePair } from "../../scene.js";
import { Features, patchKind, type Placement, type SavedPart } from "../features.js";
import { NearFeatures } from "../near.js";
import { Overlap } from "../overlap.js";
import { TAU, turnBy } from "../plane.js";
import { BESIDE, GROWTH, MOVING_GROWTH } from "../tolerance.js";
import { Classifier } from "./classify.js";
import { boundsOf, drawSlice } from "./draw.js";
import { PlanarMotion } from "./motion.js";
import { Surface } from "./surface.js";
import { patchSurface } from "./mesh.js";

export class PlanarPair implements PlanarKernel {
  readonly coordinates = "planar";
  readonly class: PairClass;
  readonly patchCount: number;
  readonly window: { lo: number; hi: number; fullTurn: boolean };
  readonly criticalOrientations: readonly number[];
  readonly bands: readonly [number, number][];
  private readonly surfaces: Surface;
  private readonly classifier: Classifier;
  private readonly motions: PlanarMotion;
  private readonly fixed: Features;
  private readonly moving: Features;
  private readonly features: NearFeatures;
  private readonly regionCount: number;
  private overlapTest: Overlap | null = null;
  private reach: { lo: [number, number]; hi: [number, number] } | null = null;

  constructor(
    private readonly pair: ScenePair,
    space: PlanarSpace,
    names: { fixed: Record<string, string>; moving: Record<string, string> },
  ) {
    const parts = space as unknown as { fixed: SavedPart; moving: SavedPart };
    this.class = pair.class;
    this.patchCount = space.patches.length;
    this.regionCount = space.free_regions.length;
    this.window = { lo: space.window.lo, hi: space.window.hi, fullTurn: space.window.full_turn };
    this.criticalOrientations = space.critical_orientations;
    this.bands = pair.bands.length > 0 ? pair.bands : bandsOf(space);
    this.surfaces = new Surface(space);
    this.fixed = new Features(parts.fixed, space.frame.fixed_center, names.fixed);
    this.moving = new Features(parts.moving, space.frame.moving_center, names.moving);
    this.features = new NearFeatures(this.fixed, this.moving, space.frame, pair.resolution);
    const grown = this.surfaces.outerLength(GROWTH + MOVING_GROWTH);
    const overlap = () => (this.overlapTest ??= new Overlap(parts.fixed, parts.moving, grown));
    this.classifier = new Classifier(this.surfaces, overlap, pair.contact_distance);
    this.motions = new PlanarMotion(this.surfaces, this.classifier, pair.contact_distance, parts.moving);
  }

  patch(index: number): PatchInfo {
    const p = this.patchAt(index);
    return {
      fixed: this.fixed.text(p.fixed),
      moving: this.moving.text(p.moving),
      kind: patchKind(p.fixed, p.moving),
      region: p.region,
      orientations: [p.lo, p.hi],
    };
  }

  private patchAt(index: number) {
    const p = this.surfaces.patches[index];
    if (!p) throw new RangeError(`there is no patch ${index}: the last is ${this.patchCount - 1}`);
    return p;
  }

  classify(c: PlanarConfiguration): Classification | null {
    return this.classifier.located(c)?.class ?? null;
  }

  region(c: PlanarConfiguration): number | null {
    const found = this.classifier.located(c);
    if (found?.class !== "free") return null;
    return this.regionCount === 1 ? 0 : found.region;
  }

  touching(c: PlanarConfiguration, within = this.pair.resolution): Touch[] {
    const found = this.classify(c);
    return found ? this.features.at(placementOf(c), within, found) : [];
  }

  nearest(c: PlanarConfiguration): Touch | null {
    const found = this.classify(c);
    return found && this.features.nearest(placementOf(c), found);
  }

  patchesTouching(c: PlanarConfiguration): number[] {
    return this.classifier.covers(c) ? this.motions.near(c, this.pair.resolution, BESIDE) : [];
  }

  bandAt(theta: number): number {
    const { lo, hi, fullTurn } = this.window;
    if (!Number.isFinite(theta) || (!fullTurn && (theta < lo || theta > hi))) return -1;
    const first = this.bands[0];
    if (!first) return -1;
    const t = fullTurn ? theta - TAU * Math.floor((theta - first[0]) / TAU) : theta;
    let k = 0;
    for (let step = this.bands.length; step > 0; step >>= 1) {
      while (k + step < this.bands.length && this.bands[k + step]![0] <= t) k += step;
    }
    return k;
  }

  slice(theta: number, deviation: number): DrawnCurve[] {
    return drawSlice(this.surfaces, theta, deviation);
  }

  bounds(): { lo: [number, number]; hi: [number, number] } {
    return (this.reach ??= boundsOf(this.surfaces));
  }

  surface(patch: number, deviation: number, perRadian: number) {
    return patchSurface(this.surfaces, this.patchAt(patch), deviation, perRadian);
  }

  advance(from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    return this.motions.advance(from, to);
  }

  slide(from: PlanarConfiguration, to: PlanarConfiguration): Motion<PlanarConfiguration> {
    return this.motions.slide(from, to);
  }
}

function placementOf(c: PlanarConfiguration): Placement {
  return { at: { x: c.x, y: c.y }, turn: turnBy(c.theta) };
}

function bandsOf(space: PlanarSpace): [number, number][] {
  const { window, critical_orientations: critical } = space;
  let ends = [...critical];
  if (!window.full_turn || critical.length === 0) ends = [window.lo, ...ends, window.hi];
  else ends.push(critical[0]! + TAU);
  const bands: [number, number][] = [];
  for (let k = 0; k + 1 < ends.length; k++) {
    if (window.full_turn || ends[k]! < ends[k + 1]!) bands.push([ends[k]!, ends[k + 1]!]);
  }
  return bands;
}

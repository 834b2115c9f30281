/** Pairs of all classes: their configurations as arrays of numbers, which the kernel takes. */

import type { AxisInfo, Classification, DrawnCurve, FreePolygon, Pair, PairClass, PatchInfo, PatchSurface, Reached, Touch } from "../../build/kernel/cspace.js";
import type { AxesConfiguration, AxesKernel, Configuration, Kernel, Motion, PlanarConfiguration, PlanarKernel } from "./api.js";

const TAU = 2 * Math.PI;

abstract class Any<C extends Configuration> implements Kernel<C> {
  abstract readonly coordinates: "planar" | "axes";
  readonly class: PairClass;
  readonly patchCount: number;
  readonly #patches: (PatchInfo | undefined)[];

  constructor(protected readonly pair: Pair) {
    this.class = pair.class;
    this.patchCount = pair.patchCount;
    this.#patches = new Array<PatchInfo | undefined>(this.patchCount);
  }

  protected abstract numbers(c: C): Float64Array;
  protected abstract configuration(numbers: readonly number[]): C;

  patch(index: number): PatchInfo {
    return (this.#patches[index] ??= this.pair.patch(index));
  }

  classify(c: C): Classification | null {
    return this.pair.classify(this.numbers(c)) ?? null;
  }

  fitsExactly(c: C): boolean {
    return this.pair.fitsExactly(this.numbers(c));
  }

  region(c: C): number | null {
    return this.pair.region(this.numbers(c)) ?? null;
  }

  touching(c: C, within?: number): Touch[] {
    return this.pair.touching(this.numbers(c), within);
  }

  nearest(c: C): Touch | null {
    return this.pair.nearest(this.numbers(c));
  }

  words(feature: string, isMoving: boolean): string {
    return this.pair.words(feature, isMoving);
  }

  patchesTouching(c: C): number[] {
    return [...this.pair.patchesTouching(this.numbers(c))];
  }

  advance(from: C, to: C): Motion<C> {
    return this.#motion(this.pair.advance(this.numbers(from), this.numbers(to)));
  }

  slide(from: C, to: C): Motion<C> {
    return this.#motion(this.pair.slide(this.numbers(from), this.numbers(to)));
  }

  #motion({ at, stopped }: Reached): Motion<C> {
    return { at: this.configuration(at), stopped };
  }
}

/** Two parts that a joint keeps in contact: a configuration is in contact if the joint allows it. */
export class Lower extends Any<PlanarConfiguration> {
  readonly coordinates: "planar" | "axes" = "planar";

  protected override numbers({ x, y, theta }: PlanarConfiguration): Float64Array {
    return Float64Array.of(x, y, theta);
  }

  protected override configuration([x = 0, y = 0, theta = 0]: readonly number[]): PlanarConfiguration {
    return { x, y, theta };
  }
}

export class Planar extends Lower implements PlanarKernel {
  override readonly coordinates = "planar";
  readonly window: { lo: number; hi: number; fullTurn: boolean };
  readonly criticalOrientations: readonly number[];
  readonly bands: readonly [number, number][];
  #reach: { lo: [number, number]; hi: [number, number] } | null = null;

  constructor(pair: Pair) {
    super(pair);
    this.window = pair.window();
    this.criticalOrientations = [...pair.criticalOrientations()];
    const ends = pair.bands();
    this.bands = Array.from({ length: ends.length / 2 }, (_, i) => [ends[2 * i] ?? 0, ends[2 * i + 1] ?? 0]);
  }

  bandAt(theta: number): number {
    const { lo, hi, fullTurn } = this.window;
    if (!Number.isFinite(theta) || (!fullTurn && (theta < lo || theta > hi))) return -1;
    const first = this.bands[0];
    if (!first) return -1;
    const t = fullTurn ? theta - TAU * Math.floor((theta - first[0]) / TAU) : theta;
    return this.bands.reduce((last, band, i) => (band[0] <= t ? i : last), -1);
  }

  slice(theta: number, deviation: number): DrawnCurve[] {
    return this.pair.slice(theta, deviation);
  }

  bounds(): { lo: [number, number]; hi: [number, number] } {
    const found = () => {
      const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = this.pair.bounds();
      return { lo: [x0, y0], hi: [x1, y1] } satisfies { lo: [number, number]; hi: [number, number] };
    };
    return (this.#reach ??= found());
  }

  surface(patch: number, deviation: number, perRadian: number): PatchSurface {
    return this.pair.surface(patch, deviation, perRadian);
  }
}

export class Axes extends Any<AxesConfiguration> implements AxesKernel {
  readonly coordinates = "axes";
  readonly u: AxisInfo;
  readonly v: AxisInfo;

  constructor(pair: Pair) {
    super(pair);
    [this.u, this.v] = pair.axes();
  }

  protected override numbers({ u, v }: AxesConfiguration): Float64Array {
    return Float64Array.of(u, v);
  }

  protected override configuration([u = 0, v = 0]: readonly number[]): AxesConfiguration {
    return { u, v };
  }

  curves(deviation: number): DrawnCurve[] {
    return this.pair.curves(deviation);
  }

  free(deviation: number): FreePolygon[] {
    return this.pair.freePolygons(deviation);
  }
}

/** What a user does: selects a pair, moves, turns. Everything that moves parts goes through here. */

import type { AxesConfiguration, AxesKernel, Configuration, Kernel, PlanarConfiguration, PlanarKernel } from "../kernel/api.js";
import { openPair } from "../kernel/index.js";
import type { Scene, ScenePair } from "../scene.js";
import { USUAL, usualView, type Address } from "./address.js";
import { firstPair } from "./first-pair.js";
import { intervalAt, type Interval } from "./heights.js";
import { lowerPair } from "./lower.js";
import { atRest, configurationOf, hasAxes, isAxes, isPlanar, placed, type Anchor } from "./mechanism.js";
import { note } from "./message.js";
import { IDENTITY, apply, coordinateOf, ofMotion, relative, rotate, type Placement } from "./placement.js";
import { regionName } from "./region-names.js";
import { ServerError } from "./server.js";
import { sliceExtent } from "./slice-extent.js";
import { Store, type State, type Where } from "./state.js";
import { neighbour, stepTo } from "./step-band.js";
import { regionOf } from "./verdict.js";
import { WorkError } from "./workshop.js";

/** Fetches a pair with its space: from the server, of the model as it is edited. */
export type Fetcher = (pair: number) => Promise<ScenePair>;

const NOWHERE: Where = { classification: null, fits: false, region: null, touching: [], nearest: null, patches: [] };

export class Session {
  readonly store: Store;
  /** Of the pair that was selected last: settles when its space is there or it is known that there is none. */
  loaded: Promise<void> = Promise.resolve();
  #fetch: Fetcher | null;
  readonly #kernels = new Map<number, Kernel | null>();
  #selections = 0;
  /** By how much the user has turned the moving part since the page was opened (radians), whatever contacts made of it. */
  turnedBy = 0;
  /** What is dragged to, until the next frame. */
  #aim: { configuration: Configuration; anchor: Anchor; base: Placement | null } | null = null;

  constructor(scene: Scene, address: Address, fetch: Fetcher | null) {
    this.#fetch = fetch;
    const placements = atRest(scene);
    const first = firstPair(scene);
    const pair = scene.pairs[address.pair ?? first];
    this.store = new Store({
      scene,
      parts: scene.parts,
      pair: address.pair ?? first,
      space: { state: "loading" },
      placements,
      configuration: pair ? configurationOf(scene, pair, placements) : IDENTITY,
      where: NOWHERE,
      stop: address.stop ?? USUAL.stop,
      theme: address.theme ?? USUAL.theme,
      colouring: address.colouring ?? USUAL.colouring,
      hidden: new Set(address.hidden ?? []),
      cut: address.cut ?? USUAL.cut,
      view: address.view ?? usualView(scene),
      reason: { fixed: [], moving: [] },
      order: null,
      dragging: false,
      record: null,
      time: 0,
      playing: false,
      speed: 1,
      stale: false,
      editing: false,
      making: scene.parts.length < 2,
      height: address.height ?? USUAL.height,
      measuring: false,
      outdated: false,
      whole: false,
      held: null,
      displaced: false,
      message: null,
      checked: null,
      compared: null,
      traced: null,
    });
  }

  /** Pairs are had from elsewhere from now on. */
  set fetcher(fetch: Fetcher) {
    this.#fetch = fetch;
  }

  get state(): Readonly<State> {
    return this.store.state;
  }

  /** The scene as it is edited. */
  get scene(): Scene {
    return this.state.scene;
  }

  get pair(): ScenePair | undefined {
    return this.scene.pairs[this.state.pair];
  }

  /** The heights that are looked at alone; null for all. */
  get interval(): Interval | null {
    return intervalAt(this.state.parts, this.state.height);
  }

  get kernel(): Kernel | null {
    return this.state.space.state === "ready" ? this.state.space.kernel : null;
  }

  get planar(): PlanarKernel | null {
    const kernel = this.kernel;
    // Lower pairs have configurations in the plane, and no slices.
    return kernel?.coordinates === "planar" && kernel.class !== "lower" ? (kernel as unknown as PlanarKernel) : null;
  }

  get axes(): AxesKernel | null {
    const kernel = this.kernel;
    return kernel?.coordinates === "axes" ? (kernel as unknown as AxesKernel) : null;
  }

  /** Selects a pair and gets its space; a configuration if it is known. */
  select(index: number, configuration: Configuration | null = null): Promise<void> {
    const pair = this.scene.pairs[index];
    if (!pair) return Promise.reject(new RangeError(`there is no pair ${index}`));
    const selection = ++this.#selections;
    this.#aim = null;
    const c = configurationOf(this.scene, pair, this.state.placements);
    this.store.change({ pair: index, space: { state: "loading" }, configuration: c, where: NOWHERE, hidden: index === this.state.pair ? this.state.hidden : new Set() });
    this.loaded = this.#load(index).then((failure) => {
      if (selection !== this.#selections) return;
      this.#opened(index, configuration, failure);
    });
    return this.loaded;
  }

  /** What kept the space from coming this time, if it may come the next time. */
  async #load(index: number): Promise<string | null> {
    const pair = this.scene.pairs[index];
    if (!pair || pair.space || pair.error || !this.#fetch) return null;
    try {
      this.replacePair(index, await this.#fetch(index));
      return null;
    } catch (error) {
      const text = error instanceof Error ? error.message : String(error);
      if ((error instanceof ServerError && error.passing) || (error instanceof WorkError && error.cancelled)) return text;
      this.replacePair(index, { ...pair, error: text });
      return null;
    }
  }

  /** Takes a pair with its space; the kernel is opened when the pair is shown. */
  replacePair(index: number, pair: ScenePair): void {
    const pairs = this.scene.pairs.map((p, i) => (i === index ? pair : p));
    this.#kernels.delete(index);
    this.store.change({ scene: { ...this.scene, pairs } });
  }

  /** The model has been edited: spaces of before are no longer those of its pairs, but for that of a pair that is given. */
  replaceParts(parts: Scene["parts"], design: Scene["design"], index: number, pair: ScenePair): void {
    const pairs = this.scene.pairs.map((p, i) => (i === index ? pair : { ...p, space: null, error: null }));
    this.#kernels.clear();
    this.store.change({ scene: { ...this.scene, parts, pairs, design }, parts });
    if (index === this.state.pair) this.#reopen(index);
  }

  #kernelOf(index: number): Kernel | null {
    let kernel = this.#kernels.get(index);
    if (kernel === undefined) {
      kernel = openPair(this.scene, index);
      this.#kernels.set(index, kernel);
    }
    return kernel;
  }

  #reopen(index: number, passing: string | null = null): void {
    const pair = this.scene.pairs[index];
    if (!pair) return;
    let kernel: Kernel | null = null;
    let failure: string | null = pair.error ?? passing;
    try {
      kernel = failure ? null : this.#kernelOf(index);
    } catch (error) {
      failure = `the saved space cannot be read: ${error instanceof Error ? error.message : String(error)}`;
    }
    if (kernel) this.store.change({ space: { state: "ready", kernel } });
    else if (failure) this.store.change({ space: { state: "none", reason: failure, error: true } });
    else this.store.change({ space: { state: "none", reason: this.lowerText(pair), error: !lowerPair(pair) } });
    this.#look();
  }

  #opened(index: number, configuration: Configuration | null, failure: string | null): void {
    this.#reopen(index, failure);
    const pair = this.pair;
    if (!pair) return;
    if (configuration && isAxes(configuration) === hasAxes(pair)) this.setConfiguration(configuration);
    else if (this.state.where.classification === "blocked" && !this.state.where.fits && isAtRest(this.state.placements)) this.#comeIn(pair);
  }

  /** Parts may be drawn on top of each other: then the moving one comes in from a free place until it touches. */
  #comeIn(pair: ScenePair): void {
    const kernel = this.kernel;
    const region = pair.regions.find((r) => !r.unbounded) ?? pair.regions[0];
    if (!kernel || !region) return;
    this.store.change({ displaced: true });
    const [a = 0, b = 0, c] = region.sample;
    if (kernel.coordinates === "axes" || c === undefined) {
      this.setConfiguration({ u: a, v: b });
      return;
    }
    const theta = 0;
    const from = { x: a, y: b, theta };
    const free = kernel.classify(from) === "free";
    this.setConfiguration(free && region.unbounded ? kernel.advance(from, { x: 0, y: 0, theta }).at : free ? from : { x: a, y: b, theta: c });
  }

  /** Places the parts exactly so, whatever is in the way. */
  setConfiguration(c: Configuration, anchor: Anchor = "fixed"): void {
    const pair = this.pair;
    if (!pair || isAxes(c) !== hasAxes(pair)) return;
    this.store.change({ configuration: c, placements: placed(this.scene, pair, this.state.placements, c, anchor) });
    this.#look();
  }

  /** Places parts of a simulation; the configuration follows. */
  setPlacements(placements: Placement[]): void {
    const pair = this.pair;
    this.store.change({ placements, displaced: false });
    if (!pair) return;
    this.store.change({ configuration: configurationOf(this.scene, pair, placements) });
    this.#look();
  }

  #look(): void {
    const kernel = this.kernel;
    const c = this.state.configuration;
    if (!kernel || isAxes(c) !== (kernel.coordinates === "axes")) {
      this.store.change({ where: NOWHERE });
      return;
    }
    const classification = kernel.classify(c);
    const inside = classification === "free" || classification === "contact";
    this.store.change({
      where: {
        classification,
        fits: classification === "blocked" && kernel.fitsExactly(c),
        region: inside ? kernel.region(c) : null,
        touching: classification === "contact" ? kernel.touching(c) : [],
        nearest: inside ? kernel.nearest(c) : null,
        patches: classification === "contact" ? kernel.patchesTouching(c) : [],
      },
    });
  }

  /** Moves towards a configuration at the next frame, as far as contacts let it if they are to stop it. */
  aim(configuration: Configuration, anchor: Anchor = "fixed", base: Placement | null = null): void {
    const waiting = this.#aim !== null;
    this.store.change({ displaced: false });
    this.#aim = { configuration, anchor, base };
    if (!waiting) requestAnimationFrame(() => this.settle());
  }

  /** Where dragging leads to, or where the parts are. */
  get aimed(): Configuration {
    return this.#aim?.configuration ?? this.state.configuration;
  }

  /** Does what was aimed at now. */
  settle(): void {
    const aim = this.#aim;
    this.#aim = null;
    const pair = this.pair;
    if (!aim || !pair) return;
    const to = this.#reached(pair, aim.configuration);
    if (aim.base) {
      const index = aim.anchor === "fixed" ? pair.fixed : pair.moving;
      this.store.change({ placements: this.state.placements.map((p, i) => (i === index && aim.base ? aim.base : p)) });
    }
    this.setConfiguration(to, aim.anchor);
  }

  #reached(pair: ScenePair, to: Configuration): Configuration {
    const kernel = this.kernel;
    const lower = lowerPair(pair);
    if (lower && isPlanar(to)) return lower.at(lower.coordinate(to));
    if (isAxes(to)) to = this.#withinRanges(pair, to);
    if (!kernel || !this.state.stop) return to;
    if (this.state.where.classification === "blocked") return to;
    return kernel.slide(this.state.configuration, to).at;
  }

  #withinRanges(pair: ScenePair, c: AxesConfiguration): AxesConfiguration {
    const held = (part: number, value: number) => {
      const motion = this.scene.parts[part]?.motion;
      if (!motion || motion.type === "fixed" || motion.type === "planar") return 0;
      return motion.range ? Math.min(motion.range[1], Math.max(motion.range[0], value)) : value;
    };
    return { u: held(pair.fixed, c.u), v: held(pair.moving, c.v) };
  }

  /** Drags a part of the pair to a placement; others go as contacts make them. */
  dragPart(part: number, to: Placement): void {
    const pair = this.pair;
    if (!pair) return;
    const motion = this.scene.parts[part]?.motion ?? { type: "planar" };
    const c = this.aimed;
    if (isAxes(c)) {
      const value = coordinateOf(motion, to);
      this.aim(part === pair.fixed ? { ...c, u: value } : { ...c, v: value });
      return;
    }
    const moving = part === pair.moving;
    const other = this.state.placements[moving ? pair.fixed : pair.moving] ?? IDENTITY;
    const wanted = moving ? relative(other, to) : relative(to, other);
    const free = motion.type === "planar" || lowerPair(pair) !== null;
    if (moving) this.aim(wanted, free ? "fixed" : "moving", free ? null : to);
    else this.aim(wanted, "fixed", to);
  }

  /** Translates the point: along x and y, or u and v. */
  nudge(dx: number, dy: number): void {
    const c = this.aimed;
    if (isAxes(c)) this.aim({ u: c.u + dx, v: c.v + dy });
    else this.aim({ ...c, x: c.x + dx, y: c.y + dy });
  }

  /** Turns the moving part about a point of its own; its origin unless given. */
  turn(by: number, about: { x: number; y: number } = { x: 0, y: 0 }): void {
    const c = this.aimed;
    if (isAxes(c)) {
      this.aim({ ...c, v: c.v + by });
      return;
    }
    this.turnedBy += by;
    this.aim(turned(c, by, about));
  }

  setTheta(theta: number): void {
    const c = this.aimed;
    if (!isPlanar(c)) return;
    this.turnedBy += theta - c.theta;
    this.aim({ ...c, theta });
  }

  /** Goes to the next band upwards, or downwards: as the part turns there, where contacts are to stop it. */
  stepBand(by: 1 | -1): void {
    const { pair, planar: kernel } = this;
    const { configuration: c, where } = this.state;
    if (!pair || !kernel || !isPlanar(c) || kernel.bands.length === 0) return;
    if (!this.state.stop || where.classification === "blocked") {
      const band = kernel.bands[neighbour(kernel, kernel.bandAt(c.theta), by) ?? -1];
      if (band) this.setConfiguration({ ...c, theta: (band[0] + band[1]) / 2 });
      return;
    }
    const region = regionOf({ where, kernel });
    const step = stepTo(kernel, c, region, by, sliceExtent(this.state));
    if (step) this.setConfiguration(step);
    const [way, of] = [by > 0 ? "upwards" : "downwards", region === null ? "" : ` of ${regionName(pair, region)}`];
    const last = `From here the part turns no further ${way}: this was the last band${of}. Move it first, or switch off "Stop at contact" to look at the others.`;
    this.store.change({ message: step ? null : note(last) });
  }

  /** Everything as it is drawn. */
  reset(): void {
    this.setPlacements(atRest(this.scene));
    const pair = this.pair;
    if (pair && this.state.where.classification === "blocked") this.#comeIn(pair);
  }

  /** What there is to say where there is nothing to draw. */
  lowerText(pair: ScenePair): string {
    const lower = lowerPair(pair);
    if (!lower) return "There is no configuration space of this pair to show.";
    const text = { revolute: "turn about a pivot", prismatic: "slide along a line" }[lower.type];
    return `The two parts ${text}: a lower pair, whose joint is its whole configuration space.`;
  }

  /** Where parts with one degree of freedom are by their own coordinates, others by placements. */
  placementsBy(parts: ReadonlyMap<string, Placement | number>): Placement[] {
    return this.scene.parts.map((part, i) => {
      const at = parts.get(part.name);
      if (at === undefined) return this.state.placements[i] ?? IDENTITY;
      return typeof at === "number" ? ofMotion(part.motion, at) : at;
    });
  }
}

function turned(c: PlanarConfiguration, by: number, about: { x: number; y: number }): PlanarConfiguration {
  const center = apply(c, about);
  const r = rotate(about, c.theta + by);
  return { x: center.x - r.x, y: center.y - r.y, theta: c.theta + by };
}

function isAtRest(placements: readonly Placement[]): boolean {
  return placements.every((p) => p.x === 0 && p.y === 0 && p.theta === 0);
}

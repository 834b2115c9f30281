/**
 * The contact surface as meshes, one for each free region. Patches are made a few at a time between frames, those near the current
 * orientation first, so that the page can be used meanwhile.
 */

import { Group, type Box3 } from "three";
import type { PlanarKernel } from "../kernel/api.js";
import { TURN } from "./placement.js";
import { RegionMesh, type Clip } from "./region-mesh.js";
import type { Colouring } from "./colours.js";
import type { SpaceScale } from "./space-scale.js";

/** How long patches are made before the browser may draw a frame (ms). */
const SLICE_OF_TIME = 8;

/** The turns by which a patch is seen in the window: one that runs over the end of a full turn is seen at its beginning, too. */
export function turnsOf(kernel: PlanarKernel, patch: number): number[] {
  const { lo, hi, fullTurn } = kernel.window;
  const [first, last] = kernel.patch(patch).orientations ?? [lo, hi];
  if (!fullTurn) return [0];
  return [-TURN, 0, TURN].filter((turn) => last + turn > lo && first + turn < hi);
}

export class Surface {
  readonly group = new Group();
  readonly #regions = new Map<number | null, RegionMesh>();
  readonly #clip: Clip;
  readonly kernel: PlanarKernel;
  readonly #scale: SpaceScale;
  #colouring: Colouring;
  #waiting: number[];
  #frame: number | null = null;
  #onProgress: (left: number) => void;
  /** When all patches are there. */
  readonly done: Promise<void>;
  #finish: () => void = () => {};

  constructor(kernel: PlanarKernel, scale: SpaceScale, theta: number, colouring: Colouring, clip: Clip, onProgress: (left: number) => void) {
    this.kernel = kernel;
    this.#scale = scale;
    this.#colouring = colouring;
    this.#clip = clip;
    this.#onProgress = onProgress;
    this.done = new Promise((resolve) => {
      this.#finish = resolve;
    });
    const far = (patch: number) => {
      const [lo, hi] = kernel.patch(patch).orientations ?? [0, 0];
      return Math.min(...[-TURN, 0, TURN].map((turn) => Math.max(0, lo + turn - theta, theta - hi - turn)));
    };
    // The nearest is taken first, from the end.
    const distances = Array.from({ length: kernel.patchCount }, (_, i) => far(i));
    this.#waiting = distances.map((_, i) => i).sort((a, b) => (distances[b] ?? 0) - (distances[a] ?? 0));
    this.#step();
  }

  #step(): void {
    const end = performance.now() + SLICE_OF_TIME;
    const touched = new Set<RegionMesh>();
    while (performance.now() < end) {
      const patch = this.#waiting.pop();
      if (patch === undefined) break;
      const { region, kind } = this.kernel.patch(patch);
      const made = this.kernel.surface(patch, this.#scale.deviation, this.#scale.perRadian);
      if (made.indices.length === 0) continue;
      const mesh = this.#meshOf(region);
      for (const turn of turnsOf(this.kernel, patch)) mesh.add({ patch, region, kind }, made, turn, this.#scale, this.#colouring);
      touched.add(mesh);
    }
    for (const mesh of touched) mesh.upload();
    this.#onProgress(this.#waiting.length);
    if (this.#waiting.length > 0) this.#frame = requestAnimationFrame(() => this.#step());
    else this.#finish();
  }

  #meshOf(region: number | null): RegionMesh {
    let mesh = this.#regions.get(region);
    if (!mesh) {
      mesh = new RegionMesh(this.#clip);
      this.#regions.set(region, mesh);
      this.group.add(mesh.mesh);
    }
    return mesh;
  }

  /** Bounds of what is drawn of a region. */
  boxOf(region: number): Box3 | null {
    return this.#regions.get(region)?.box() ?? null;
  }

  paint(colouring: Colouring): void {
    if (colouring === this.#colouring) return;
    this.#colouring = colouring;
    for (const mesh of this.#regions.values()) mesh.paint(colouring);
  }

  show(hidden: ReadonlySet<number>, cut: boolean): void {
    for (const [region, { mesh, rims }] of this.#regions) {
      mesh.visible = region === null || !hidden.has(region);
      for (const material of [mesh.material, rims.material]) material.clippingPlanes = cut ? [...this.#clip.window, this.#clip.cut] : this.#clip.window;
    }
  }

  /** A surface that is being computed again is shown faintly. */
  fade(faint: boolean): void {
    for (const { mesh, rims } of this.#regions.values()) {
      mesh.material.transparent = faint;
      mesh.material.opacity = faint ? 0.35 : 1;
      mesh.material.needsUpdate = true;
      // Lines over faint triangles would be seen.
      rims.visible = !faint;
    }
  }

  dispose(): void {
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.#finish();
    for (const mesh of this.#regions.values()) mesh.dispose();
    this.group.removeFromParent();
  }
}

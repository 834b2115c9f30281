/** What moves in the 3-D view: the slice on its plane, the configuration, the patch that touches, a planned way. */

import { BackSide, BufferAttribute, BufferGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments } from "three";
import { Mesh, MeshBasicMaterial, PlaneGeometry, SphereGeometry, Vector2, type Plane } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Configuration, DrawnCurve, PlanarConfiguration, PlanarKernel } from "../kernel/api.js";
import { TOUCHING } from "./colours.js";
import { isPlanar } from "./mechanism.js";
import { TURN, wrap } from "./placement.js";
import { turnsOf } from "./surface.js";
import { inSpace, type SpaceScale } from "./space-scale.js";

/** Widths of lines and the size of the point, in pixels. */
const SLICE_WIDTH = 3;
const WAY_WIDTH = 4;
const POINT_RADIUS = 7;

/** How much of the point is seen through what is before it. */
const HIDDEN_OPACITY = 0.3;

const WAY = "#cc3399";
/** Of a way of the model before it was changed. */
const STALE = "#888888";

export class SpaceMarks {
  readonly group = new Group();
  readonly #plane: Mesh<PlaneGeometry, MeshBasicMaterial>;
  readonly #rim: LineSegments<EdgesGeometry, LineBasicMaterial>;
  readonly #slice: LineSegments2;
  readonly #sliceMaterial = new LineMaterial({ linewidth: SLICE_WIDTH, color: 0x000000 });
  readonly #way: LineSegments2;
  readonly #wayMaterial = new LineMaterial({ linewidth: WAY_WIDTH, color: WAY, dashed: false });
  readonly #lit: Mesh<BufferGeometry, MeshBasicMaterial>;
  /** The same, seen faintly through what is before it. */
  readonly #shining: Mesh<BufferGeometry, MeshBasicMaterial>;
  readonly #point = new Group();
  readonly #dot = new MeshBasicMaterial({ color: 0xffffff });
  #litPatches = "";

  constructor(window: Plane[]) {
    this.#plane = new Mesh(
      new PlaneGeometry(1, 1),
      new MeshBasicMaterial({ color: 0x888888, transparent: true, opacity: 0.14, side: DoubleSide, depthWrite: false }),
    );
    this.#rim = new LineSegments(new EdgesGeometry(this.#plane.geometry), new LineBasicMaterial({ color: 0x888888 }));
    this.#plane.add(this.#rim);
    this.#plane.renderOrder = 2;
    this.#slice = new LineSegments2(new LineSegmentsGeometry(), this.#sliceMaterial);
    this.#slice.frustumCulled = false;
    this.#slice.renderOrder = 3;
    this.#way = new LineSegments2(new LineSegmentsGeometry(), this.#wayMaterial);
    this.#way.frustumCulled = false;
    this.#way.visible = false;
    this.#way.renderOrder = 3;
    // Drawn over the patch it lies on.
    this.#lit = new Mesh(
      new BufferGeometry(),
      new MeshBasicMaterial({ color: TOUCHING, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -4, polygonOffsetUnits: -4, clippingPlanes: window }),
    );
    this.#lit.frustumCulled = false;
    this.#shining = new Mesh(
      this.#lit.geometry,
      new MeshBasicMaterial({ color: TOUCHING, side: DoubleSide, transparent: true, opacity: 0.4, depthTest: false, clippingPlanes: window }),
    );
    this.#shining.frustumCulled = false;
    this.#shining.renderOrder = 4;
    const ball = new SphereGeometry(1, 24, 16);
    const dark = { color: 0x000000, side: BackSide };
    const rim = new Mesh(ball, new MeshBasicMaterial(dark));
    // Within the surface the point is hidden, and a faint ring tells where it is.
    const ghost = new Mesh(ball, new MeshBasicMaterial({ ...dark, depthTest: false, transparent: true, opacity: HIDDEN_OPACITY }));
    for (const outer of [rim, ghost]) outer.scale.setScalar(1.35);
    ghost.renderOrder = 8;
    this.#point.add(rim, new Mesh(ball, this.#dot), ghost);
    this.group.add(this.#plane, this.#slice, this.#way, this.#lit, this.#shining, this.#point);
  }

  resize(width: number, height: number): void {
    const size = new Vector2(width, height);
    this.#sliceMaterial.resolution.copy(size);
    this.#wayMaterial.resolution.copy(size);
  }

  theme(dark: boolean): void {
    this.#sliceMaterial.color.set(dark ? 0xffffff : 0x000000);
    this.#rim.material.color.set(dark ? 0xbbbbbb : 0x555555);
    this.#plane.material.color.set(dark ? 0xffffff : 0x334455);
  }

  /** The plane's extent. */
  setExtent(width: number, height: number): void {
    this.#plane.scale.set(width, height, 1);
  }

  setTheta(z: number): void {
    this.#plane.position.z = z;
  }

  setSlice(curves: readonly DrawnCurve[], hidden: ReadonlySet<number>, z: number, scale: SpaceScale): void {
    const positions: number[] = [];
    const theta = z / scale.perRadian;
    for (const { points, region } of curves) {
      if (region !== null && hidden.has(region)) continue;
      for (let i = 0; i + 3 < points.length; i += 2) {
        for (const j of [i, i + 2]) positions.push(...inSpace(scale, { x: points[j] ?? 0, y: points[j + 1] ?? 0, theta }));
      }
    }
    setSegments(this.#slice, positions);
  }

  setPoint(x: number, y: number, z: number, colour: string): void {
    this.#point.position.set(x, y, z);
    this.#dot.color.set(colour);
  }

  get point(): Group {
    return this.#point;
  }

  /** Keeps the point's size on the screen. */
  scalePoint(unitsPerPixel: number): void {
    this.#point.scale.setScalar(POINT_RADIUS * unitsPerPixel);
  }

  light(kernel: PlanarKernel | null, patches: readonly number[], scale: SpaceScale): void {
    const key = patches.join();
    if (key === this.#litPatches) return;
    this.#litPatches = key;
    const positions: number[] = [];
    const indices: number[] = [];
    for (const patch of kernel ? patches : []) {
      const made = kernel?.surface(patch, scale.deviation, scale.perRadian);
      if (!made) continue;
      for (const turn of kernel ? turnsOf(kernel, patch) : []) {
        const start = positions.length / 3;
        for (let i = 0; i < made.positions.length; i += 3) {
          const [x = 0, y = 0, theta = 0] = [made.positions[i], made.positions[i + 1], made.positions[i + 2]];
          positions.push(...inSpace(scale, { x, y, theta }, turn));
        }
        for (const index of made.indices) indices.push(start + index);
      }
    }
    this.#lit.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
    geometry.setIndex(indices);
    for (const mesh of [this.#lit, this.#shining]) {
      mesh.geometry = geometry;
      mesh.visible = indices.length > 0;
    }
  }

  forgetLight(): void {
    this.#litPatches = "?";
  }

  setWay(steps: readonly Configuration[], isStale: boolean, kernel: PlanarKernel, scale: SpaceScale): void {
    const positions: number[] = [];
    const { lo, hi, fullTurn } = kernel.window;
    for (let i = 0; i + 1 < steps.length; i += 1) {
      const [a, b] = [steps[i], steps[i + 1]];
      if (!a || !b || !isPlanar(a) || !isPlanar(b)) continue;
      const pieces = fullTurn ? cutAtEnds(a, b, lo, hi) : [[a, b] as const];
      positions.push(...pieces.flat().flatMap((c) => inSpace(scale, c)));
    }
    this.#wayMaterial.color.set(isStale ? STALE : WAY);
    setSegments(this.#way, positions);
  }
}

/** A leg in pieces that lie in one turn each, shifted into the window. */
function cutAtEnds(a: PlanarConfiguration, b: PlanarConfiguration, lo: number, hi: number): [PlanarConfiguration, PlanarConfiguration][] {
  const fractions = [0];
  const [first, last] = [Math.min(a.theta, b.theta), Math.max(a.theta, b.theta)];
  for (let k = Math.ceil((first - lo) / TURN); lo + k * TURN < last; k += 1) {
    const f = (lo + k * TURN - a.theta) / (b.theta - a.theta);
    if (f > 0 && f < 1) fractions.push(f);
  }
  fractions.sort((p, q) => p - q);
  fractions.push(1);
  const at = (f: number) => ({ x: a.x + f * (b.x - a.x), y: a.y + f * (b.y - a.y), theta: a.theta + f * (b.theta - a.theta) });
  return fractions.slice(1).map((f, i) => {
    const [p, q] = [at(fractions[i] ?? 0), at(f)];
    const middle = (p.theta + q.theta) / 2;
    const shift = wrap(middle, lo) - middle;
    return [{ ...p, theta: Math.max(lo, p.theta + shift) }, { ...q, theta: Math.min(hi, q.theta + shift) }];
  });
}

function setSegments(line: LineSegments2, positions: number[]): void {
  line.geometry.dispose();
  line.visible = positions.length > 0;
  if (positions.length === 0) return;
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(positions);
  line.geometry = geometry;
}

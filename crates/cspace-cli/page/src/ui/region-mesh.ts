/** The part of the contact surface that bounds one free region, as a mesh to which patches are added. */

import { Box3, BufferAttribute, BufferGeometry, DoubleSide, LineSegments, Mesh, MeshLambertMaterial, type Plane } from "three";
import type { PatchKind, PlanarKernel } from "../kernel/api.js";
import { channels, patchColour, type Colouring } from "./colours.js";
import { swing, swingSlope, type SpaceScale } from "./space-scale.js";
import { rimMaterial, rimOf } from "./surface-rim.js";

/** A mesh begins with room for so many vertices and doubles it when it is full. */
const FIRST_ROOM = 4096;

/** What is drawn of the space: its window, and perhaps nothing above an orientation. */
export interface Clip {
  window: Plane[];
  cut: Plane;
}

interface Placed {
  patch: number;
  region: number | null;
  kind: PatchKind;
  start: number;
  count: number;
}

export class RegionMesh {
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial>;
  /** Along the rims of patches: closes the seams between them. */
  readonly rims: LineSegments<BufferGeometry, MeshLambertMaterial>;
  readonly placed: Placed[] = [];
  #positions = new Float32Array(3 * FIRST_ROOM);
  #normals = new Float32Array(3 * FIRST_ROOM);
  #colours = new Uint8Array(3 * FIRST_ROOM);
  #indices = new Uint32Array(3 * FIRST_ROOM);
  #rimIndices = new Uint32Array(FIRST_ROOM);
  #vertices = 0;
  #used = 0;
  #rimsUsed = 0;

  constructor(clip: Clip) {
    // Behind the lines on it: the slice, the way and its own rims.
    const behind = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, forceSinglePass: true, clippingPlanes: clip.window, ...behind });
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.rims = new LineSegments(new BufferGeometry(), rimMaterial(clip.window));
    this.mesh.frustumCulled = this.rims.frustumCulled = false;
    this.mesh.add(this.rims);
    this.#attach();
  }

  #attach(): void {
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.#positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(this.#normals, 3));
    geometry.setAttribute("color", new BufferAttribute(this.#colours, 3, true));
    geometry.setIndex(new BufferAttribute(this.#indices, 1));
    geometry.setDrawRange(0, this.#used);
    this.mesh.geometry = geometry;
    // Both have the same vertices, and are given up together: the graphics card keeps one copy.
    this.rims.geometry.dispose();
    const rims = new BufferGeometry();
    for (const [name, attribute] of Object.entries(geometry.attributes)) rims.setAttribute(name, attribute);
    rims.setIndex(new BufferAttribute(this.#rimIndices, 1));
    rims.setDrawRange(0, this.#rimsUsed);
    this.rims.geometry = rims;
  }

  add(patch: Omit<Placed, "start" | "count">, made: ReturnType<PlanarKernel["surface"]>, turn: number, scale: SpaceScale, colouring: Colouring): void {
    const count = made.positions.length / 3;
    const start = this.#vertices;
    let grew = false;
    while (3 * (start + count) > this.#positions.length) {
      this.#positions = doubled(this.#positions, Float32Array);
      this.#normals = doubled(this.#normals, Float32Array);
      this.#colours = doubled(this.#colours, Uint8Array);
      grew = true;
    }
    while (this.#used + made.indices.length > this.#indices.length) {
      this.#indices = doubled(this.#indices, Uint32Array);
      grew = true;
    }
    for (let i = 0; i < count; i += 1) {
      const at = 3 * (start + i);
      const theta = made.positions[3 * i + 2] ?? 0;
      const aside = swing(scale, theta);
      this.#positions[at] = (made.positions[3 * i] ?? 0) + aside.x - scale.center[0];
      this.#positions[at + 1] = (made.positions[3 * i + 1] ?? 0) + aside.y - scale.center[1];
      this.#positions[at + 2] = (theta + turn) * scale.perRadian;
    }
    this.#normals.set(made.normals, 3 * start);
    if (scale.arm.x !== 0 || scale.arm.y !== 0) this.#shear(made, start, scale);
    for (let i = 0; i < made.indices.length; i += 1) this.#indices[this.#used + i] = (made.indices[i] ?? 0) + start;
    const rim = rimOf(made.indices);
    while (this.#rimsUsed + rim.length > this.#rimIndices.length) {
      this.#rimIndices = doubled(this.#rimIndices, Uint32Array);
      grew = true;
    }
    rim.forEach((index, i) => (this.#rimIndices[this.#rimsUsed + i] = index + start));
    this.#rimsUsed += rim.length;
    this.#vertices += count;
    this.#used += made.indices.length;
    const placed = { ...patch, start, count };
    this.placed.push(placed);
    this.#paint(placed, colouring);
    if (grew) this.#attach();
  }

  /** Normals of a surface whose every orientation is moved aside by another amount. */
  #shear(made: ReturnType<PlanarKernel["surface"]>, start: number, scale: SpaceScale): void {
    for (let i = 0; i < made.normals.length; i += 3) {
      const slope = swingSlope(scale, made.positions[i + 2] ?? 0);
      const [x = 0, y = 0, z = 0] = [made.normals[i], made.normals[i + 1], made.normals[i + 2]];
      const sheared = z - slope.x * x - slope.y * y;
      const length = Math.hypot(x, y, sheared) || 1;
      this.#normals.set([x / length, y / length, sheared / length], 3 * start + i);
    }
  }

  /** Tells the graphics card what has been added. */
  upload(): void {
    const { geometry } = this.mesh;
    for (const name of ["position", "normal", "color"]) {
      const attribute = geometry.getAttribute(name);
      if (attribute) attribute.needsUpdate = true;
    }
    if (geometry.index) geometry.index.needsUpdate = true;
    geometry.setDrawRange(0, this.#used);
    const rims = this.rims.geometry;
    if (rims.index) rims.index.needsUpdate = true;
    rims.setDrawRange(0, this.#rimsUsed);
  }

  box(): Box3 {
    return new Box3().setFromArray(this.#positions.subarray(0, 3 * this.#vertices));
  }

  paint(colouring: Colouring): void {
    for (const placed of this.placed) this.#paint(placed, colouring);
    const colours = this.mesh.geometry.getAttribute("color");
    if (colours) colours.needsUpdate = true;
  }

  #paint(placed: Placed, colouring: Colouring): void {
    const rgb = channels(patchColour(colouring, placed)).map(linear);
    for (let i = 0; i < placed.count; i += 1) this.#colours.set(rgb, 3 * (placed.start + i));
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.rims.geometry.dispose();
    this.rims.material.dispose();
  }
}

function doubled<A extends Float32Array | Uint8Array | Uint32Array>(array: A, make: new (length: number) => A): A {
  const larger = new make(2 * array.length);
  larger.set(array as never);
  return larger;
}

/** Vertex colours are linear, and those of the page are not. */
function linear(channel: number): number {
  const c = channel / 255;
  return Math.round(255 * (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
}

/**
 * The rims of patches as lines of the surface's own colour and shade. Patches that meet are divided into triangles each for itself, and
 * between their rims pixels of the background would be seen.
 */

import { MeshLambertMaterial, type Plane } from "three";

/** Edges that belong to one triangle only, as pairs of indices. */
export function rimOf(indices: ArrayLike<number>): number[] {
  const once = new Map<number, [number, number]>();
  let most = 0;
  for (let i = 0; i < indices.length; i += 1) most = Math.max(most, indices[i] ?? 0);
  for (let i = 0; i + 2 < indices.length; i += 3) {
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [indices[i + k] ?? 0, indices[i + ((k + 1) % 3)] ?? 0];
      const key = Math.min(a, b) * (most + 1) + Math.max(a, b);
      if (once.has(key)) once.delete(key);
      else once.set(key, [a, b]);
    }
  }
  return [...once.values()].flat();
}

/** Lambert's shade for lines, which have no front and back: their normals are turned to the camera. */
export function rimMaterial(clippingPlanes: Plane[]): MeshLambertMaterial {
  const material = new MeshLambertMaterial({ vertexColors: true, clippingPlanes });
  material.onBeforeCompile = (shader) => {
    const begin = "#include <normal_fragment_begin>";
    shader.fragmentShader = shader.fragmentShader.replace(begin, `${begin}\n\tif (dot(normal, vViewPosition) < 0.0) normal = -normal;`);
  };
  return material;
}

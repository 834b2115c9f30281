/** The box of the 3-D view with its axes, whose numbers are text of the page laid over the picture. */

import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Vector3, type Camera } from "three";
import { html, say } from "./dom.js";
import { gridLines, lineText } from "./grid.js";
import { angleStep, degrees, lengthStep } from "./numbers.js";
import type { SpaceScale } from "./space-scale.js";

/** Ends of an axis that are a number miss it by this at most, in steps. */
const ROUNDING = 1e-9;
/** About how many numbers an axis has. */
const NUMBERS = 4;

interface Label {
  at: Vector3;
  element: HTMLElement;
}

export class SpaceAxes {
  readonly group = new Group();
  readonly #layer = html("div", { class: "space-labels", "aria-hidden": "true" });
  readonly #material = new LineBasicMaterial({ color: 0x888888 });
  #labels: Label[] = [];

  constructor(parent: HTMLElement) {
    parent.append(this.#layer);
  }

  theme(dark: boolean): void {
    this.#material.color.set(dark ? 0x667788 : 0x99a3ad);
  }

  /** A box of the space's bounds and orientations. */
  build(lo: [number, number], hi: [number, number], angles: [number, number], scale: SpaceScale, unit: string | null): void {
    const [x0, y0, x1, y1] = [lo[0] - scale.center[0], lo[1] - scale.center[1], hi[0] - scale.center[0], hi[1] - scale.center[1]];
    const [z0, z1] = [angles[0] * scale.perRadian, angles[1] * scale.perRadian];
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new Vector3(i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0));
    const lines = corners.flatMap((a, i) => [1, 2, 4].filter((bit) => !(i & bit)).flatMap((bit) => [a, corners[i | bit] ?? a]));
    const labels: [Vector3, string][] = [];
    const along = (from: number, to: number, step: number, put: (value: number) => [Vector3, Vector3, string]) => {
      for (const { value } of gridLines(from - ROUNDING * step, to + ROUNDING * step, step)) {
        const [a, b, text] = put(value);
        lines.push(a, b);
        labels.push([b, text]);
      }
    };
    const tick = 0.03 * Math.max(x1 - x0, y1 - y0);
    const steps = [lengthStep((hi[0] - lo[0]) / NUMBERS), lengthStep((hi[1] - lo[1]) / NUMBERS)] as const;
    along(lo[0], hi[0], steps[0], (v) => [
      new Vector3(v - scale.center[0], y0, z0), new Vector3(v - scale.center[0], y0 - tick, z0), lineText(v, steps[0]),
    ]);
    along(lo[1], hi[1], steps[1], (v) => [
      new Vector3(x1, v - scale.center[1], z0), new Vector3(x1 + tick, v - scale.center[1], z0), lineText(v, steps[1]),
    ]);
    along(angles[0], angles[1], angleStep((angles[1] - angles[0]) / NUMBERS), (v) => [
      new Vector3(x0, y0, v * scale.perRadian), new Vector3(x0 - tick, y0 - tick, v * scale.perRadian), degrees(v),
    ]);
    const ofMiddle = scale.arm.x !== 0 || scale.arm.y !== 0 ? " of the middle" : "";
    const of = `${ofMiddle}${unit ? ` (${unit})` : ""}`;
    labels.push([new Vector3((x0 + x1) / 2, y0 - 4 * tick, z0), `x${of}`]);
    labels.push([new Vector3(x1 + 4 * tick, (y0 + y1) / 2, z0), `y${of}`]);
    labels.push([new Vector3(x0 - tick, y0 - tick, z1 + 3 * tick), "θ"]);
    this.group.clear();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(lines.flatMap((p) => [p.x, p.y, p.z])), 3));
    this.group.add(new LineSegments(geometry, this.#material));
    this.#labels = labels.map(([at, text]) => {
      const element = html("span");
      say(element, text);
      return { at, element };
    });
    this.#layer.replaceChildren(...this.#labels.map((l) => l.element));
  }

  place(camera: Camera, width: number, height: number): void {
    const p = new Vector3();
    for (const { at, element } of this.#labels) {
      p.copy(at).project(camera);
      const inside = p.z < 1 && Math.abs(p.x) < 1 && Math.abs(p.y) < 1;
      element.hidden = !inside;
      if (inside) element.style.transform = `translate(-50%, -50%) translate(${((p.x + 1) / 2) * width}px, ${((1 - p.y) / 2) * height}px)`;
    }
  }
}

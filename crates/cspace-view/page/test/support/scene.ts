/** Scenes for tests, put together from what `cspace export` and `cspace info` say. */

import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Scene, ScenePair, ScenePart } from "../../src/scene.js";
import { run } from "./command.js";

/** Configurations nearer to a contact than this share of the pair's frame are in contact. */
const CONTACT = 2 ** -37;

interface InfoPair {
  fixed: string;
  moving: string;
  class: ScenePair["class"];
}

export function sceneOf(model: string): Scene {
  const info = JSON.parse(run(["info", model, "--format", "json"])) as { name: string; pairs: InfoPair[] };
  const parts: ScenePart[] = [];
  const partOf = (name: string, part: { loops: ScenePart["loops"] }): number => {
    let at = parts.findIndex((p) => p.name === name);
    if (at < 0) at = parts.push({ name, loops: part.loops, feature_names: {}, motion: { type: "planar" } }) - 1;
    return at;
  };
  const folder = mkdtempSync(join(tmpdir(), "cspace-page-"));
  try {
    const pairs = info.pairs.map((p): ScenePair => {
      const out = join(folder, "space.json");
      run(["export", model, "--pair", `${p.fixed},${p.moving}`, "-o", out, "-q"]);
      const space = JSON.parse(readFileSync(out, "utf8"));
      const scale = space.frame?.scale ?? space.map?.frame.scale ?? 1;
      return {
        fixed: partOf(p.fixed, space.fixed),
        moving: partOf(p.moving, space.moving),
        class: p.class,
        space,
        error: null,
        features: { fixed: 0, moving: 0 },
        symmetry: { fixed: 1, moving: 1 },
        contact_distance: CONTACT / scale,
        resolution: CONTACT / scale + (space.symmetry?.deviation ?? 0),
        bands: [],
        regions: [],
        seconds: 0,
      };
    });
    return { format: "cspace-scene", version: 1, name: info.name, unit: null, parts, joints: [], pairs, records: [] };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

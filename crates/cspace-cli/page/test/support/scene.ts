/** Scenes for tests: those that the command puts into its pages. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Scene } from "../../src/scene.js";
import { MODELS, run } from "./command.js";

const ELEMENT = /<script type="application\/json" id="scene">([^]*?)<\/script>/;

/** Runs something with a folder that is gone afterwards. */
export function inFolder<T>(use: (folder: string) => T): T {
  const folder = mkdtempSync(join(tmpdir(), "cspace-page-"));
  try {
    return use(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** Scenes of the models that come with the project, as text: several tests of a file ask for them. */
const known = new Map<string, string>();

export function sceneOf(model: string): Scene {
  const text = known.get(model) ?? exported(model);
  if (model.startsWith(MODELS)) known.set(model, text);
  return JSON.parse(text) as Scene;
}

function exported(model: string): string {
  return inFolder((folder) => {
    const page = join(folder, "page.html");
    run(["export", model, "-o", page, "-q"]);
    const found = ELEMENT.exec(readFileSync(page, "utf8"));
    if (!found) throw new Error(`the page of ${model} has no scene`);
    return found[1]!;
  });
}

/** Runs something with a model file of a text. */
export function withModel<T>(text: string, use: (path: string) => T): T {
  return inFolder((folder) => {
    const path = join(folder, "model.toml");
    writeFileSync(path, text);
    return use(path);
  });
}

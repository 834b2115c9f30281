/** Model files that are dropped onto the page, or opened with it. */

import { Model } from "../../build/kernel/cspace.js";
import type { Scene } from "../scene.js";

/** Whether a file is a model, and no record. */
export function isModel(file: File): boolean {
  return file.name.toLowerCase().endsWith(".toml");
}

/** The scene of a model file; throws what is wrong with it, as the command says it. */
export function sceneOfFile(text: string, name: string): Scene {
  const model = Model.read(text, name);
  try {
    return JSON.parse(model.scene()) as Scene;
  } finally {
    model.free();
  }
}

/** The key under which a page that is loaded again finds the scene it is to show. */
const KEY = "cspace-scene";

/** Shows another scene in this page, which is loaded again for it. */
export function showScene(scene: Scene): void {
  sessionStorage.setItem(KEY, JSON.stringify(scene));
  location.hash = "";
  location.reload();
}

/** The scene that the page was loaded again for, once. */
export function sceneToShow(): Scene | null {
  try {
    const text = sessionStorage.getItem(KEY);
    sessionStorage.removeItem(KEY);
    return text === null ? null : (JSON.parse(text) as Scene);
  } catch {
    // Some browsers keep nothing for pages from files.
    return null;
  }
}

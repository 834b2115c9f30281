/** Models and drawings that are dropped onto the page, or opened with it. */

import { Drawing, Model } from "../../build/kernel/cspace.js";
import type { DrawingScene } from "../drawing/scene.js";
import { inUtf8 } from "../drawing/utf8.js";
import type { Scene } from "../scene.js";
import { html } from "./dom.js";
import { showScene } from "./entries.js";
import { messageDrawn } from "./message.js";

/** Drawings; of those that are none for the page, the kernel says why. */
const DRAWINGS = [".dxf", ".svg", ".csv", ".dwg"];

/**
 * Shows a model or a drawing in this page, in place of what is in it; false of another file. Throws what is wrong, as the command says it;
 * `tell` says what is done meanwhile.
 */
export async function showFile(file: File, tell: (message: string) => void): Promise<boolean> {
  const name = file.name.toLowerCase();
  const isModel = name.endsWith(".toml");
  if (!isModel && !DRAWINGS.some((ending) => name.endsWith(ending))) return false;
  tell(`${file.name} is read …`);
  await messageDrawn();
  if (isModel) await showModel(await file.text(), file.name);
  else await showScene(sceneOfDrawing(new Uint8Array(await file.arrayBuffer()), file.name));
  return true;
}

/** Shows a model in this page: TOML; `isStep` if it is the present one with a change. */
export const showModel = (text: string, name: string, isStep = false): Promise<void> => showScene(sceneOf(readModel(text, name)), isStep);

/** The scene of a model of the kernel, which is not needed any more. */
export function sceneOf(model: Model): Scene {
  try {
    return JSON.parse(model.scene()) as Scene;
  } finally {
    model.free();
  }
}

function readModel(text: string, name: string): Model {
  try {
    return Model.read(text, name);
  } catch (error) {
    // A page has no files but those that it is given.
    const isOfFile = error instanceof Error && error.message.includes("not supported on this platform");
    if (!isOfFile) throw error;
    const where = error.message.split(": it cannot be read")[0] ?? name;
    throw new Error(`${where}: a page cannot read the drawings that a model names. Open the drawing itself, or a model with outlines in it, as cspace import writes them.`);
  }
}

function sceneOfDrawing(bytes: Uint8Array, name: string): DrawingScene {
  const drawing = Drawing.read(inUtf8(bytes), name);
  try {
    return JSON.parse(drawing.scene()) as DrawingScene;
  } finally {
    drawing.free();
  }
}

/** Has the user choose a file, of those with these endings first. */
export function chooseFile(accept: string, take: (file: File) => void): void {
  const input = html("input", { type: "file", accept });
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) take(file);
  });
  input.click();
}

export function listenToDrops(take: (file: File) => void): void {
  const dropping = (on: boolean) => document.body.classList.toggle("dropping", on);
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    dropping(true);
  });
  document.addEventListener("dragleave", () => dropping(false));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    dropping(false);
    for (const file of event.dataTransfer?.files ?? []) take(file);
  });
}

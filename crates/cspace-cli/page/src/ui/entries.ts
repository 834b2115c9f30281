/**
 * What the page shows at each entry of the browser's history: the scene that is in it, or one that was opened in it. Opened scenes are
 * kept as long as the tab; the browser's Back leads from one to the other.
 */

import { DRAWING_VERSION, type DrawingScene } from "../drawing/scene.js";
import { pack, unpack } from "../kernel/packed.js";
import { SCENE_VERSION, type Scene } from "../scene.js";
import { textOf } from "./dom.js";

/** What the history keeps of an entry. */
interface Entry {
  /** The key under which the scene is kept; empty of the scene that is in the page. */
  opened: string;
  /** Of a model that a change made of the one before, to which Undo leads: whether it is in a file. */
  step?: "saved" | "unsaved";
  /** Whether Redo leads to the next. */
  isUndone?: boolean;
}

export interface Shown {
  scene: Scene | DrawingScene;
  /** Whether the user has opened it here: the server knows nothing of it. */
  isOpened: boolean;
}

/** How keys of kept scenes begin. */
const PREFIX = "cspace-scene ";

let shown: Entry = { opened: "" };
/** Whether another entry is about to be shown: it has an address of its own. */
let leaving = false;

export const isLeaving = (): boolean => leaving;

/** Writes the fragment of the address; false where the browser refuses. */
export function writeFragment(fragment: string): boolean {
  return leaving || replaced(fragment);
}

function replaced(address?: string): boolean {
  // A page within another may not write its address.
  try {
    history.replaceState(shown, "", address);
    return true;
  } catch {
    return false;
  }
}

export const isStep = (): boolean => shown.step !== undefined;
export const isUnsavedStep = (): boolean => shown.step === "unsaved";
export const canStepForth = (): boolean => shown.isUndone === true;

export function markStepSaved(): void {
  if (!isStep()) return;
  shown.step = "saved";
  replaced();
}

/** Shows another scene in this page, which is loaded again for it; `isStep` if it is the present one with a change. */
export async function showScene(scene: Scene | DrawingScene, isStep = false): Promise<void> {
  const key = `${PREFIX}${Date.now()} ${Math.random()}`;
  const name = scene.format === "cspace-drawing" ? scene.source.name : scene.name;
  keep(key, await pack(JSON.stringify(scene)), name);
  shown.isUndone = isStep;
  replaced();
  history.pushState({ opened: key, ...(isStep ? { step: "unsaved" } : {}) } satisfies Entry, "", "#");
  load();
}

function load(): void {
  leaving = true;
  location.reload();
}

function keep(key: string, packed: string, name: string): void {
  const size = `${(packed.length / 1e6).toFixed(1)} MB`;
  try {
    sessionStorage.setItem(key, packed);
  } catch {
    // Scenes that Back would lead to make room; that of the page itself needs none.
    for (const other of Object.keys(sessionStorage)) if (other.startsWith(PREFIX)) sessionStorage.removeItem(other);
    try {
      sessionStorage.setItem(key, packed);
    } catch {
      throw new Error(`${name}: this browser does not let the page keep ${size}: open it with cspace view`);
    }
  }
}

/** The scene of this entry of the history; throws what the user is to read. */
export async function shownScene(): Promise<Shown> {
  const entry = history.state as Entry | null;
  if (entry) shown = entry;
  else replaced();
  window.addEventListener("popstate", follow);
  const opened = await kept();
  return { scene: checked(opened ?? textOf("scene")), isOpened: opened !== null };
}

async function kept(): Promise<string | null> {
  try {
    const packed = shown.opened === "" ? null : sessionStorage.getItem(shown.opened);
    return packed === null ? null : await unpack(packed).text();
  } catch {
    // Some browsers keep nothing for pages from files.
    return null;
  }
}

function follow(event: PopStateEvent): void {
  const to = event.state as Entry | null;
  // An address that was typed is one of what is shown.
  if (to === null) replaced();
  else if (to.opened !== shown.opened) load();
}

function checked(text: string): Scene | DrawingScene {
  const scene = JSON.parse(text) as Scene | DrawingScene;
  const versions = { "cspace-scene": SCENE_VERSION, "cspace-drawing": DRAWING_VERSION };
  const version = versions[scene.format];
  if (version === undefined) throw new Error("What is in this page is neither a scene nor a drawing: it was not written by cspace.");
  if (scene.version !== version) throw new Error(`The scene has version ${scene.version}, and this page reads version ${version}.`);
  return scene;
}

/** What of the state is in the address, behind the #: a copied address shows the same. */

import type { Configuration } from "../kernel/api.js";
import type { Scene, View } from "../scene.js";
import type { Colouring } from "./colours.js";
import { isUsable } from "./numbers.js";
import type { State, Theme } from "./state.js";
import { UNCHANGED } from "./workshop.js";
import type { Edits, PartEdit } from "./workshop.js";

export interface Address {
  pair?: number;
  configuration?: Configuration;
  theme?: Theme;
  stop?: boolean;
  colouring?: Colouring;
  hidden?: number[];
  cut?: boolean;
  view?: View;
  /** The height that is looked at alone. */
  height?: number | null;
  /** The camera of the 3-D view: azimuth, elevation (radians), distance in sizes of the space, and what it looks at in the same. */
  camera?: number[];
  /** What is changed of the model; the kernel decides whether it can be. */
  edits?: Edits;
  /** What is wrong: the address is of another file, and nothing of it is read, or of this one as it was. */
  warning?: string;
}

/** What is as always is not in an address. */
export const USUAL = { theme: "auto", stop: true, colouring: "region", cut: false, height: null } as const satisfies Address & { theme: Theme };

/** What is large as the page is opened. */
export const usualView = ({ show }: Pick<Scene, "show">): View => show.view ?? "parts";

/** How many numbers describe a camera. */
const CAMERA_NUMBERS = 6;
/** From farther away (sizes of the space), or beside it by more, nothing would be seen. */
const FARTHEST_CAMERA = 1e3;
/** Nearer there would be no direction to look in. */
const NEAREST_CAMERA = 1e-6;

/** The name of the model's file, or of the model; and a checksum of what its answers are computed from (FNV-1a). */
export function identity({ source, name }: Pick<Scene, "source" | "name">): { file: string; sum: string } {
  let sum = 0x811c9dc5;
  for (const c of JSON.stringify(source)) sum = Math.imul(sum ^ (c.codePointAt(0) ?? 0), 0x01000193);
  return { file: source?.design?.file ?? name, sum: (sum >>> 0).toString(16) };
}

/** Reads a fragment. What it does not understand it leaves out: addresses are typed by hand. */
export function readAddress(fragment: string, scene: Scene): Address {
  const query = new URLSearchParams(fragment.replace(/^#/, ""));
  const address: Address = {};
  const { file, sum } = identity(scene);
  const of = query.get("file");
  if (of !== null && of !== file) return { warning: `This address is of ${of}: open that file for it. Here is ${file}.` };
  const set = query.getAll("set").flatMap((text) => {
    const [, name, value] = /^([^=]+)=(.+)$/.exec(text) ?? [];
    return name === undefined || value === undefined ? [] : [{ name, value }];
  });
  const parts = partsOf(query.get("parts"));
  if (set.length + parts.length > 0) {
    address.edits = { set, parts };
    if (query.get("sum") !== sum) address.warning = `${file} has changed since this address was written: the answer may be another.`;
  }
  const [fixed, moving] = [query.get("fixed"), query.get("moving")];
  const pair = scene.pairs.findIndex((p) => scene.parts[p.fixed]?.name === fixed && scene.parts[p.moving]?.name === moving);
  if (pair >= 0) address.pair = pair;
  const [x, y, theta, u, v] = ["x", "y", "theta", "u", "v"].map((key) => number(query.get(key)));
  if (x !== undefined && y !== undefined && theta !== undefined) address.configuration = { x, y, theta };
  else if (u !== undefined && v !== undefined) address.configuration = { u, v };
  const theme = query.get("theme");
  if (theme === "light" || theme === "dark") address.theme = theme;
  const stop = query.get("stop");
  if (stop === "0" || stop === "1") address.stop = stop === "1";
  const colouring = query.get("colours");
  if (colouring === "region" || colouring === "kind") address.colouring = colouring;
  const cut = query.get("cut");
  if (cut === "0" || cut === "1") address.cut = cut === "1";
  const view = query.get("view");
  if (view === "parts" || view === "slice" || view === "space") address.view = view;
  const height = number(query.get("height"));
  if (height !== undefined) address.height = height;
  const hidden = numbers(query.get("hidden"))?.filter((r) => Number.isInteger(r) && r >= 0);
  if (hidden) address.hidden = hidden;
  const camera = numbers(query.get("camera"));
  const distance = camera?.[2] ?? 0;
  if (camera?.length === CAMERA_NUMBERS && camera.every((n) => Math.abs(n) <= FARTHEST_CAMERA) && distance >= NEAREST_CAMERA) address.camera = camera;
  return address;
}

export function writeAddress(state: Readonly<State>, camera: readonly number[] | null, edits = UNCHANGED): string {
  const { file, sum } = identity(state.scene);
  const query = new URLSearchParams({ file });
  const pair = state.scene.pairs[state.pair];
  if (pair) {
    query.set("fixed", state.parts[pair.fixed]?.name ?? "");
    query.set("moving", state.parts[pair.moving]?.name ?? "");
  }
  for (const [key, value] of Object.entries(state.configuration)) query.set(key, String(value));
  if (state.theme !== USUAL.theme) query.set("theme", state.theme);
  if (state.stop !== USUAL.stop) query.set("stop", "0");
  if (state.colouring !== USUAL.colouring) query.set("colours", state.colouring);
  if (state.cut) query.set("cut", "1");
  if (state.view !== usualView(state.scene)) query.set("view", state.view);
  if (state.height !== USUAL.height) query.set("height", String(state.height));
  if (state.hidden.size > 0) query.set("hidden", [...state.hidden].join());
  if (camera) query.set("camera", camera.map((n) => Number(n.toPrecision(4))).join());
  for (const { name, value } of edits.set) query.append("set", `${name}=${value}`);
  if (edits.parts.length > 0) query.set("parts", JSON.stringify(edits.parts));
  if (edits.set.length + edits.parts.length > 0) query.set("sum", sum);
  return `#${query}`;
}

function partsOf(text: string | null): PartEdit[] {
  try {
    const parts: unknown = JSON.parse(text ?? "[]");
    return Array.isArray(parts) ? (parts as PartEdit[]) : [];
  } catch {
    return [];
  }
}

function number(text: string | null): number | undefined {
  if (text === null || text.trim() === "") return undefined;
  const value = Number(text);
  return isUsable(value) ? value : undefined;
}

function numbers(text: string | null): number[] | null {
  if (!text) return null;
  const all = text.split(",").map(number);
  return all.every((n) => n !== undefined) ? all : null;
}

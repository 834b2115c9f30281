/** Which faces are picked for which part. Nothing here is changed in place. */

import type { Place } from "../scene.js";
import type { ImportedPart } from "./scene.js";

export interface Pick {
  name: string;
  /** Indices of faces; at least one. */
  faces: readonly number[];
}

export interface Picks {
  readonly parts: readonly Pick[];
  /** The part to which faces are added; -1 where there is none. */
  readonly selected: number;
}

export const NOTHING: Picks = { parts: [], selected: -1 };

/** More parts are seldom wanted at once: every two of them are a pair. */
const MOST_IMPORTED = 12;

/** The parts that import makes, to begin with. */
export function imported(parts: readonly ImportedPart[]): Picks {
  return parts.length > MOST_IMPORTED ? NOTHING : { parts: parts.map(({ name, face }) => ({ name, faces: [face] })), selected: parts.length - 1 };
}

/** Of which part a face is; -1 if it is of none. */
export function partOf(picks: Picks, face: number): number {
  return picks.parts.findIndex((part) => part.faces.includes(face));
}

/** A face is clicked: it becomes a part, or its part is selected. */
export function clicked(picks: Picks, face: number): Picks {
  const part = partOf(picks, face);
  if (part >= 0) return { ...picks, selected: part };
  return { parts: [...picks.parts, { name: freeName(picks), faces: [face] }], selected: picks.parts.length };
}

/** A face is clicked with Shift: it joins the selected part, or leaves its own. */
export function joined(picks: Picks, face: number): Picks {
  const part = partOf(picks, face);
  if (part >= 0) {
    const faces = picks.parts[part]?.faces.filter((f) => f !== face) ?? [];
    return faces.length === 0 ? removed(picks, part) : replaced({ ...picks, selected: part }, part, { faces });
  }
  const selected = picks.parts[picks.selected];
  return selected ? replaced(picks, picks.selected, { faces: [...selected.faces, face] }) : clicked(picks, face);
}

export function renamed(picks: Picks, part: number, name: string): Picks {
  return replaced(picks, part, { name });
}

export function removed(picks: Picks, part: number): Picks {
  const parts = picks.parts.filter((_, i) => i !== part);
  return { parts, selected: Math.min(picks.selected > part ? picks.selected - 1 : picks.selected, parts.length - 1) };
}

function replaced(picks: Picks, part: number, by: Partial<Pick>): Picks {
  return { ...picks, parts: picks.parts.map((p, i) => (i === part ? { ...p, ...by } : p)) };
}

/** The first of `part 1`, `part 2` … that no part has. */
function freeName(picks: Picks): string {
  for (let n = picks.parts.length + 1; ; n += 1) {
    const name = `part ${n}`;
    if (!picks.parts.some((p) => p.name === name)) return name;
  }
}

/** What is wrong with the names, null if nothing is. */
export function wrongName(picks: Picks): string | null {
  const names = picks.parts.map((p) => p.name.trim());
  if (names.includes("")) return "Give every part a name.";
  const twice = names.find((name, i) => names.indexOf(name) !== i);
  return twice === undefined ? null : `Two parts have the name ${twice}: give one another.`;
}

/** The parts as the kernel takes them. */
export function request(picks: Picks, inside: readonly Place[]): { name: string; at: Place[] }[] {
  return picks.parts.map(({ name, faces }) => ({ name: name.trim(), at: faces.flatMap((f) => inside[f] ?? []) }));
}

const text = (p: Place) => `${p.x},${p.y}`;

/** The options of the command that pick the same. */
export function options(picks: Picks, inside: readonly Place[]): string {
  return request(picks, inside)
    .map(({ name, at }) => `--pick ${quoted(`${name}=${at.map(text).join(";")}`)}`)
    .join(" ");
}

function quoted(word: string): string {
  return `'${word.replaceAll("'", "'\\''")}'`;
}

/** The fragment of an address without picks: in an empty one those of import are. */
const NO_PICKS = "none";

/** The fragment of the page's address that has the picks. */
export function fragment(picks: Picks, inside: readonly Place[]): string {
  if (picks.parts.length === 0) return NO_PICKS;
  return new URLSearchParams(request(picks, inside).map(({ name, at }) => [name, at.map(text).join(";")])).toString();
}

/** The picks of a fragment; points that are no face's are left out. */
export function fromFragment(fragment: string, inside: readonly Place[]): Picks {
  const index = new Map(inside.map((p, i) => [text(p), i]));
  const taken = new Set<number>();
  const parts = [...new URLSearchParams(fragment.replace(/^#/, ""))].flatMap(([name, points]): Pick[] => {
    const faces = points.split(";").flatMap((p) => index.get(p) ?? []).filter((f) => !taken.has(f));
    faces.forEach((f) => taken.add(f));
    return faces.length > 0 ? [{ name, faces }] : [];
  });
  return { parts, selected: parts.length - 1 };
}

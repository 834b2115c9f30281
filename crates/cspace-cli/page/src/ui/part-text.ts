/** Parts in the text of a model: TOML in which they are added, renamed and removed, while all else stays as it is written. */

import type { Place, SceneMotion } from "../scene.js";
import { isUsable } from "./numbers.js";

/** Outlines about their own origin: dimensions, each with what it is, and loops of the names that these have in the model. */
export const SHAPES = {
  rectangle: {
    sizes: { width: "of the rectangle", height: "of the rectangle" },
    loops: (w, h) => `[["-${w}/2", "-${h}/2"], ["${w}/2", "-${h}/2"], ["${w}/2", "${h}/2"], ["-${w}/2", "${h}/2"]]`,
  },
  circle: { sizes: { radius: "of the circle" }, loops: (r) => `{ circle = "${r}", at = [0, 0] }` },
  slot: {
    sizes: { length: "of the slot, between the centres of its ends", width: "of the slot" },
    loops: (l, w) =>
      `[["-${l}/2", "-${w}/2"], ["${l}/2", "-${w}/2"], { arc_to = ["${l}/2", "${w}/2"], radius = "${w}/2" }, ` +
      `["-${l}/2", "${w}/2"], { arc_to = ["-${l}/2", "-${w}/2"], radius = "${w}/2" }]`,
  },
  polygon: {
    sizes: { sides: "of the polygon", radius: "of the polygon, to its corners" },
    loops: (n, r) => `[{ repeat = "${n}", about = [0, 0], path = [["${r}", 0]] }]`,
  },
} as const satisfies Record<string, { sizes: Record<string, string>; loops: (...names: [string, string]) => string }>;

export type Shape = keyof typeof SHAPES;

/** A polygon has so many sides. */
const SIDES: readonly [number, number] = [3, 1000];

export interface NewPart {
  name: string;
  shape: Shape;
  /** The dimensions, in the order of the shape (model unit). */
  sizes: readonly number[];
  /** Where the origin of the outline is. */
  at: Place;
  motion: SceneMotion;
}

/** What is wrong with a part for a model that has these names; null if nothing is. */
export function wrongPart({ name, shape, sizes, at, motion }: NewPart, names: readonly string[]): string | null {
  for (const [i, what] of Object.keys(SHAPES[shape].sizes).entries()) {
    const size = sizes[i];
    if (!isUsable(size) || size <= 0) return `${what}: type a number greater than 0.`;
    if (what === "sides" && !(Number.isInteger(size) && SIDES[0] <= size && size <= SIDES[1])) return `sides: type a whole number from ${SIDES[0]} to ${SIDES[1]}.`;
  }
  const places = [at, ...(motion.type === "revolute" ? [motion.center] : motion.type === "prismatic" ? [motion.direction] : [])];
  if (!places.every((p) => isUsable(p.x) && isUsable(p.y))) return "Type a number for x and for y.";
  if (motion.type === "prismatic" && motion.direction.x === 0 && motion.direction.y === 0) return "The part slides along a direction: x and y are not both 0.";
  return wrongPartName(name, names);
}

export function wrongPartName(name: string, names: readonly string[]): string | null {
  if (name.trim() === "") return "Give the part a name.";
  return names.includes(name.trim()) ? `There is a part with the name ${name.trim()}: choose another.` : null;
}

/** The text with a part at its end. Dimensions become parameters; a model that lists its pairs has those of the new part with all others. */
export function withPart(text: string, { name, shape, sizes, at, motion }: NewPart): string {
  const blocks = blocksOf(text);
  const dimensions = Object.entries(SHAPES[shape].sizes);
  let n = 1;
  while (dimensions.some(([what]) => isUsed(`${what}_${n}`, text))) n += 1;
  const [first = "", second = ""] = dimensions.map(([what]) => `${what}_${n}`);
  const added = dimensions.map(([what, of], i) => `${what}_${n} = ${sizes[i]} # ${of}`);
  let parameters = blocks.find((b) => b.key === "parameter");
  if (!parameters) {
    parameters = { key: "parameter", lines: ["[parameter]", ""] };
    blocks.splice(1, 0, parameters);
    if (blocks[0]?.lines.at(-1)?.trim()) blocks[0].lines.push("");
  }
  const end = parameters.lines.join("\n").trimEnd().split("\n").length;
  parameters.lines.splice(end, 0, ...added);
  const pair = onlyPair(blocks);
  if (pair) for (const { lines } of blocks.filter(isOfOnlyPair)) lines.splice(lines.findIndex((l) => HEADER.test(l)) + 1, 0, `pair = [${pair.map(quoted).join(", ")}]`);
  const others = blocks.some((b) => b.key === "pair") ? blocks.flatMap((b) => nameOf(b) ?? []) : [];
  const part = ["[[part]]", `name = ${quoted(name.trim())}`, ...motionOf(motion), `place = { at = ${pointOf(at)} }`, `loops = [${SHAPES[shape].loops(first, second)}]`];
  const pairs = others.map((other) => ["", "[[pair]]", `fixed = ${quoted(other)}`, `moving = ${quoted(name.trim())}`].join("\n"));
  return `${textOf(blocks).trimEnd()}\n\n${[...part, ...pairs].join("\n")}\n`;
}

/** The text without a part, and without what names it: pairs, joints, drives, loads, springs, requirements, and parameters that nothing else uses. */
export function withoutPart(text: string, name: string): string {
  const [head, ...blocks] = blocksOf(text);
  const isOfIt = onlyPair(blocks)?.includes(name) ? isOfOnlyPair : () => false;
  const isGone = (b: Block) => nameOf(b) === name || (b.key !== "part" && namesIn(b).includes(name)) || isOfIt(b);
  const left = blocks.filter((b) => !isGone(b));
  const gone = textOf(blocks.filter(isGone));
  if (head && namesIn(head).includes(name)) head.lines = [head.lines.join("\n").replace(/,\s*pair\s*=\s*\[[^\]]*\]|pair\s*=\s*\[[^\]]*\]\s*,?\s*/, "")];
  const kept = head ? [head, ...left] : left;
  for (const block of kept.filter((b) => b.key === "parameter")) {
    block.lines = block.lines.filter((line) => {
      const of = /^\s*(\w+)\s*=/.exec(line)?.[1];
      return of === undefined || !isUsed(of, gone) || isUsed(of, textOf(kept).replace(line, ""));
    });
  }
  return textOf(kept);
}

/** The text with another name of a part, wherever the part is named. */
export function withName(text: string, from: string, to: string): string {
  const blocks = blocksOf(text);
  for (const block of blocks) {
    const isPart = nameOf(block) === from;
    const renamed = (said: string) => said.replace(STRING, (string) => (valueOf(string) === from ? quoted(to.trim()) : string));
    block.lines = [block.lines.join("\n").replace(isPart ? NAME : NAMED, renamed)];
  }
  return textOf(blocks);
}

/** A table with its lines, after comments right above it; the first has what is above all tables. */
interface Block {
  key: string;
  lines: string[];
}

const HEADER = /^\s*\[{1,2}([A-Za-z_][\w.-]*)\]{1,2}\s*(?:#.*)?$/;
const STRING = /"(?:[^"\\]|\\.)*"|'[^']*'/g;
const NAME = /^\s*name\s*=\s*("(?:[^"\\]|\\.)*"|'[^']*')/m;
/** The keys whose values are names of parts. */
const NAMED = /\b(?:part|parts|pair|fixed|moving|by)\s*=\s*(?:\[[^\]]*\]|"(?:[^"\\]|\\.)*"|'[^']*')/g;

function blocksOf(text: string): Block[] {
  let last: Block = { key: "", lines: [] };
  const blocks = [last];
  for (const line of text.split("\n")) {
    const key = HEADER.exec(line)?.[1];
    // A table within a table is of it.
    if (key === undefined || key.startsWith(`${last.key}.`)) {
      last.lines.push(line);
      continue;
    }
    let from = last.lines.length;
    while (from > 0 && /^\s*#/.test(last.lines[from - 1] ?? "")) from -= 1;
    // What stands at the top of the file is of the file.
    const comments = from === 0 ? [] : last.lines.splice(from);
    last = { key, lines: [...comments, line] };
    blocks.push(last);
  }
  return blocks;
}

const textOf = (blocks: readonly Block[]): string => blocks.flatMap((b) => b.lines).join("\n");

/** The name of the part that a block is. */
function nameOf({ key, lines }: Block): string | null {
  const string = key === "part" ? NAME.exec(lines.join("\n"))?.[1] : undefined;
  return string === undefined ? null : valueOf(string);
}

const namesIn = ({ lines }: Block): string[] => (lines.join("\n").match(NAMED) ?? []).flatMap((said) => (said.match(STRING) ?? []).map(valueOf));

/** The names of the pair that need not be named, since it is the only one. */
function onlyPair(blocks: readonly Block[]): string[] | null {
  const listed = blocks.filter((b) => b.key === "pair");
  const names = listed.length > 0 ? listed.flatMap(namesIn) : blocks.flatMap((b) => nameOf(b) ?? []);
  return names.length === 2 ? names : null;
}

const isOfOnlyPair = (b: Block): boolean => b.key === "requirement" && namesIn(b).length === 0;

/** What a string of TOML says; of one with escapes that JSON does not know, its text as it stands. */
function valueOf(string: string): string {
  try {
    return string.startsWith("'") ? string.slice(1, -1) : (JSON.parse(string) as string);
  } catch {
    return string.slice(1, -1);
  }
}

/** A string of TOML: that of JSON, but for one character. */
const quoted = (text: string): string => JSON.stringify(text).replaceAll("\u007f", "\\u007f");

const isUsed = (name: string, text: string): boolean => new RegExp(`\\b${name}\\b`).test(text);

const pointOf = ({ x, y }: Place): string => `[${x}, ${y}]`;

function motionOf(motion: SceneMotion): string[] {
  switch (motion.type) {
    case "planar":
      return [];
    case "fixed":
      return [`motion = { type = "fixed" }`];
    case "revolute":
      return [`motion = { type = "revolute", center = ${pointOf(motion.center)} }`];
    case "prismatic":
      return [`motion = { type = "prismatic", direction = ${pointOf(motion.direction)} }`];
  }
}

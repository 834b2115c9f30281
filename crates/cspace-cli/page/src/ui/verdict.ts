/** What the configuration means, in words: whether the moving part can leave, and how much play it has. */

import type { AxisInfo, Kernel } from "../kernel/api.js";
import type { ScenePair, SceneRange } from "../scene.js";
import { degrees, length, rounded as shown } from "./numbers.js";
import { widthOf, type Way } from "./play.js";
import { TURN } from "./placement.js";
import { heldOneWay, type Pushes } from "./pushes.js";
import type { Where } from "./state.js";

export interface Told {
  pair: Pick<ScenePair, "class" | "regions" | "resolution">;
  kernel: Pick<Kernel, "patch">;
  where: Where;
  /** Names of the pair's parts. */
  fixed: string;
  moving: string;
  /** What u and v are, of a pair on fixed axes. */
  axes: [AxisInfo, AxisInfo] | null;
  /** What becomes of both where they are pushed, once it is known. */
  pushes: { u: Pushes; v: Pushes } | null;
  /** Names that the model gives to what encloses the region. */
  cage: readonly string[];
  /** Whether the model has other parts, which are left out of account. */
  others: boolean;
  /** Whether others are pushed all the same. */
  whole: boolean;
  /** Whether the parts are shown elsewhere than they are drawn, where they overlap. */
  displaced: boolean;
  unit: string | null;
}

/** The region that a configuration is in or, in contact, at the edge of. */
export function regionOf({ where, kernel }: { where: Where; kernel: Pick<Kernel, "patch"> | null }): number | null {
  if (where.region !== null) return where.region;
  const [patch] = where.patches;
  return patch === undefined || !kernel ? null : kernel.patch(patch).region;
}

/** The pocket that the selected pair is in, or at the edge of. */
export function cagedIn(of: { state: { where: Where }; kernel: Pick<Kernel, "patch"> | null; pair: Pick<ScenePair, "class" | "regions"> | undefined }): number | null {
  const { state, kernel, pair } = of;
  const region = regionOf({ where: state.where, kernel });
  return region === null || !pair || pair.class === "fixed-axes" || pair.regions[region]?.unbounded ? null : region;
}

/** What the verdict comes to; null where nothing is known. */
export function standing(told: Told): "caged" | "leaves" | "overlap" | "one-way" | "moves" | null {
  if (told.where.classification === "blocked") return told.where.fits ? null : "overlap";
  const region = regionOf(told);
  if (region === null) return null;
  if (told.pair.class === "fixed-axes") return heldOneWay(told.pushes?.u ?? null) || heldOneWay(told.pushes?.v ?? null) ? "one-way" : "moves";
  return told.pair.regions[region]?.unbounded ? "leaves" : "caged";
}

/** The verdict, in a sentence. */
export function headline(told: Told): string {
  const { pair, where, fixed, moving } = told;
  if (where.fits) return `${moving} fits ${fixed} without play.`;
  if (where.classification === "blocked") return `${moving} and ${fixed} overlap: real parts cannot be there.`;
  if (where.classification === null) return "This is outside of what was computed.";
  const region = regionOf(told);
  const touches = where.classification === "contact";
  if (pair.class === "fixed-axes") return region === null ? (touches ? `${moving} touches ${fixed}.` : `${moving} is free.`) : onAxes(told, region);
  if (region === null) return touches ? `${moving} touches ${fixed}.` : `${moving} is free.`;
  if (pair.regions[region]?.unbounded) {
    const alone = told.others ? ", the other parts left aside" : "";
    return `${moving} can leave${alone}${touches ? `: it touches ${fixed}, and is not caged` : ""}.`;
  }
  const named = [...told.cage.slice(0, LISTED), ...(told.cage.length > LISTED ? ["others"] : [])];
  const list = named.length > 1 ? `${named.slice(0, -1).join(", ")} and ${named.at(-1)}` : named[0];
  return `${moving} cannot leave: caged by ${list === undefined ? fixed : `${list} of ${fixed}`}.`;
}

/** So many features of a cage are named. */
const LISTED = 3;

/** A range is that of the axis, as a share, but for rounding. */
const SAME = 1e-9;

/** Where the two parts can go on their axes. */
function onAxes({ pair, fixed, moving, axes, pushes, unit }: Told, region: number): string {
  const ranges = pair.regions[region]?.ranges;
  if (!ranges || !axes) return `${moving} and ${fixed} have room to move.`;
  const oneWay = ([["u", fixed, moving], ["v", moving, fixed]] as const).flatMap(([coordinate, name, other]) => {
    const held = heldOneWay(pushes?.[coordinate] ?? null);
    if (!held) return [];
    const [met, gone] = [held.push.met, held.push.gone].map((angle) => degrees(angle, DIGITS));
    return [`${name} turns one way only: ${held.way} it meets ${other} after ${met}, and is held${met === gone ? "" : ` after ${gone}`}.`];
  });
  if (oneWay[0] !== undefined) return oneWay[0];
  if (ranges[0].around && ranges[1].around) return together(fixed, moving, pushes);
  const goes = (axis: AxisInfo, { lo, hi, open, around }: SceneRange) => {
    if (axis.kind === "still") return null;
    if (around) return "turns for ever";
    const how = axis.kind === "angle" ? "turns" : "slides";
    if (open[0] && open[1]) return `${how} without limit`;
    if (open[0] || open[1]) return `${how} without limit one way`;
    const isOwn = !axis.round && hi - lo >= (axis.hi - axis.lo) * (1 - SAME);
    return `${how} by ${axis.kind === "angle" ? degrees(hi - lo, DIGITS) : length(shown(hi - lo, DIGITS), unit)}${isOwn ? " (its own limits)" : ""}`;
  };
  const all = [fixed, moving].flatMap((name, i) => {
    const [axis, range] = [axes[i], ranges[i]];
    const way = axis && range && goes(axis, range);
    return way ? [`${name} ${way}`] : [];
  });
  return `${all.join(", ")}.`;
}

/** Of two parts that both turn for ever: which of them takes the other along, and which is held. */
function together(fixed: string, moving: string, pushes: Told["pushes"]): string {
  const goes = (of: Pushes | undefined) => (of ? of.back.gone === Infinity && of.forth.gone === Infinity : null);
  const [u, v] = [goes(pushes?.u), goes(pushes?.v)];
  const drives = (driver: string, driven: string, held: Pushes) =>
    `${driver} turns for ever and takes ${driven} along; pushed itself, ${driven} is held after ${degrees((held?.back.gone ?? 0) + (held?.forth.gone ?? 0), DIGITS)} of play.`;
  if (u === true && v === false) return drives(fixed, moving, pushes?.v ?? null);
  if (u === false && v === true) return drives(moving, fixed, pushes?.u ?? null);
  return `${fixed} and ${moving} turn together for ever.`;
}

/** How far it can go from here along each coordinate alone, and how far the parts are apart. */
export function details(told: Told, play: readonly Way[]): string[] {
  const { pair, where, fixed, moving, unit } = told;
  if (where.classification !== "free" && where.classification !== "contact") return [];
  const axes = pair.class === "fixed-axes";
  const region = regionOf(told);
  const lines: string[] = [];
  if (where.nearest && where.classification === "free") lines.push(`${length(shown(where.nearest.distance), unit)} apart.`);
  if (axes && where.classification === "contact") lines.push("They touch.");
  if (axes) {
    for (const way of play) lines.push(`${way.coordinate === "u" ? moving : fixed} held, ${way.coordinate === "u" ? fixed : moving} ${moves(way, unit)}.`);
  } else if (region !== null && !pair.regions[region]?.unbounded) {
    const [turn] = play.filter((w) => w.coordinate === "theta");
    const slides = play.filter((w) => w.coordinate !== "theta").map((w) => `${rounded(w, unit)} along ${w.coordinate}`);
    lines.push(`Play from here: ${slides.join(", ")}${turn ? `; without shifting it ${moves(turn, unit)}` : ""}.`);
  }
  if (told.displaced) lines.push("As they are drawn they overlap: they are shown where they do not.");
  if (told.others && !told.whole) lines.push("Only these two parts count here: the others are left out.");
  return lines;
}

function moves(way: Way, unit: string | null): string {
  if (way.kind === "length") return Number.isFinite(widthOf(way)) ? `slides by ${rounded(way, unit)}` : "slides freely";
  if (!Number.isFinite(widthOf(way)) || widthOf(way) >= TURN) return "turns all the way round";
  const by = rounded(way, unit);
  return by === degrees(0) ? "cannot turn" : `turns by ${by}`;
}

/** As many digits of play are told. */
const DIGITS = 3;

function rounded(way: Way, unit: string | null): string {
  const value = widthOf(way);
  if (!Number.isFinite(value)) return "any length";
  return way.kind === "angle" ? degrees(value, DIGITS) : length(shown(value, DIGITS), unit);
}

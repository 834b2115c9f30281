/** What the configuration means, in words: whether the moving part can leave, and how much play it has. */

import type { Kernel } from "../kernel/api.js";
import type { ScenePair } from "../scene.js";
import { degrees, length, rounded as shown } from "./numbers.js";
import { widthOf } from "./play.js";
import type { Way } from "./play.js";
import { TURN } from "./placement.js";
import { regionName } from "./region-names.js";
import type { Where } from "./state.js";

export interface Told {
  pair: Pick<ScenePair, "class" | "regions" | "resolution">;
  kernel: Pick<Kernel, "patch">;
  where: Where;
  /** Names of the pair's parts. */
  fixed: string;
  moving: string;
  unit: string | null;
}

/** The region that a configuration is in or, in contact, at the edge of. */
export function regionOf({ where, kernel }: { where: Where; kernel: Pick<Kernel, "patch"> | null }): number | null {
  if (where.region !== null) return where.region;
  const [patch] = where.patches;
  return patch === undefined || !kernel ? null : kernel.patch(patch).region;
}

/** The verdict, in a sentence. */
export function headline(told: Told): string {
  const { pair, where, fixed, moving } = told;
  if (where.classification === "blocked") return `${moving} and ${fixed} overlap: real parts cannot be there.`;
  if (where.classification === null) return "This is outside of what was computed.";
  const region = regionOf(told);
  const touches = where.classification === "contact";
  const apart = where.nearest ? `${length(shown(where.nearest.distance), told.unit)} apart` : "apart";
  if (pair.class === "fixed-axes") return touches ? `${moving} touches ${fixed}.` : `${moving} and ${fixed} are ${apart}.`;
  if (region === null) return touches ? `${moving} touches ${fixed}.` : `${moving} is free.`;
  const name = regionName(pair, region);
  if (pair.regions[region]?.unbounded) return touches ? `${moving} touches ${fixed} from ${name}: it can leave.` : `${moving} is ${name}: it can leave.`;
  return touches ? `${moving} touches ${fixed}, caged in ${name}: it cannot leave.` : `${moving} is caged in ${name}: it cannot leave.`;
}

/** How far it can go from here along each coordinate alone, and how far the parts are apart. */
export function details(told: Told, play: readonly Way[]): string[] {
  const { pair, where, fixed, moving, unit } = told;
  if (where.classification !== "free" && where.classification !== "contact") return [];
  const axes = pair.class === "fixed-axes";
  const region = regionOf(told);
  const lines: string[] = [];
  if (where.nearest && where.classification === "free" && !axes) lines.push(`${length(shown(where.nearest.distance), unit)} apart.`);
  if (axes) {
    for (const way of play) lines.push(`${way.coordinate === "u" ? moving : fixed} held, ${way.coordinate === "u" ? fixed : moving} ${moves(way, unit)}.`);
  } else if (region !== null && !pair.regions[region]?.unbounded) {
    const [turn] = play.filter((w) => w.coordinate === "theta");
    const slides = play.filter((w) => w.coordinate !== "theta").map((w) => `${rounded(w, unit)} along ${w.coordinate}`);
    lines.push(`Play from here: ${slides.join(", ")}${turn ? `; it ${moves(turn, unit)}` : ""}.`);
  }
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

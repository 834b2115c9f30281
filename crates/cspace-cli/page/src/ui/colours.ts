/** Colours that the colour-blind tell apart (Okabe and Ito). Vermilion is kept for what touches. */

import type { PatchKind } from "../kernel/api.js";

const REGIONS = ["#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#0072b2"] as const;

export const NO_REGION = "#999999";

export const TOUCHING = "#d55e00";

export const KINDS: Record<PatchKind, string> = {
  "line-vertex": "#56b4e9",
  "line-arc": "#009e73",
  "arc-vertex": "#e69f00",
  "arc-arc": "#cc79a7",
};

export const KIND_NAMES: Record<PatchKind, string> = {
  "line-vertex": "line and vertex",
  "line-arc": "line and arc",
  "arc-vertex": "arc and vertex",
  "arc-arc": "arc and arc",
};

export type Colouring = "region" | "kind";

/** Further regions have the same colours mixed with black or white, by so much: the lightness tells them apart, whoever looks. */
const SHADES = [{ with: 0, share: 0 }, { with: 0, share: 0.45 }, { with: 255, share: 0.55 }] as const;

export function regionColour(region: number | null): string {
  if (region === null) return NO_REGION;
  const colour = REGIONS[region % REGIONS.length] ?? NO_REGION;
  const shade = SHADES[Math.floor(region / REGIONS.length) % SHADES.length];
  if (!shade || shade.share === 0) return colour;
  const mixed = channels(colour).map((c) => Math.round(c + shade.share * (shade.with - c)));
  return `#${mixed.map((c) => c.toString(16).padStart(2, "0")).join("")}`;
}

export function patchColour(colouring: Colouring, patch: { region: number | null; kind: PatchKind }): string {
  return colouring === "kind" ? KINDS[patch.kind] : regionColour(patch.region);
}

/** Red, green and blue, 0 to 255. */
export function channels(colour: string): [number, number, number] {
  const n = Number.parseInt(colour.slice(1), 16);
  return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
}

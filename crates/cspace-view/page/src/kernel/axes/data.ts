/** The fields of a saved fixed-axes space that the kernel reads; `docs/fixed-axes-space.schema.json` describes them. */

import type { Frame, Place } from "../../scene.js";
import type { FeatureKey, SavedPart } from "../features.js";

export type MotionData = "Still" | { Turn: { center: Place } } | { Slide: { direction: Place } };

export interface LineCarrier {
  normal: Place;
  through: Place;
  point: Place;
  radius: number;
}

/** A circle by a point of it, the outward normal there, and its weight and size; see `cycle.ts`. */
export interface Cycle {
  through: Place;
  normal: Place;
  weight: number;
  size: number;
}

export type CarriersData =
  | { FirstLine: LineCarrier }
  | { SecondLine: LineCarrier }
  | { Circles: { first: Place; second: Place; radius: number } }
  | { Cycles: { first: Cycle; second: Cycle } };

export interface ExtentData {
  lo: number;
  hi: number;
  kind: "Circle" | "TurnLimits" | "SlideLimits" | "Open";
}

export interface EndData {
  x: number;
  base: number;
  turns: number;
}

export interface PieceData {
  pair: number;
  root: number;
  vertical: boolean;
  turns: number;
  start: EndData;
  end: EndData;
}

export interface CellData {
  piece: number;
  from: number;
  to: number;
}

export interface GapData {
  lower: number | null;
  upper: number | null;
  turns: [number, number];
  region: number;
}

export interface BandData {
  lo: number;
  hi: number;
  gaps: { start: number; end: number };
}

export interface AxisData {
  motion:
    | { type: "fixed" }
    | { type: "revolute"; center: Place }
    | { type: "prismatic"; direction: Place };
  range: [number, number] | null;
}

export interface AxesPatchData {
  fixed: FeatureKey;
  moving: FeatureKey;
  branches: { start: number; end: number };
  region: number | null;
}

export interface AxesSpaceData {
  fixed: SavedPart;
  moving: SavedPart;
  fixed_axis: AxisData;
  moving_axis: AxisData;
  patches: AxesPatchData[];
  branches: { patch: number; form: "v-of-u" | "u-of-v"; start: [number, number]; end: [number, number]; cell: number }[];
  free_regions: unknown[];
  statistics: { conflicts: number };
  map: { frame: Frame; swapped: boolean; x_unit: number; y_unit: number };
  motions: { first: MotionData; second: MotionData };
  x: ExtentData;
  y: ExtentData;
  pairs: [number, number, CarriersData][];
  pieces: PieceData[];
  cells: CellData[];
  bands: BandData[];
  gaps: GapData[];
}

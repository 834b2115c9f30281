/** Where the lines of a grid are, what is written at them, and how far a plane may be zoomed. */

import type { Place } from "../scene.js";
import { lengthStep, minus, rounded, short } from "./numbers.js";

/** A grid or an axis has no more lines than this, whatever is asked. */
const MOST_LINES = 1000;
/** Digits that {@link short} keeps. */
const USUAL_DIGITS = 6;
/** A number of more characters is written with an exponent. */
const LONGEST_NUMBER = 14;
/** The logarithm of a step that is a power of ten may come out less than whole by this. */
const LOGARITHM_ROUNDING = 1e-9;

/** What is drawn by hand goes in steps of at least so many pixels. */
const SNAP_PIXELS = 4;
/** Digits of what is snapped: less is the rounding of a step that is no power of 2. */
const SNAP_DIGITS = 12;

/** The step of what is drawn by hand at the zoom of a plane (its unit). */
export function gridStep({ pixel }: { pixel: Place }): number {
  return lengthStep(SNAP_PIXELS * pixel.x);
}

/** The nearest place whose coordinates are whole steps. */
export function snapped({ x, y }: Place, step: number): Place {
  const [a = x, b = y] = [x, y].map((v) => rounded(Math.round(v / step) * step, SNAP_DIGITS) || 0);
  return { x: a, y: b };
}

/** Numbers of the steps that lie between two values, and beside each its value. */
export function gridLines(lo: number, hi: number, step: number): { index: number; value: number }[] {
  const first = Math.ceil(lo / step);
  const count = Math.min(MOST_LINES, Math.floor(hi / step) - first + 1);
  if (!Number.isSafeInteger(first) || !(count > 0)) return [];
  return Array.from({ length: count }, (_, i) => ({ index: first + i, value: (first + i) * step }));
}

/** A number at a grid line, with as many digits as tell it from the next. */
export function lineText(value: number, step: number): string {
  if (value === 0 || !Number.isFinite(value)) return short(value);
  const place = (x: number) => Math.floor(Math.log10(Math.abs(x)) + LOGARITHM_ROUNDING);
  const digits = place(value) - place(step) + 1;
  if (digits <= USUAL_DIGITS) return short(value);
  const decimals = Math.max(0, -place(step));
  const plain = decimals <= LONGEST_NUMBER ? value.toFixed(decimals) : "";
  return minus(plain !== "" && plain.length <= LONGEST_NUMBER ? plain : value.toExponential(Math.min(digits, 16) - 1));
}

/** A pixel is at least this share of what was shown whole. */
const FINEST = 1e-9;
/** A pixel is at most so many times what was shown whole. */
const COARSEST = 1e6;
/** A pixel is at least so many roundings of the coordinates at the centre, or drawings would be steps. */
const ROUNDINGS = 64;

/** Pixels per unit, brought between the least and the most that an axis is shown with. */
export function heldScale(scale: number, fitted: number, center: number): number {
  const finest = Math.max(FINEST * fitted, ROUNDINGS * Number.EPSILON * Math.abs(center));
  const coarsest = Math.max(COARSEST * fitted, finest);
  return Math.min(1 / finest, Math.max(1 / coarsest, scale));
}
